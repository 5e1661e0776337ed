suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        body dot: p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

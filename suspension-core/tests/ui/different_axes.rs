suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z - a.y;
    }
}

fn main() {}

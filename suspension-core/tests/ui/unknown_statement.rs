suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        rod first: a -> p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

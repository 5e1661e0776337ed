suspension_core::linkage! {
    mod m {
        fixed: a;
        #[cfg(unix)]
        free: p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

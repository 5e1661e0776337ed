suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link size: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

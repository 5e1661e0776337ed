suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive z: p.z;
        drive lift: p.z;
    }
}

fn main() {}

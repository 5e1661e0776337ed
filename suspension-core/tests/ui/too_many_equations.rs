suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p;
        link rod: a -> p;
        link stay: b -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

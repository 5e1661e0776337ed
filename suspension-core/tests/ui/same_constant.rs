suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p, q, r;
        link ß: a -> p;
        link ss: b -> q;
        drive z: p.z;
    }
}

fn main() {}

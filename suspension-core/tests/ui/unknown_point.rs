suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: b -> p;
        body bar: p, q;
        drive z: r.z;
        kingpin: s -> p;
    }
}

fn main() {}

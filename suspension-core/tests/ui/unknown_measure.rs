suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure reach: distance(a -> p);
    }
}

fn main() {}

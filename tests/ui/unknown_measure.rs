suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure reach: distance(a -> p);
        measure turn: angle(a -> p, z, x);
    }
}

fn main() {}

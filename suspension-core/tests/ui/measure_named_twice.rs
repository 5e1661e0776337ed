suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure p: p.x;
        measure z: p.z;
    }
}

fn main() {}

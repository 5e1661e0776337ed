suspension_core::linkage! {
    mod m {
        fixed: ;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

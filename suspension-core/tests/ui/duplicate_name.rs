suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link a: a -> p;
        drive P: p.y;
        drive z: p.z;
    }
}

fn main() {}

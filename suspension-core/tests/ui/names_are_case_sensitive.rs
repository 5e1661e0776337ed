suspension_core::linkage! {
    mod m {
        fixed: Fa;
        free: p;
        link rod: fa -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q;
        body bar: p, q;
        wheel: p -> q;
        drive z: p.z;
    }
}

fn main() {}

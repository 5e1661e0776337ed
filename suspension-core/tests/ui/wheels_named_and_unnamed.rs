suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel left: p -> q;
        wheel: p -> r;
        drive z: p.z;
    }
}

fn main() {}

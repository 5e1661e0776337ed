suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel left: p -> q;
        wheel left: p -> r;
        kingpin left: p -> q;
        kingpin left: p -> r;
        drive z: p.z;
    }
}

fn main() {}

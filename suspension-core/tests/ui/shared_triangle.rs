suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r, s;
        body plate: p, q, r;
        body other: q, r, p, s;
        drive z: p.z;
    }
}

fn main() {}

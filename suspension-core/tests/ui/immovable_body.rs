suspension_core::linkage! {
    mod m {
        fixed: a, b, c;
        free: p;
        body plate: a, b, c, p;
        drive z: p.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p, q;
        link one: a -> p;
        link two: b -> p;
        link three: b -> q;
        link four: p -> q;
        drive up: p.z - q.z;
        drive down: q.z - p.z;
    }
}

fn main() {}

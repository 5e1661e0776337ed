suspension_core::linkage! {
    mod m {
        fixed: a, b, c;
        free: p, q, r;
        hinge arm: a, p -> q, c;
        hinge short: a -> p;
        hinge lost: a, b -> s;
        hinge both: a, b, p -> q;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod twice {
        fixed: a, b;
        free: p, q;
        hinge arm: a, b -> p, q;
        link rod: a -> p;
        body other: b, p, q;
        drive slide: b.x;
        drive z: p.z;
    }
}

fn main() {}

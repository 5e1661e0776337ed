suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p, q, r, s;
        body plate: p, q, r, s;
        link plate_s: a -> p;
        link second: b -> q;
        drive y: p.y;
        drive z: p.z;
        drive lift: q.z;
        drive turn: r.z;
    }
}

suspension_core::linkage! {
    mod of_factors {
        fixed: a, b;
        free: p, squared, q, sign;
        body growth: a, b, p, squared;
        body determinant: a, b, q, sign;
        drive lift: p.z;
        drive fold: q.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod duplicate_name {
        fixed: a;
        free: p;
        link a: a -> p;
        drive P: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod keyword {
        fixed: box;
        free: p;
        link self: box -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod reserved_name {
        fixed: a;
        free: p;
        link size: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod generated_name {
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
    mod generated_name_of_factors {
        fixed: a, b;
        free: p, squared, q, sign;
        body growth: a, b, p, squared;
        body determinant: a, b, q, sign;
        drive lift: p.z;
        drive fold: q.z;
    }
}

suspension_core::linkage! {
    mod name_of_a_pattern {
        fixed: a;
        free: None, Listing;
        link rod: a -> None;
        link second: a -> Listing;
        drive y: None.y;
        drive z: None.z;
    }
}

suspension_core::linkage! {
    mod names_are_case_sensitive {
        fixed: Fa;
        free: p;
        link rod: fa -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod same_constant {
        fixed: a, b;
        free: p, q, r;
        link ß: a -> p;
        link ss: b -> q;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod unknown_point {
        fixed: a;
        free: p;
        link rod: b -> p;
        body bar: p, q;
        drive z: r.z;
        kingpin: s -> p;
    }
}

suspension_core::linkage! {
    mod unused_chassis_point {
        fixed: a, spare, b;
        free: p;
        link fore: a -> p;
        link aft: b -> p;
        drive lift: p.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod measure_operands {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure lost: length(a -> q);
        measure up: p.up;
        measure nothing: length(p -> p);
        measure turn: angle(rod -> p, w);
    }
}

suspension_core::linkage! {
    mod measure_named_twice {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure p: p.x;
        measure z: p.z;
    }
}

suspension_core::linkage! {
    mod unknown_measure {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure reach: distance(a -> p);
    }
}

suspension_core::linkage! {
    mod unknown_quantity {
        fixed: a;
        free: p;
        drive x: p.x;
        drive y: p.y;
        drive z: distance(a -> p, z);
    }
}

suspension_core::linkage! {
    mod opposite_differences {
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

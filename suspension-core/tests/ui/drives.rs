suspension_core::linkage! {
    mod drive_unread {
        fixed: a;
        free: p;
        drive x: p towards [1, 0, 0];
        drive y: p along [0, 0.0, 0];
        drive z: p along [0, 1];
        measure far: p along [1e999, 0, 0];
    }
}

suspension_core::linkage! {
    mod drive_kept {
        fixed: a, b, rack;
        free: p, q, r;
        link rod: a -> p;
        link tie: rack -> q;
        body plate: p, q, r;
        drive rod_length: length(a -> p);
        drive edge: length(p -> r);
        drive on_chassis: length(a -> b);
        drive steer: rack along [0, 1, 1];
        drive lift: rack.z;
        drive again: length(b -> p);
        drive once_more: length(p -> b);
    }
}

suspension_core::linkage! {
    mod coordinate_driven_twice {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive z: p.z;
        drive lift: p.z;
    }
}

suspension_core::linkage! {
    mod drive_moves_nothing {
        fixed: rack, a, b;
        free: p;
        link fore: a -> p;
        link aft: b -> p;
        drive lift: p.z;
        drive steer: rack.y;
    }
}

suspension_core::linkage! {
    mod unknown_axis {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.up;
        drive turn: angle(a -> p, w);
    }
}

fn main() {}

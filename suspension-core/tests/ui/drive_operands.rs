suspension_core::linkage! {
    mod unread {
        fixed: a;
        free: p;
        drive x: p towards [1, 0, 0];
        drive y: p along [0, 0.0, 0];
        drive z: p along [0, 1];
        measure far: p along [1e999, 0, 0];
    }
}

suspension_core::linkage! {
    mod kept {
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

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a, b, c, d, moved;
        free: p, q, r, s, t;
        body block: p, q, r, s;
        link rod: a -> p;
        angle chassis: a -> b, c -> d;
        angle own: p -> q, r -> s;
        angle loose: p -> t, a -> b;
        angle rack: p -> q, moved -> a;
        angle lost: p -> u, a -> b;
        angle shared: p -> q, q -> r;
        drive shift: moved.y;
        drive turn: angle(a -> p, q -> r);
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod unread {
        fixed: a;
        free: p, q, r;
        angle one: a -> p;
        measure turn: angle(a -> p, q -> r around a -> q);
        measure none: angle(a -> p);
        measure nothing: angle(a -> p, q -> q);
    }
}

suspension_core::linkage! {
    mod nothing {
        fixed: a;
        free: p;
        link rod: a -> p;
        measure none: angle(a -> p, p -> p about a -> a);
        drive z: p.z;
        drive y: p.y;
    }
}

fn main() {}

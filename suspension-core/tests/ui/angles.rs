suspension_core::linkage! {
    mod angle_operands {
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
    mod angle_unread {
        fixed: a;
        free: p, q, r;
        angle one: a -> p;
        measure turn: angle(a -> p, q -> r around a -> q);
        measure none: angle(a -> p);
        measure nothing: angle(a -> p, q -> q);
    }
}

suspension_core::linkage! {
    mod angle_nothing {
        fixed: a;
        free: p;
        link rod: a -> p;
        measure none: angle(a -> p, p -> p about a -> a);
        drive z: p.z;
        drive y: p.y;
    }
}

suspension_core::linkage! {
    mod angle_beside_chassis_edge {
        fixed: a, b;
        free: hub, br;
        body arm: a, b, hub, br;
        drive turn: angle(hub -> br, z);
    }
}

suspension_core::linkage! {
    mod angle_beside_frame {
        fixed: a, b;
        free: hub, br;
        body arm: a, b, hub, br;
        drive turn: angle(br -> a, z);
    }
}

suspension_core::linkage! {
    mod angle_of_chassis_points {
        fixed: a, b;
        free: hub;
        body arm: a, b, hub;
        drive turn: angle(a -> b, z);
    }
}

suspension_core::linkage! {
    mod angle_without_link {
        fixed: a, b;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive turn: angle(b -> p, z);
    }
}

suspension_core::linkage! {
    mod turned_operands {
        fixed: a, b, c;
        free: p, q, r, s, t_sine;
        hinge arm: a, b -> p, q;
        body lever: p, q, r;
        link rod: a -> t_sine;
        drive loose: angle(a -> p, b -> r about a -> s);
        drive own: angle(a -> p, b -> q about a -> b);
        drive chassis: angle(a -> c, b -> c about a -> b);
        drive same: angle(a -> p, p -> p about a -> b);
        drive plain: angle(a -> p, q -> r);
        drive t: angle(a -> p, q -> r about p -> q);
        drive z: s.z;
    }
}

suspension_core::linkage! {
    mod turned_taken {
        fixed: a, b, c;
        free: p, t_sine;
        hinge arm: a, b -> p;
        drive t: angle(a -> c, a -> p about a -> b);
        drive x: t_sine.x;
        drive y: t_sine.y;
        drive z: t_sine.z;
    }
}

suspension_core::linkage! {
    mod turned_few {
        fixed: a, b, c;
        free: p, q;
        hinge arm: a, b -> p;
        drive t: angle(a -> c, a -> p about a -> b);
        drive x: q.x;
        drive y: q.y;
    }
}

fn main() {}

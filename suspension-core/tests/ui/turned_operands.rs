suspension_core::linkage! {
    mod m {
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
    mod taken {
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
    mod few {
        fixed: a, b, c;
        free: p, q;
        hinge arm: a, b -> p;
        drive t: angle(a -> c, a -> p about a -> b);
        drive x: q.x;
        drive y: q.y;
    }
}

fn main() {}

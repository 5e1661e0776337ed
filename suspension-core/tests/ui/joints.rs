suspension_core::linkage! {
    mod hinge_operands {
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
    mod hinge_twice {
        fixed: a, b;
        free: p, q;
        hinge arm: a, b -> p, q;
        link rod: a -> p;
        body other: b, p, q;
        drive slide: b.x;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod slide_operands {
        fixed: a, b, c;
        free: p, q, r;
        body plate: p, q, r;
        slide same: p on q -> r;
        slide loose: b on p -> c;
        slide fixed_line: a on b -> c;
        slide lost: s on p -> q;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod slide_unread {
        fixed: a;
        free: p, q;
        slide strut: a at p -> q;
    }
}

suspension_core::linkage! {
    mod slide_counts {
        fixed: a, low, high;
        free: p, q;
        link rod: a -> q;
        slide p_x: q on low -> high;
        slide pillar: p on low -> high;
        drive z: p.z;
        drive y: p.y;
        drive x: p.x;
    }
}

suspension_core::linkage! {
    mod slide_names {
        fixed: a, low, high;
        free: p;
        slide p_x: p on low -> high;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod plane_operands {
        fixed: a, b, c, d;
        free: p, q, r, s;
        body block: p, q, r, s;
        plane same: p on q, r, s;
        plane fixed_plane: a on b, c, d;
        plane lost: t on a, b, c;
        plane edge: p on a, b, p;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod plane_unread {
        fixed: a, b;
        free: p;
        plane guide: p at a, b;
        plane line: p on a, b;
    }
}

suspension_core::linkage! {
    mod plane_counts {
        fixed: a, b, c;
        free: p;
        plane p_: p on a, b, c;
        plane guide: p on b, c, a;
        drive z: p.z;
        drive y: p.y;
    }
}

suspension_core::linkage! {
    mod plane_distances {
        fixed: o, b_c, c, d;
        free: p, q;
        link bar: p -> q;
        plane a: p on o, b_c, d;
        plane a_b: q on o, c, d;
        drive z: p.z;
        drive y: p.y;
        drive x: q.x;
    }
}

suspension_core::linkage! {
    mod couple_operands {
        fixed: a, b;
        free: p, q, r;
        couple chassis: a.y = b.y;
        couple lost: p.y = s.y;
        couple up: p.up = q.z;
        couple again: p.z = p.z;
        couple gear: p.x + 2 q.y = r.z;
        couple same: 0.5 r.z - q.y = 0.5 * p.x;
        drive both: r.z - p.x - 2 q.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod couple_unread {
        fixed: a;
        free: p, q;
        couple none: p.z - q.z;
        couple nothing: 0 p.z = q.z;
        couple length: length(a -> p) = q.z;
        drive far: 1e999 p.z;
    }
}

suspension_core::linkage! {
    mod couple_counts {
        fixed: a;
        free: p;
        link rod: a -> p;
        couple one: p.y = p.x;
        couple two: p.y = -p.x;
        drive z: p.z;
    }
}

fn main() {}

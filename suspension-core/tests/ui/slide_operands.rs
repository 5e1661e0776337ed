suspension_core::linkage! {
    mod m {
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
    mod unread {
        fixed: a;
        free: p, q;
        slide strut: a at p -> q;
    }
}

suspension_core::linkage! {
    mod counts {
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
    mod names {
        fixed: a, low, high;
        free: p;
        slide p_x: p on low -> high;
        drive z: p.z;
    }
}

fn main() {}

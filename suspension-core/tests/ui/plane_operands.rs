suspension_core::linkage! {
    mod m {
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
    mod unread {
        fixed: a, b;
        free: p;
        plane guide: p at a, b;
        plane line: p on a, b;
    }
}

suspension_core::linkage! {
    mod counts {
        fixed: a, b, c;
        free: p;
        plane p_: p on a, b, c;
        plane guide: p on b, c, a;
        drive z: p.z;
        drive y: p.y;
    }
}

suspension_core::linkage! {
    mod distances {
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

fn main() {}

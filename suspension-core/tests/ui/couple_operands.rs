suspension_core::linkage! {
    mod m {
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
    mod unread {
        fixed: a;
        free: p, q;
        couple none: p.z - q.z;
        couple nothing: 0 p.z = q.z;
        couple length: length(a -> p) = q.z;
        drive far: 1e999 p.z;
    }
}

suspension_core::linkage! {
    mod counts {
        fixed: a;
        free: p;
        link rod: a -> p;
        couple one: p.y = p.x;
        couple two: p.y = -p.x;
        drive z: p.z;
    }
}

fn main() {}

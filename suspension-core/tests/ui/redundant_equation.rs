suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
        link rod: a -> p;
        drive lift: q.z;
        drive side: q.y;
    }
}

fn main() {}

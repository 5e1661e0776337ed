suspension_core::linkage! {
    mod m {
        fixed: front, rear;
        free: p, q;
        body arm: front, rear, p, q;
        drive lift: p.z;
        drive slide: rear.y;
    }
}

fn main() {}

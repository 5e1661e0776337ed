suspension_core::linkage! {
    mod m {
        fixed: rack, a, b;
        free: p;
        link fore: a -> p;
        link aft: b -> p;
        drive lift: p.z;
        drive steer: rack.y;
    }
}

fn main() {}

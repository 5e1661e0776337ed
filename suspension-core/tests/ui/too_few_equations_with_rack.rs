suspension_core::linkage! {
    mod m {
        fixed: rack, a;
        free: p;
        link tie_rod: rack -> p;
        link fore: a -> p;
        drive steer: rack.y;
    }
}

fn main() {}

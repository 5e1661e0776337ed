suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: hub;
        body arm: a, b, hub;
        drive turn: angle(a -> b, z);
    }
}

fn main() {}

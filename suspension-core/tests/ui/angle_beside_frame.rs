suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: hub, br;
        body arm: a, b, hub, br;
        drive turn: angle(br -> a, z);
    }
}

fn main() {}

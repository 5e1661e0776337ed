suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: hub, br;
        body arm: a, b, hub, br;
        drive turn: angle(hub -> br, z);
    }
}

fn main() {}

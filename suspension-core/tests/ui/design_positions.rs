suspension_core::linkage! {
    mod m {
        fixed: a at [0.0, 1];
        fixed: b at [0.0, -1.5, "z"];
        free: p on [0.0, 0.0, 0.0];
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive turn: angle(b -> p, z);
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.up;
        drive turn: angle(a -> p, w);
    }
}

fn main() {}

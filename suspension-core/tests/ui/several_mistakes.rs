suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p, p;
        link rod: a -> q;
        link dead: a -> b;
        drive z: p.up;
        wheel: p -> hub;
    }
}

fn main() {}

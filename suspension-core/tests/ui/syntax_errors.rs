suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q r;
        link rod a -> p;
        drive z: p;
        wheel: p;
        kingpin: p -> ;
        link dead: a -> a;
    }
}

fn main() {}

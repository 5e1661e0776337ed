suspension_core::linkage! {
    mod m {
        fixed: a, spare, b;
        free: p;
        link fore: a -> p;
        link aft: b -> p;
        drive lift: p.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q;
        link rod: a -> p;
        link again: p -> a;
        body bar: p, q;
        link edge: q -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

fn main() {}

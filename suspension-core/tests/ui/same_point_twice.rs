suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: p -> p;
        body bar: p, a, p;
        drive y: p.y - p.y;
        drive z: p.z;
    }
}

fn main() {}

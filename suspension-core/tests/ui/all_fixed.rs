suspension_core::linkage! {
    mod m {
        fixed: a, b;
        free: p;
        link rod: a -> b;
        body bar: a, b;
        drive y: a.y - b.y;
        drive z: p.z;
    }
}

fn main() {}

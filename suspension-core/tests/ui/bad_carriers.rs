suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r;
        body bar: p, q;
        point hub: bar;
        point tip: plate;
        point end: p, q;
        drive z: p.z;
    }
}

fn main() {}

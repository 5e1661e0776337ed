suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
    mod n {}
}

fn main() {
    let _ = m::Points::<f64>::default();
}

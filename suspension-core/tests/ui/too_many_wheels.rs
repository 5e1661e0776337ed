suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel one: p -> q;
        wheel two: p -> q;
        wheel three: p -> q;
        wheel four: p -> q;
        wheel five: p -> q;
        wheel six: p -> q;
        wheel seven: p -> q;
        wheel eight: p -> q;
        wheel nine: p -> q;
        drive z: p.z;
    }
}

fn main() {}

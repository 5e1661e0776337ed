suspension_core::linkage! {
    mod role_stated_twice {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel: p -> q;
        wheel: p -> r;
        kingpin: p -> q;
        kingpin: p -> r;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod wheel_stated_twice {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel left: p -> q;
        wheel left: p -> r;
        kingpin left: p -> q;
        kingpin left: p -> r;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod wheel_without_carrier {
        fixed: a;
        free: p, q;
        body bar: p, q;
        wheel: p -> q;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod wheels_named_and_unnamed {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel left: p -> q;
        wheel: p -> r;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod too_many_wheels {
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

suspension_core::linkage! {
    mod kingpin_without_wheel {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        wheel left: p -> q;
        kingpin right: p -> q;
        kingpin: p -> r;
        drive z: p.z;
    }
}

fn main() {}

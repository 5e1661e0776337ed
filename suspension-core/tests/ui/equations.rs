suspension_core::linkage! {
    mod all_fixed {
        fixed: a, b;
        free: p;
        link rod: a -> b;
        body bar: a, b;
        drive y: a.y - b.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod redundant_equation {
        fixed: a;
        free: p, q;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
        link rod: a -> p;
        drive lift: q.z;
        drive side: q.y;
    }
}

suspension_core::linkage! {
    mod too_few_equations {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod too_few_equations_with_rack {
        fixed: rack, a;
        free: p;
        link tie_rod: rack -> p;
        link fore: a -> p;
        drive steer: rack.y;
    }
}

suspension_core::linkage! {
    mod too_few_points {
        fixed: a;
        free: p;
        body dot: p;
        drive x: p.x;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod too_many_equations {
        fixed: a, b;
        free: p;
        link rod: a -> p;
        link stay: b -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod no_points {
        fixed: ;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod nothing_declared {}
}

suspension_core::linkage! {
    mod marker_in_constraint {
        fixed: a;
        free: p, q, r;
        body plate: p, q, r;
        point hub: plate;
        link rod: a -> hub;
        drive x: p.x;
        drive y: p.y;
        drive z: hub.z;
    }
}

suspension_core::linkage! {
    mod length_stated_twice {
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

suspension_core::linkage! {
    mod bad_carriers {
        fixed: a;
        free: p, q, r;
        body bar: p, q;
        point hub: bar;
        point tip: plate;
        point end: p, q;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod bent_body {
        fixed: front, rear;
        free: p, q;
        body arm: front, rear, p, q;
        drive lift: p.z;
        drive slide: rear.y;
    }
}

suspension_core::linkage! {
    mod immovable_body {
        fixed: a, b, c;
        free: p;
        body plate: a, b, c, p;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod shared_triangle {
        fixed: a;
        free: p, q, r, s;
        body plate: p, q, r;
        body other: q, r, p, s;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod same_point_twice {
        fixed: a;
        free: p;
        link rod: p -> p;
        body bar: p, a, p;
        drive y: p.y - p.y;
        drive z: p.z;
    }
}

suspension_core::linkage! {
    mod closed_twice {
        fixed: f, g;
        free: a, b, c, d, x, y;
        body one: a, b, x;
        body two: c, d, y;
        body mid: a, b, c, d;
        link rod_a: f -> a;
        link rod_b: f -> b;
        link rod_c: g -> c;
        link rod_x: g -> x;
        drive z: a.z;
        drive h: y.z;
    }
}

fn main() {}

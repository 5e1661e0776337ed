suspension_core::linkage! {
    mod m {
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

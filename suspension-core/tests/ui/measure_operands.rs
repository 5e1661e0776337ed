suspension_core::linkage! {
    mod m {
        fixed: a;
        free: p;
        link rod: a -> p;
        drive y: p.y;
        drive z: p.z;
        measure lost: length(a -> q);
        measure up: p.up;
        measure nothing: length(p -> p);
        measure turn: angle(rod -> p, w);
    }
}

fn main() {}

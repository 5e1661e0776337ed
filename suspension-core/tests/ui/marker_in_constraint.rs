suspension_core::linkage! {
    mod m {
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

fn main() {}

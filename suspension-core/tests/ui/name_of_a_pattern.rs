suspension_core::linkage! {
    mod m {
        fixed: a;
        free: None;
        link rod: a -> None;
        drive y: None.y;
        drive z: None.z;
    }
}

fn main() {}

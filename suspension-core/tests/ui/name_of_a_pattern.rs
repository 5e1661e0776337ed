suspension_core::linkage! {
    mod m {
        fixed: a;
        free: None, Listing;
        link rod: a -> None;
        link second: a -> Listing;
        drive y: None.y;
        drive z: None.z;
    }
}

fn main() {}

suspension_core::linkage! {
    mod m {}
}

fn main() {}

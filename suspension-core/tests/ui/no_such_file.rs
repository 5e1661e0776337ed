suspension_core::linkage! {
    mod no_such_file;
}

fn main() {}

suspension_core::linkage! {
    mod m in "file_with_mistakes.linkage"; fixed: a;
}

fn main() {}

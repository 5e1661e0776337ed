//! A module of a file's name, one with another, and one with the statements.

use suspension_core::linkage;

linkage! {
    /// Named as its file.
    pub mod in_a_file;
}

linkage! {
    mod bar in "in_a_file.linkage";
}

#[test]
fn linkage_reads_statements_from_a_file() {
    let lengths = in_a_file::Lengths { bar: 0.5 };
    assert_eq!(bar::Lengths { bar: 0.5 }.bar, lengths.bar);
}

//! Each mistake in a listing is reported on the user's own token, with what to write instead.

#[test]
fn ui() {
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/*.rs");
}

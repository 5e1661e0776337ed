//! Pictures of load cases.

use super::super::program::{folder, run};
use super::loaded;

/// The picture of a load case a.
fn picture(case: &str) -> String {
    let folder = folder();
    let file = loaded(&format!("[loads.a]\n{case}"));
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--drawings", "."]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    std::fs::read_to_string(folder.path().join("a_a.svg")).expect("a picture")
}

/// A moment alone has no arrow, and takes no other one's number.
#[test]
fn the_number_at_an_arrow_is_that_of_its_force() {
    let picture =
        picture("axle = { moment = [0.0, 50.0, 0.0] }\ncontact = [-3000.0, 0.0, 4000.0]\n");
    assert!(picture.contains("\n5000 N\n"), "{picture}");
}

/// Two links of a wishbone bear less than half a newton, one of them pressed.
#[test]
fn a_load_that_is_rounded_to_zero_has_no_sign() {
    let picture = picture("lower_ball = [0.3, 0.0, 0.0]\n");
    assert!(
        picture.contains("\n0 N\n") && !picture.contains("-0 N"),
        "{picture}"
    );
}

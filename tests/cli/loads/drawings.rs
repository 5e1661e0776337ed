//! Pictures of load cases.

use super::super::program::{folder, run};
use super::{loaded, table};

/// The picture of a load case a.
fn picture(case: &str) -> String {
    let folder = folder();
    let file = loaded(&format!("[loads.a]\n{case}"));
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--drawings", "."]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    std::fs::read_to_string(folder.path().join("a_a.svg")).expect("a picture")
}

/// A pure moment has no arrow, and does not take the number of another.
#[test]
fn the_number_at_an_arrow_is_its_force_beside_a_moment() {
    let picture =
        picture("axle = { moment = [0.0, 50.0, 0.0] }\ncontact = [-3000.0, 0.0, 4000.0]\n");
    assert!(picture.contains("\n5000 N\n"), "{picture}");
}

/// Two links of a wishbone have forces below half a newton, one of them in compression.
#[test]
fn a_force_rounded_to_zero_is_drawn_without_sign() {
    let picture = picture("lower_ball = [0.3, 0.0, 0.0]\n");
    assert!(
        picture.contains("\n0 N\n") && !picture.contains("-0 N"),
        "{picture}"
    );
}

/// A spring that carries the wheel is pressed; a force that makes its measure smaller pulls.
#[test]
fn drawings_show_spring_forces_with_their_sign() {
    let carried = "wheel_centre = [0.0, 0.0, 4000.0]\nbump = \"damper\"\n";
    let row = &table(&loaded(&format!("[loads.a]\n{carried}")), &[])[0];
    let pressed = format!("\n-{:.0} N\n", row["a_damper_N"]);
    for (case, expected) in [(carried, &*pressed), ("damper = -1500.0\n", "\n1500 N\n")] {
        let picture = picture(case);
        assert!(picture.contains(expected), "{expected}{picture}");
    }
}

//! Tables of a live axle.

use super::{carmaker_rows, carsim_table, tables};

/// A live axle with unequal sides, by two drives that are named after the wheels, and their values.
pub(crate) fn live_axle([left, right]: [(&str, f64); 2]) -> String {
    format!(
        "unit = \"m\"\nstatements = '''
fixed: fl at [0.55, 0.47, 0.30], fr at [0.60, -0.44, 0.27], fu at [0.33, 0.06, 0.47], pc at [-0.15, -0.50, 0.33],
       tl at [-0.05, 0.45, 0.67], tr at [-0.08, -0.60, 0.65];
free:  al at [0.02, 0.51, 0.23], ar at [0.04, -0.49, 0.25], au at [0.01, -0.03, 0.45], pa at [-0.15, 0.50, 0.32],
       wl at [0.0, 0.75, 0.31], wr at [0.0, -0.75, 0.31], dl at [-0.09, 0.45, 0.21], dr at [-0.07, -0.60, 0.22];
link a: fl -> al; link b: fr -> ar; link c: fu -> au; link panhard: pc -> pa;
body axle: wl, wr, al, ar, au, pa, dl, dr;
drive bump_left:  {};
drive bump_right: {};
measure damper_left:  length(dl -> tl);
measure damper_right: length(dr -> tr);
wheel left:  wr -> wl;
wheel right: wl -> wr;
'''
vehicle = {{ wheel_radius = 0.31 }}
time = {{ instants = [0.0] }}
drives = {{ bump_left = {:?}, bump_right = {:?} }}
",
        left.0, right.0, left.1, right.1
    )
}

pub(crate) const HEAVE_AND_ROLL: [(&str, f64); 2] =
    [("0.5 wl.z + 0.5 wr.z", 0.31), ("wl.z - wr.z", 0.0)];

/// The lengths of the dampers with both wheels at 0.31 m.
pub(crate) const BY_DAMPERS: [(&str, f64); 2] = [
    ("length(dl -> tl)", 0.461_735_855_224_607_9),
    ("length(dr -> tr)", 0.430_116_263_352_131_4),
];

#[test]
fn a_live_axle_in_heave_has_no_lean_for_any_drives() {
    let by_height = live_axle([("wl.z", 0.31), ("wr.z", 0.31)]);
    let heights = tables(&by_height, &["carmaker"]);
    assert!(heights.contains(".ValidSide = left\n"), "{heights}");
    let heights = carmaker_rows(&heights);
    for drives in [BY_DAMPERS, HEAVE_AND_ROLL] {
        let found = carmaker_rows(&tables(&live_axle(drives), &["carmaker"]));
        let [_, leans, _] = found["rx"];
        assert!(leans.abs() < 1e-12, "{leans}");
        for (name, expected) in &heights {
            for (found, expected) in found[name].iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{name}: {found} {expected}"
                );
            }
        }
    }
    let jounce = |drives| {
        let text = tables(&live_axle(drives), &["carsim"]);
        let [highest, _] = *carsim_table(&text, "CAMBER_TABLE").last().expect("a row");
        highest
    };
    assert!(
        (jounce(HEAVE_AND_ROLL) - 60.0).abs() < 1e-6,
        "travel is that of heave"
    );
}

#[test]
fn only_a_symmetric_axle_has_a_table_valid_for_both_sides() {
    let file = include_str!("../../../examples/steered_axle.toml");
    let moved = format!("{file}\n[points]\nleft_lower_ball = [0.005, 0.70, 0.175]\n");
    for (file, valid) in [(file.to_owned(), "left+right"), (moved, "right")] {
        let text = tables(&file, &["carmaker", "--wheel", "right"]);
        assert!(text.contains(&format!(".ValidSide = {valid}\n")), "{text}");
    }
}

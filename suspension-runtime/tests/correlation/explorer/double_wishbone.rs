//! The double wishbone, and the sweep of 41 steps.

use crate::agreement::Agreement;
use crate::explorer::{ANGLE, LENGTH, State, line, plane};
use crate::published::{Row, folder, geometry, number, point, results};
use crate::suspension::{DOUBLE_WISHBONE, Suspension};

const POINTS: [(&str, &str); 4] = [
    ("axle_outboard", "wheel_center"),
    ("lower_outboard", "lower_wishbone_outboard"),
    ("upper_outboard", "upper_wishbone_outboard"),
    ("trackrod_outboard", "trackrod_outboard"),
];
const LOWER: [&str; 3] = [
    "lower_inboard_front",
    "lower_inboard_rear",
    "lower_outboard",
];
const UPPER: [&str; 3] = [
    "upper_inboard_front",
    "upper_inboard_rear",
    "upper_outboard",
];

/// Compares a file of results with the suspension, moved as each row says.
fn compare(file: &str, angle: f64, by: fn(&Row) -> [f64; 2], numbers: usize) {
    let Some(folder) = folder(file) else {
        return;
    };
    let table = geometry(&folder.join("double_wishbone_suspexplorer.toml"));
    let suspension = Suspension::new(DOUBLE_WISHBONE, |name| point(&table["points"][name]));
    let mut agreement = Agreement::default();
    let rows = results(&folder.join(file));
    for row in &rows {
        let at = suspension.design().moved(by(row));
        let mut state = State {
            agreement: &mut agreement,
            rows: &rows,
            row,
            at,
            radius: number(&table["tyre_radius_mm"]),
            angle,
        };
        state.points(&POINTS, LENGTH);
        state.wheel();
        let moving = at.in_bump();
        state.steering_axis(&line(&moving, ["lower_outboard", "upper_outboard"]), "");
        state.instant_centres([LOWER, UPPER].map(|arm| plane(&moving, arm)));
    }
    agreement.holds(file, numbers);
}

#[test]
fn the_double_wishbone_agrees_with_suspexplorer() {
    let by = |row: &Row| [row["wheel_travel"], row["rack"]];
    compare("double_wishbone_suspexplorer_results.csv", ANGLE, by, 1938);
}

#[test]
fn the_sweep_of_41_steps_agrees_with_suspexplorer() {
    // Its drives are coordinates of the chassis.
    let by = |row: &Row| {
        [
            row["target_wheel_center_z"] - 313.426,
            row["target_rack"] - 200.0,
        ]
    };
    compare(
        "double_wishbone_suspexplorer_golden.csv",
        3.0 * ANGLE,
        by,
        1107,
    );
}

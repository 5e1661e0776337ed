//! The MacPherson strut.

use crate::agreement::Agreement;
use crate::explorer::{ANGLE, LENGTH, State, line, plane};
use crate::published::{folder, geometry, number, point, results};
use crate::suspension::{Suspension, length, values};

/// The strut's top slides on a line of the knuckle through the ball joint.
const MACPHERSON: &str = "
    fixed: lower_inboard_front, lower_inboard_rear, strut_top, trackrod_inboard;
    free:  lower_outboard, strut_bottom, trackrod_outboard, axle_outboard;

    link lower_fore: lower_inboard_front -> lower_outboard;
    link lower_aft:  lower_inboard_rear  -> lower_outboard;
    link trackrod:   trackrod_inboard    -> trackrod_outboard;
    body knuckle:    lower_outboard, trackrod_outboard, axle_outboard, strut_bottom;
    slide strut:     strut_top on lower_outboard -> strut_bottom;
    point axle_inboard: knuckle;

    drive bump:  axle_outboard.z;
    drive steer: trackrod_inboard.y;";

const POINTS: [(&str, &str); 3] = [
    ("axle_outboard", "wheel_center"),
    ("lower_outboard", "lower_wishbone_outboard"),
    ("strut_bottom", "strut_bottom"),
];
const TRACKROD: (&str, &str) = ("trackrod_outboard", "trackrod_outboard");
/// mm: the published knuckle is 9e-6 mm too long from there to the strut.
const STRETCHED: f64 = 1.1e-5;

#[test]
fn the_macpherson_strut_agrees_with_suspexplorer() {
    let Some(folder) = folder("explorer::macpherson") else {
        return;
    };
    let table = geometry(&folder.join("macpherson_suspexplorer.toml"));
    let suspension = Suspension::new(MACPHERSON, |name| point(&table["points"][name]));
    let mut agreement = Agreement::default();
    let rows = results(&folder.join("macpherson_suspexplorer_results.csv"));
    for row in &rows {
        let by = [row["wheel_travel"], row["rack"]];
        let at = suspension.design().moved(by);
        let mut state = State {
            agreement: &mut agreement,
            rows: &rows,
            row,
            at,
            radius: number(&table["tyre_radius_mm"]),
            angle: ANGLE,
        };
        state.points(&POINTS, LENGTH);
        state.points(&[TRACKROD], STRETCHED);
        state.wheel();
        let moving = at.in_bump();
        state.steering_axis(&line(&moving, ["lower_outboard", "strut_top"]), "");
        let arm = [
            "lower_inboard_front",
            "lower_inboard_rear",
            "lower_outboard",
        ];
        let [top, foot] = ["strut_top", "strut_bottom"].map(|name| moving.point(name));
        let across = [values(&top), values(&(top - foot))];
        state.instant_centres([plane(&moving, arm), across]);
        state.damper(length(&(top - foot)));
    }
    agreement.holds("macpherson", 2028);
}

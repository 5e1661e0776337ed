//! The five-link, with the damper on its lower rear link.

use nalgebra::Vector3;
use suspension_core::Signal;
use suspension_core::wheel::SteeringAxis;

use crate::agreement::Agreement;
use crate::explorer::{ANGLE, LENGTH, State};
use crate::published::{folder, geometry, point, results};
use crate::suspension::{FIVE_LINK, Moving, Number, Suspension, length};

/// mm: 16 inches and a tyre of 205/55.
const RADIUS: f64 = 0.5 * 16.0 * 25.4 + 0.55 * 205.0;

const POINTS: [(&str, &str); 6] = [
    ("axle_outboard", "wheel_center"),
    ("upper_front", "upper_front_link_outboard"),
    ("upper_rear", "upper_rear_link_outboard"),
    ("lower_front", "lower_front_link_outboard"),
    ("lower_rear", "lower_rear_link_outboard"),
    ("trackrod", "trackrod_outboard"),
];

/// From the strut's top to its foot, nine tenths along the lower rear link.
fn damper(moving: &Moving<'_>, top: &Vector3<f64>) -> Number {
    let [inboard, outboard] = ["lower_rear_inboard", "lower_rear"].map(|name| moving.point(name));
    let foot = inboard + (outboard - inboard) * Signal::still(0.9);
    length(&(foot - top.map(Signal::still)))
}

#[test]
fn the_five_link_agrees_with_suspexplorer() {
    let Some(folder) = folder("explorer::five_link") else {
        return;
    };
    let table = geometry(&folder.join("five_link_suspexplorer.toml"));
    let suspension = Suspension::new(FIVE_LINK, |name| {
        let ends = |link: &str, end: usize| point(&table["links"][link][end]);
        match name.strip_suffix("_inboard") {
            _ if name.starts_with("axle") => point(&table["points"][name]),
            Some(link) => ends(link, 0),
            None => ends(name, 1),
        }
    });
    let top = point(&table["points"]["strut_top"]);
    let mut agreement = Agreement::default();
    let rows = results(&folder.join("five_link_suspexplorer_results.csv"));
    for row in &rows {
        let by = [row["wheel_travel"], row["rack"]];
        let at = suspension.design().moved(by);
        let mut state = State {
            agreement: &mut agreement,
            rows: &rows,
            row,
            at,
            radius: RADIUS,
            angle: ANGLE,
        };
        state.points(&POINTS, LENGTH);
        state.wheel();
        state.damper(damper(&at.in_bump(), &top));
        // In steering the damper keeps its length, not the wheel its height.
        let [per_bump, per_steer] =
            [at.in_bump(), at.in_steering()].map(|moving| damper(&moving, &top).rate);
        let steering = at.per([-per_steer / per_bump, 1.0]);
        let carrier = steering.carrier(["upper_front", "lower_front", "trackrod"]);
        let [centre, velocity, omega] = [carrier.centre, carrier.velocity, carrier.omega]
            .map(|vector| vector.map(Signal::still));
        let axis = SteeringAxis::of_screw(&centre, &velocity, &omega);
        state.steering_axis(&axis, "_virtual");
    }
    agreement.holds("five-link", 1794);
}

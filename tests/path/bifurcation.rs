//! Four-bars whose bars can all lie in line: there a second curve crosses.

use nalgebra::Vector3;
use suspension_core::path::{Continuation, Curve, End};
use suspension_core::{Build, Inputs, Linkage, Signal};

use crate::mechanisms::four_bar::four_bar::{Drives, Model, Points};

/// A four-bar with base `base` along y, its crank turned by `turn` from z.
fn design(base: f64, turn: f64, rocker_end: Vector3<f64>) -> Points<f64> {
    Points {
        crank_pin: Vector3::zeros(),
        rocker_pin: Vector3::new(0.0, base, 0.0),
        crank_end: Vector3::new(0.0, turn.sin(), turn.cos()) * 0.2,
        rocker_end,
    }
}

fn parallelogram(turn: f64) -> Points<f64> {
    let across = Vector3::new(0.0, 0.5, 0.0);
    design(0.5, turn, design(0.5, turn, across).crank_end + across)
}

fn inputs(drives: Drives<f64>) -> Inputs<suspension_core::Still, Drives<f64>> {
    let none = Drives::default();
    Inputs::still(Signal {
        value: drives,
        rate: none,
        second_rate: none,
    })
}

#[test]
fn the_curve_of_a_parallelogram_ends_where_the_bars_are_in_line() {
    let points = parallelogram(1.0);
    let model = Model::new(&points).expect("a four-bar");
    let inputs = inputs(model.drives_at(&points));
    let curve = Curve::new(&model, &inputs, 0).expect("a drive");
    let q = model.unknowns(&points);
    let path = Continuation::default().path(curve, &q, true);
    let stretches: Vec<_> = path
        .expect("a regular start")
        .collect::<Result<_, _>>()
        .expect("no step fails");
    let last = stretches.last().expect("a path");
    let Some(End::Bifurcation { accuracy }) = last.end else {
        panic!("{:?}", last.end)
    };
    let flat = std::f64::consts::FRAC_PI_2;
    let off = (last.place.value - flat) * 0.2;
    assert!(
        off <= 0.0 && -off <= accuracy,
        "{off} from flat, {accuracy}"
    );
    // The tangent is still that of the parallelogram: the rocker moves as the crank does.
    let tangent = last.place.tangent.unknowns;
    let of_rounding = 16.0 * f64::EPSILON / (accuracy * accuracy);
    let apart = (tangent[1] - tangent[4])
        .abs()
        .max((tangent[2] - tangent[5]).abs());
    assert!(apart < of_rounding, "{apart} {of_rounding}");
}

#[test]
fn a_fully_turning_crank_has_turning_points_at_angle_0_and_pi() {
    // Grashof: 0.2 + 0.6 < 0.45 + 0.5.
    let (turn, base) = (1.0_f64, 0.6);
    let crank_end = design(base, turn, Vector3::zeros()).crank_end;
    let rocker_pin = Vector3::new(0.0, base, 0.0);
    let between = rocker_pin - crank_end;
    let (coupler, rocker) = (0.5_f64, 0.45_f64);
    let along =
        (between.norm_squared() + coupler * coupler - rocker * rocker) / (2.0 * between.norm());
    let across = (coupler * coupler - along * along).sqrt();
    let unit = between.normalize();
    let rocker_end = crank_end + unit * along + Vector3::x().cross(&unit) * across;
    let points = design(base, turn, rocker_end);
    let model = Model::new(&points).expect("a four-bar");
    let inputs = inputs(model.drives_at(&points));
    let curve = Curve::new(&model, &inputs, 0).expect("a drive");
    let path = Continuation::default().path(curve, &model.unknowns(&points), true);
    let stretches: Vec<_> = path
        .expect("a regular start")
        .collect::<Result<_, _>>()
        .expect("no step fails");
    let turns: Vec<_> = stretches.iter().filter_map(|s| s.turning).collect();
    assert_eq!(turns.len(), 2, "at 0 and at pi");
    assert!(turns.iter().all(|turning| turning.is_end_of_angle));
    assert!((turns[0].place.value - std::f64::consts::PI).abs() < 1e-7);
    assert!(turns[1].place.value.abs() < 1e-7);
    let end = stretches.last().and_then(|stretch| stretch.end);
    assert!(
        matches!(end, Some(End::Closed { gap }) if gap < 1e-12),
        "{end:?}"
    );
}

//! A step across two turning points at once.

use nalgebra::Vector3;
use suspension_core::linkages::five_link;
use suspension_core::{Build, Linkage, Motion, SolveError, Tracker, Values};

use super::Drive;

/// A suspension with two turning points of the drive close together: a step across both ends with the
/// same sign of the determinant, near enough to its prediction for every other test.
#[test]
fn a_step_across_two_turning_points_is_refused() {
    let points = [
        [
            -1.5108121929112002,
            0.24921197502089995,
            -0.06058312204111056,
        ],
        [-1.588159124548218, -0.07566166830110822, -0.534251005633094],
        [-1.1086765251039115, 0.8499229613210226, -0.3274438547726599],
        [-1.7104483203639824, 0.9646439450283073, 0.36267912730321045],
        [
            -1.1436341078664842,
            0.4830277954478788,
            -0.13568867314336422,
        ],
        [-1.5926017879146497, 0.4131412170712462, 0.26274295407965464],
        [-1.6802722614032846, 0.3674213256795723, 0.6674456293510402],
        [
            -1.2047113964623082,
            0.23181577636930922,
            -0.035602614725374265,
        ],
        [
            -0.639192293726621,
            -0.14904542220609235,
            0.019729072805196424,
        ],
        [-1.1527458820263188, 0.3354102943425843, 0.03879444396387305],
        [-1.3411262584142414, 0.3589877806043034, 0.4515637918620492],
    ]
    .into_iter();
    let design = five_link::Points::from_values(points.map(Vector3::from));
    let model = five_link::Model::new(&design).expect("a geometry");
    let drive = Drive {
        start: model.drives_at(&design).theta,
        rate: -0.6467181928322563,
        second_rate: 0.4042771321327354,
    };
    let inputs = |t| drive.inputs::<five_link::Drives<f64>>(t);
    let guarded = Tracker::default();
    let unguarded = Tracker {
        change_of_jacobian: f64::MAX,
        ..guarded
    };
    let (from, to) = (1.247, 1.782);
    let mut start = Motion::at_rest(model.unknowns(&design));
    let followed = guarded.advance(&model, inputs, 0.0, from, &mut start);
    followed.expect("a regular motion");
    let mut jumped = start;
    let step = unguarded.step(&model, &inputs(to), to - from, &mut jumped);
    step.expect("another assembly, in silence");
    assert_eq!(jumped.positive_determinant, start.positive_determinant);
    let mut true_motion = start;
    // The drive locks before the step's end: the motion does not go there at all.
    let followed = guarded.advance(&model, inputs, from, to, &mut true_motion);
    let stopped = followed.expect_err("a lock");
    assert!((stopped.reached - 1.491_577).abs() < 1e-6, "{stopped:?}");
    assert!((true_motion.position - jumped.position).amax() > 1e-3);
    let mut motion = start;
    let refused = guarded.step(&model, &inputs(to), to - from, &mut motion);
    assert!(
        matches!(refused, Err(SolveError::TooFar { .. })),
        "{refused:?}"
    );
    assert_eq!(motion, start);
}

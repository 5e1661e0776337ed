//! Led motions: another quantity than the drive is prescribed.

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::HasWheel;
use suspension_core::linkages::attia2003;
use suspension_core::listing::Parts;
use suspension_core::path::{Curve, Leader, Led, Place};
use suspension_core::step::stepper::Stopped;
use suspension_core::{Build, Inputs, Motion, Newton, Signal, SolveError};

use super::case::{Case, attia, five_link};
use crate::support::{self, INSTANTS, Reference, theta};

/// The height of the wheel centre with its rates.
fn height<P: HasWheel<f64>>(points: &Signal<P>) -> Signal<f64> {
    let z = |points: &P| points.wheel()[1].z;
    Signal {
        value: z(&points.value),
        rate: z(&points.rate),
        second_rate: z(&points.second_rate),
    }
}

/// The distance of two points that move, with its rates.
fn distance([a, b]: [Signal<Vector3<f64>>; 2]) -> Signal<f64> {
    let between = b.value - a.value;
    let (rate, second_rate) = (b.rate - a.rate, b.second_rate - a.second_rate);
    let value = between.norm();
    let closing = between.dot(&rate) / value;
    let across = rate.norm_squared() - closing * closing;
    Signal {
        value,
        rate: closing,
        second_rate: (between.dot(&second_rate) + across) / value,
    }
}

/// A spring from point 2 to point 10.
fn spring(points: &Signal<attia2003::Points<f64>>) -> Signal<f64> {
    let point = |of: fn(&attia2003::Points<f64>) -> Vector3<f64>| Signal {
        value: of(&points.value),
        rate: of(&points.rate),
        second_rate: of(&points.second_rate),
    };
    distance([point(|p| p.p2), point(|p| p.p10)])
}

/// The angle of the link from point 2 to point 7 from z.
fn upper_link(points: &Signal<attia2003::Points<f64>>) -> Signal<f64> {
    let link = |p: &attia2003::Points<f64>| p.p7 - p.p2;
    let length = link(&points.value).norm();
    let cosine = link(&points.value).z / length;
    let sine = (1.0 - cosine * cosine).sqrt();
    let rate = -link(&points.rate).z / length / sine;
    let second_rate = -(link(&points.second_rate).z / length + cosine * rate * rate) / sine;
    Signal {
        value: cosine.acos(),
        rate,
        second_rate,
    }
}

fn amax(difference: SVector<f64, 15>) -> f64 {
    difference.amax()
}

/// Led by a quantity as it is in the 40-digit reference, everything else is as there.
fn compare_rates_with_the_reference<L: Build<15, Scalar = f64>>(
    case: &Case<f64, L>,
    quantity: impl Fn(&Signal<L::Points>) -> Signal<f64>,
) {
    let reference = Reference::load();
    for (index, instant) in INSTANTS.into_iter().enumerate() {
        let expected = Motion {
            position: reference.unknowns(index, ""),
            velocity: reference.unknowns(index, "v"),
            acceleration: reference.unknowns(index, "a"),
            positive_determinant: None,
        };
        let inputs = (case.inputs)(instant);
        let target = quantity(&expected.points(&case.model, &inputs));
        // From a millimetre beside, the drive free.
        let beside = expected.position + SVector::repeat(1e-3);
        let curve = case.curve();
        let mut led = Led::at_rest(&curve, &beside).expect("regular");
        let still = (case.inputs)(0.0);
        Leader::default()
            .step(&case.model, &still, &quantity, &target, 0.0, &mut led)
            .expect("a configuration near by");
        let Signal {
            value,
            rate,
            second_rate,
        } = led.configuration;
        let off = [
            amax(value.unknowns - expected.position),
            amax(rate.unknowns - expected.velocity),
            amax(second_rate.unknowns - expected.acceleration),
        ];
        // Where the quantity hardly changes along the curve, eight roundings of it are a long way.
        let slope = target.rate.abs() / rate.norm();
        let roundings = 8.0 * f64::EPSILON * target.value.abs() / slope;
        let flatness = (roundings / 1e-14).max(1.0);
        let bounds = [1e-14, 1e-12, 1e-10].map(|bound| bound * flatness);
        assert!(
            off.iter().zip(bounds).all(|(off, bound)| *off <= bound),
            "at {instant} s off by {off:?} of {bounds:?}"
        );
        let drive = led.drive(&case.model, &still);
        let theta = theta(instant);
        assert!((drive.value - theta.value).abs() <= bounds[0]);
        assert!((drive.rate - theta.rate).abs() <= bounds[1]);
        assert!((drive.second_rate - theta.second_rate).abs() <= bounds[2]);
    }
}

#[test]
fn rates_of_a_led_motion_agree_with_the_reference() {
    compare_rates_with_the_reference(&attia(), height);
    compare_rates_with_the_reference(&five_link(), height);
    compare_rates_with_the_reference(&attia(), spring);
    compare_rates_with_the_reference(&attia(), upper_link);
}

/// The slope of the height along the unit tangent.
fn slope<L>(case: &Case<f64, L>, place: &Place<f64, 15>) -> f64
where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let along = Signal {
        value: place.configuration,
        rate: place.tangent,
        second_rate: place.tangent,
    };
    height(&case.curve().moving_points(&along)).rate
}

/// Leads from one height to another in a second.
fn lead<L>(
    case: &Case<f64, L>,
    [from, to]: [f64; 2],
    led: &mut Led<f64, 15>,
) -> Result<(), Stopped<f64>>
where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let still = |_| (case.inputs)(0.0);
    let target = |t: f64| Signal {
        value: from + (to - from) * t,
        rate: to - from,
        second_rate: 0.0,
    };
    let leader = Leader::default();
    leader
        .step(&case.model, &still(0.0), height, &target(0.0), 0.0, led)
        .expect("the place where it starts");
    let advanced = leader.advance(&case.model, still, height, target, [0.0, 1.0], led);
    advanced.map(|_| ())
}

/// Led by its height, the wheel goes round the whole curve, turning points of the drive included,
/// but for the four places where the height itself turns.
fn lead_round_the_curve_by_height<L>(case: &Case<f64, L>)
where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let curve = case.curve();
    let stretches = case.path(true);
    let start = |place: &Place<f64, 15>| {
        let mut led = Led::at_rest(&curve, &place.configuration.unknowns).expect("regular");
        led.configuration.value = place.configuration;
        led
    };
    let mut led = start(&stretches[0].place);
    let (mut drive_turned, mut switched, mut turns) = (0, 0, 0);
    for pair in stretches.windows(2) {
        let [from, to] = [pair[0].place, pair[1].place];
        let heights = [from, to].map(|place| curve.points(&place.configuration).wheel()[1].z);
        let rising = slope(case, &from) > 0.0;
        if rising == (slope(case, &to) > 0.0) {
            let before = led.parameter;
            lead(case, heights, &mut led).expect("the height does not turn here");
            switched += usize::from(led.parameter != before);
            let off = (led.configuration.value - to.configuration).norm();
            assert!(off <= 1e-12, "off by {off} at {} rad", to.value);
            drive_turned += usize::from(pair[1].turning.is_some());
        } else {
            let beyond = heights[0] + if rising { 1e-2 } else { -1e-2 };
            let refused = lead(case, [heights[0], beyond], &mut led);
            let Err(Stopped {
                refused: Some((_, SolveError::TurningPoint { asked, extreme, .. })),
                ..
            }) = refused
            else {
                panic!("{refused:?}")
            };
            assert_eq!(asked, beyond);
            let reached = height(&led.points(&case.model, &(case.inputs)(0.0))).value;
            assert!(
                (reached - extreme).abs() <= 1e-12,
                "advanced up to the extreme"
            );
            let [before, after] = heights.map(|height| if rising { height } else { -height });
            let extreme = if rising { extreme } else { -extreme };
            assert!(extreme >= before.max(after));
            turns += 1;
            led = start(&to);
        }
    }
    assert_eq!((drive_turned, turns), (4, 4));
    assert!(switched > 0, "no one entry is a good parameter all round");
}

#[test]
fn a_motion_led_by_height_passes_turning_points_of_the_drive() {
    lead_round_the_curve_by_height(&attia());
    lead_round_the_curve_by_height(&five_link());
}

/// A root with a mirrored knuckle is no result of a led step.
#[test]
fn a_led_step_to_a_mirrored_knuckle_is_refused() {
    let case = attia::<f64>();
    let plain = Newton {
        max_halvings: 0,
        ..Newton::from_afar()
    };
    let mut mirrored = SVector::<f64, 15>::from_iterator(
        (6..=10).flat_map(|number| <[f64; 3]>::from(support::printed_guess(&format!("p{number}")))),
    );
    let inputs = (case.inputs)(0.0);
    plain
        .solve(&case.model, &inputs, &mut mirrored)
        .expect("a root, though not the published one");
    let start = Led::at_rest(&case.curve(), &mirrored).expect("regular");
    let target = height(&start.points(&case.model, &inputs));
    let mut led = start;
    let step = Leader::default().step(&case.model, &inputs, height, &target, 0.0, &mut led);
    let wrong = SolveError::Mirrored { part: support::P9 };
    assert_eq!((step.expect_err("mirrored"), led), (wrong, start));
}

/// A NaN target or quantity is reported neither as a turning point nor as a fault of the linkage.
#[test]
fn a_nan_quantity_or_target_of_a_led_motion_is_reported() {
    let case = attia::<f64>();
    let inputs = (case.inputs)(0.0);
    let start = Led::at_rest(&case.curve(), &case.q).expect("regular");
    let height_at_start = height(&start.points(&case.model, &inputs));
    let demand = |quantity: &dyn Fn(&Signal<attia2003::Points<f64>>) -> Signal<f64>, target| {
        let mut led = start;
        let step = Leader::default().step(&case.model, &inputs, quantity, &target, 0.0, &mut led);
        let error = step.expect_err("no number");
        assert!(matches!(error, SolveError::NotFinite { .. }), "{error:?}");
        let name = error.part().map(|part| case.model.name(part));
        assert_eq!((name, led), (Some("theta"), start));
    };
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        demand(
            &height,
            Signal {
                value,
                ..height_at_start
            },
        );
    }
    let no_rate = |points: &Signal<attia2003::Points<f64>>| Signal {
        rate: f64::NAN,
        ..height(points)
    };
    demand(&no_rate, height_at_start);
    for dt in [f64::NAN, f64::INFINITY] {
        let mut led = start;
        let target = &height_at_start;
        let step = Leader::default().step(&case.model, &inputs, height, target, dt, &mut led);
        assert_eq!((step, led), (Err(SolveError::StepNotFinite), start));
    }
}

suspension_core::linkage! {
    /// An arm about a line along y, near the place where its reach is greatest.
    mod arm {
        fixed: rear at [0.0, 0.0, 0.0], front at [0.0, 1.0, 0.0];
        free: tip at [-0.5, 0.0, 0.002];
        hinge arm: rear, front -> tip;
        drive lift: tip.z;
    }
}

/// The first step from rest stays on its side of the turning point, as every other step does.
#[test]
fn a_first_led_step_does_not_pass_the_turning_point_behind() {
    let corner = arm::Corner::<f64>::design().expect("a regular design");
    let inputs = Inputs::still(Signal::still(corner.drives()));
    let reach = |points: &Signal<arm::Points<f64>>| points.map(|points| points.tip.x);
    let start = reach(&corner.points()).value;
    let curve = Curve::new(corner.model(), &inputs, 0).expect("a drive");
    for by in [4e-5, 1e-4, 4e-3, 0.05] {
        let target = |t: f64| Signal {
            value: start + by * t,
            rate: by,
            second_rate: 0.0,
        };
        let mut led = Led::at_rest(&curve, &corner.motion().position).expect("regular");
        let ends = [0.0, 1.0];
        let advanced =
            Leader::default().advance(corner.model(), |_| inputs, reach, target, ends, &mut led);
        advanced.expect("away from the turning point");
        let tip = led.points(corner.model(), &inputs).value.tip;
        assert!((tip.x - start - by).abs() < 1e-14, "{by}: {tip:?}");
        assert!(tip.z > 0.002, "{by}: {tip:?}");
    }
}

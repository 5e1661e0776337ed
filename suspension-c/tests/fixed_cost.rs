//! Steps of fixed cost: for each number of corrections the results of the core, bit for bit.
#![allow(unsafe_code, reason = "it takes what C would pass")]

mod five_link;

use five_link::{DESIGN, at_rest, inputs, made, model};
use suspension_c::catalogue::five_link_f32::{self, Drives, Inputs, Model, Motion};
use suspension_c::of::f32::Report;
use suspension_c::{In, InOut, Out, Status};
use suspension_core::linkages::five_link as core_link;
use suspension_core::nalgebra::Vector3;
use suspension_core::step::bounded::{Outputs, Refusal};
use suspension_core::{Bounded, Build, Linkage, Motion as CoreMotion, Signal, Values};

/// SUSP_ACCELERATION.
const ALL: i32 = 2;
const STEP: f32 = 1e-3;
/// The step before which the drive jumps.
const JUMP: u16 = 100;

type Attempt = extern "C" fn(
    In<'_, Model>,
    In<'_, Inputs>,
    i32,
    f32,
    InOut<'_, Motion>,
    Out<'_, Report>,
) -> Status;

/// Follows a drive that turns at a constant rate and jumps once, in C and in Rust, and compares; returns
/// the first step that both refuse.
fn compare<const CORRECTIONS: usize>(attempt: Attempt, jump: f32) -> Option<u16> {
    let points = core_link::Points::from_values(DESIGN.values.map(Vector3::from));
    let own = core_link::Model::new(&points).expect("a model");
    let mut expected = CoreMotion::at_rest(own.unknowns(&points));
    let (design, rate) = (own.drives_at(&points).theta, 0.5);
    let (model, mut motion) = (model(), at_rest());
    for index in 0..200 {
        let dt = if index == 0 { 0.0 } else { STEP };
        let jumped = if index < JUMP { 0.0 } else { jump };
        let value = design + rate * STEP * f32::from(index) + jumped;
        let given = inputs(Drives { values: [value] }, rate);
        let (moving, to) = ((&mut motion).into(), (&given).into());
        let status = attempt((&model).into(), to, ALL, dt, moving, None.into());
        let drives = Signal {
            value: core_link::Drives { theta: value },
            rate: core_link::Drives { theta: rate },
            second_rate: core_link::Drives::default(),
        };
        let inputs = suspension_core::Inputs::still(drives);
        let bounded = Bounded::<f32, CORRECTIONS>::new();
        let stepped = bounded.attempt(Outputs::Acceleration, &own, &inputs, dt, &mut expected);
        assert_eq!(status == Status::Ok, stepped.is_ok(), "{index}: {status:?}");
        let read = made(|points| {
            let motion = (&motion).into();
            five_link_f32::read_points((&model).into(), (&given).into(), motion, points)
        });
        let (found, expected) = (read.expect("points"), expected.points(&own, &inputs));
        for (found, expected) in [
            (found.value, expected.value),
            (found.rate, expected.rate),
            (found.second_rate, expected.second_rate),
        ] {
            let expected: Vec<[f32; 3]> = expected.values().map(Into::into).collect();
            assert_eq!(found.values.as_slice(), expected, "{index}");
        }
        if let Err(refusal) = stepped {
            assert_ne!(refusal, Refusal::Unhealthy);
            return Some(index);
        }
    }
    None
}

#[test]
fn bounded_steps_of_any_corrections_follow_smooth_drives() {
    for refused in [
        compare::<0>(five_link_f32::attempt_without_corrections, 0.0),
        compare::<1>(five_link_f32::attempt, 0.0),
        compare::<2>(five_link_f32::attempt_twice, 0.0),
    ] {
        assert_eq!(refused, None);
    }
}

/// Larger jumps need more corrections.
#[test]
fn a_larger_jump_of_a_drive_needs_more_corrections() {
    assert_eq!(
        compare::<0>(five_link_f32::attempt_without_corrections, 2e-3),
        Some(JUMP)
    );
    assert_eq!(compare::<1>(five_link_f32::attempt, 2e-3), None);
    assert_eq!(compare::<1>(five_link_f32::attempt, 5e-3), Some(JUMP));
    assert_eq!(compare::<2>(five_link_f32::attempt_twice, 5e-3), None);
}

/// Adapts a step of fixed cost to [`Attempt`], which has no failure.
macro_rules! without_failure {
    ($name:ident, $step:ident) => {
        extern "C" fn $name(
            model: In<'_, Model>,
            inputs: In<'_, Inputs>,
            outputs: i32,
            dt: f32,
            motion: InOut<'_, Motion>,
            report: Out<'_, Report>,
        ) -> Status {
            five_link_f32::$step(model, inputs, outputs, dt, motion, report, None.into())
        }
    };
}

without_failure!(step, bounded_step);
without_failure!(step_twice, bounded_step_twice);

/// They compute what an accepted attempt does.
#[test]
fn steps_that_explain_refusals_compute_the_same_as_attempts() {
    assert_eq!(compare::<1>(step, 2e-3), None);
    assert_eq!(compare::<1>(step, 5e-3), Some(JUMP));
    assert_eq!(compare::<2>(step_twice, 5e-3), None);
}

/// An attempt does not search for the reason.
#[test]
fn a_nan_input_overflows_in_an_attempt_and_is_not_finite_in_a_step() {
    let (model, given) = (model(), inputs(Drives { values: [f32::NAN] }, 0.0));
    let status = |call: Attempt| {
        let mut motion = at_rest();
        let (to, moving) = ((&given).into(), (&mut motion).into());
        call((&model).into(), to, ALL, STEP, moving, None.into())
    };
    assert_eq!(status(five_link_f32::attempt), Status::Overflow);
    assert_eq!(status(step), Status::NotFinite);
}

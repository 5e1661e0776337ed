//! Motion ratios, and drives that are followed as far as they lead: the results of the core, bit for bit.
#![allow(unsafe_code, reason = "it takes what C would pass")]

mod five_link;

use std::mem::MaybeUninit;

use five_link::{DESIGN, at_rest, inputs, made, model};
use suspension_c::Status;
use suspension_c::catalogue::five_link_f32::{
    self, Drives, Equations, Inputs, MeasureRates, PointRates, Points,
};
use suspension_c::of::f32::{Failure, Report, WheelRates};
use suspension_core::linkages::five_link::{self as core_link, Corner};
use suspension_core::nalgebra::Vector3;
use suspension_core::{Signal, Values};

fn corner() -> Corner<f32> {
    let points = DESIGN.values.map(Vector3::from);
    Corner::new(&core_link::Points::from_values(points)).expect("a regular design")
}

fn design_inputs() -> Inputs {
    let model = model();
    let drives =
        made(|drives| five_link_f32::model_drives((&model).into(), (&DESIGN).into(), drives));
    inputs(drives.expect("drives"), 0.0)
}

fn ratios(inputs: &Inputs, change: f32) -> Result<(PointRates, MeasureRates), Status> {
    let (model, motion, change) = (model(), at_rest(), Drives { values: [change] });
    let points = made(|points| {
        let (motion, change) = ((&motion).into(), (&change).into());
        let inputs = inputs.into();
        five_link_f32::read_derivatives(
            (&model).into(),
            inputs,
            motion,
            change,
            points,
            None.into(),
        )
    })?;
    let measures =
        made(|measures| five_link_f32::read_measures((&model).into(), (&points).into(), measures))?;
    Ok((points, measures))
}

#[test]
fn motion_ratios_at_rest_equal_those_of_the_rust_corner() {
    let (points, measures) = ratios(&design_inputs(), 1.0).expect("regular");
    let expected = corner().per(core_link::Drives { theta: 1.0 });
    let expected = expected.expect("regular");
    for (found, expected) in [
        (points.value, expected.points.value),
        (points.rate, expected.points.rate),
        (points.second_rate, expected.points.second_rate),
    ] {
        let expected: Vec<[f32; 3]> = expected.values().map(Into::into).collect();
        assert_eq!(found.values.as_slice(), expected);
    }
    let [found] = measures.rate.values;
    assert_eq!(found, expected.measures.rate.height);
    assert!(found.abs() > 0.1, "{found}");
    let [found] = measures.second_rate.values;
    assert_eq!(found, expected.measures.second_rate.height);
    let wheel: WheelRates =
        made(|wheel| five_link_f32::wheel::read_wheel_rates((&points).into(), wheel))
            .expect("a wheel");
    let expected = corner().wheel_rates(&expected.points).expect("a wheel");
    let (found, expected) = (wheel.second_rate, expected.second_rate);
    assert_eq!((found.camber, found.toe), (expected.camber, expected.toe));
    assert!(wheel.rate.camber.abs() > 0.01, "{wheel:?}");
    assert_eq!(ratios(&design_inputs(), f32::NAN), Err(Status::Overflow));
}

/// The work of forces on the knuckle is the load on the drive; the multiplier of a link is the force in it.
#[test]
fn the_force_on_the_drive_is_the_virtual_work_of_the_loads() {
    let (model, motion, inputs) = (model(), at_rest(), design_inputs());
    let forces = Points {
        values: [[10.0, -20.0, 400.0]; 11],
    };
    let mut equations = MaybeUninit::uninit();
    let drives = made(|drives| {
        let (forces, equations) = ((&forces).into(), (&mut equations).into());
        five_link_f32::read_loads(
            (&model).into(),
            (&inputs).into(),
            (&motion).into(),
            forces,
            drives,
            equations,
            None.into(),
        )
    });
    let [borne] = drives.expect("regular").values;
    // SAFETY: the status `Ok` means that they are written.
    let equations: Equations = unsafe { equations.assume_init() };
    let (points, _) = ratios(&inputs, 1.0).expect("regular");
    let moved = points.rate.values.iter();
    let work: f32 = moved.map(|[x, y, z]| 10.0 * x - 20.0 * y + 400.0 * z).sum();
    assert!((borne - work).abs() < 1e-4 * work.abs(), "{borne} {work}");

    let corner = corner();
    let forces = core_link::Points::from_values(forces.values.map(Vector3::from));
    let statics = corner.statics().expect("regular");
    let loads = statics.under(&forces).expect("finite");
    let track_rod = loads.by(4..5).track_rod_inner.norm();
    assert!((equations.values[4].abs() - track_rod).abs() < 1e-4 * track_rod);
}

/// Returns the status, the inputs that were reached, and the report or the failure.
fn advance(to: f32) -> (Status, Inputs, PointRates, Option<Report>, Option<Failure>) {
    let (model, mut motion, mut reached) = (model(), at_rest(), design_inputs());
    let to = inputs(Drives { values: [to] }, 0.5);
    let mut report = MaybeUninit::uninit();
    let mut failure = MaybeUninit::uninit();
    let status = five_link_f32::advance(
        (&model).into(),
        (&mut reached).into(),
        (&to).into(),
        1.0,
        (&mut motion).into(),
        (&mut report).into(),
        (&mut failure).into(),
    );
    let is_done = status == Status::Ok;
    // SAFETY: the status `Ok` means that the report is written, any other that the failure is.
    let report = is_done.then(|| unsafe { report.assume_init() });
    // SAFETY: as above.
    let failure = (!is_done).then(|| unsafe { failure.assume_init() });
    let points = made(|points| {
        let (inputs, motion) = ((&reached).into(), (&motion).into());
        five_link_f32::read_points((&model).into(), inputs, motion, points)
    });
    (status, reached, points.expect("points"), report, failure)
}

#[test]
fn advance_reaches_the_end_or_the_lock_as_in_rust() {
    let rates = |to| Signal {
        value: core_link::Drives { theta: to },
        rate: core_link::Drives { theta: 0.5 },
        ..Signal::default()
    };
    for (to, leads) in [(1.6, true), (3.0, false)] {
        let mut corner = corner();
        let expected = corner.step_towards(1.0, rates(to));
        let (status, reached, points, report, failure) = advance(to);
        assert_eq!(status == Status::Ok, leads, "{status:?}");
        assert_eq!(expected.is_ok(), leads);
        assert_eq!(reached.value.values, [corner.drives().theta]);
        let expected: Vec<[f32; 3]> = corner.points().rate.values().map(Into::into).collect();
        assert_eq!(points.rate.values.as_slice(), expected);
        if leads {
            assert_eq!(reached.value.values, [to]);
            assert!(report.is_some_and(|report| report.steps >= 1));
        } else {
            let failure = failure.expect("a failure");
            assert_eq!(failure.reached, corner.time());
            assert!((0.1..0.9).contains(&failure.reached), "{failure:?}");
            assert!(!failure.culprit.as_ptr().is_null());
        }
    }
}

/// A step that reaches nothing changes nothing, second rates included.
#[test]
fn an_advance_that_fails_at_its_start_leaves_the_inputs_unchanged() {
    let (model, mut motion, mut reached) = (model(), at_rest(), design_inputs());
    reached.second_rate.values = [0.25];
    let (before, to) = (reached, inputs(reached.value, f32::NAN));
    let status = five_link_f32::advance(
        (&model).into(),
        (&mut reached).into(),
        (&to).into(),
        1.0,
        (&mut motion).into(),
        None.into(),
        None.into(),
    );
    assert_ne!(status, Status::Ok);
    assert_eq!(reached, before);
}

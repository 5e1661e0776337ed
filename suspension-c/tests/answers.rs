//! Results of functions: failures with the names of the parts concerned, names, moving chassis.
#![allow(unsafe_code, reason = "it reads text as C does")]

mod five_link;

use std::ffi::{CStr, c_char};
use std::mem::MaybeUninit;

use five_link::{DESIGN, at_rest, inputs, made, model};
use suspension_c::catalogue::five_link_f32::{
    self, ChassisRates, Drives, Inputs, Lengths, Model, Motion, PointRates, Points,
};
use suspension_c::of::f32::{Certificate, Failure, Kingpin, RigidMotion};
use suspension_c::{Out, Status, status_text};

/// Returns a text that lives as long as the program; `None` for NULL.
fn text(pointer: *const c_char) -> Option<&'static str> {
    // SAFETY: NULL, or a text that lives as long as the program.
    let text = (!pointer.is_null()).then(|| unsafe { CStr::from_ptr(pointer) });
    text.map(|text| text.to_str().expect("UTF-8"))
}

/// Returns the status of a call that must fail, and the name of its culprit.
fn failure(
    call: impl FnOnce(Out<'_, Failure>) -> Status,
) -> (Status, Option<&'static str>, Failure) {
    let mut memory = MaybeUninit::uninit();
    let status = call((&mut memory).into());
    assert_ne!(status, Status::Ok);
    // SAFETY: a status other than `Ok` means that the failure is written.
    let failure: Failure = unsafe { memory.assume_init() };
    assert_eq!(failure.status, status);
    (status, text(failure.culprit.as_ptr()), failure)
}

fn of_points(points: &Points) -> (Status, Option<&'static str>) {
    let mut model = MaybeUninit::<Model>::uninit();
    let size = size_of::<Model>();
    let (status, culprit, _) = failure(|failure| {
        five_link_f32::model_new((&mut model).into(), size, points.into(), failure)
    });
    (status, culprit)
}

#[test]
fn an_invalid_geometry_reports_the_point_or_length() {
    let mut points = DESIGN;
    points.values[7][1] = f32::NAN;
    assert_eq!(
        of_points(&points),
        (Status::PointNotFinite, Some("upper_rear_outer"))
    );
    points = DESIGN;
    points.values[5] = points.values[0];
    assert_eq!(of_points(&points), (Status::BadLength, Some("lower_front")));

    let mut model = model();
    let mut lengths: Lengths =
        made(|lengths| five_link_f32::model_lengths((&model).into(), lengths)).expect("lengths");
    lengths.values[5] *= 10.0;
    let before = lengths;
    let (status, culprit, _) = failure(|failure| {
        five_link_f32::model_set_lengths((&mut model).into(), (&lengths).into(), failure)
    });
    assert_eq!(
        (status, culprit),
        (Status::NotClosed, Some("upper_rear_outer"))
    );
    let after = made(|lengths| five_link_f32::model_lengths((&model).into(), lengths));
    assert_ne!(after.expect("lengths"), before);
}

/// The lower front link is perpendicular to y, along which its derivative is the first pivot.
#[test]
fn a_small_pivot_is_reported_and_the_model_is_built() {
    let mut points = DESIGN;
    points.values[5][1] = points.values[0][1];
    let mut memory = MaybeUninit::<Model>::uninit();
    let size = size_of::<Model>();
    let (status, culprit, _) = failure(|failure| {
        five_link_f32::model_new((&mut memory).into(), size, (&points).into(), failure)
    });
    assert_eq!((status, culprit), (Status::SmallPivot, Some("lower_front")));
    assert_eq!(status as i32, 26);
    // SAFETY: this status comes with a model.
    let model = unsafe { memory.assume_init() };
    let size = size_of::<Motion>();
    let mut motion: Motion = made(|motion| {
        five_link_f32::motion_at_rest((&model).into(), motion, size, (&points).into())
    })
    .expect("a motion");
    let drives: Drives =
        made(|drives| five_link_f32::model_drives((&model).into(), (&points).into(), drives))
            .expect("drives");
    let inputs = inputs(drives, 0.0);
    let (model, inputs) = ((&model).into(), (&inputs).into());
    let (report, failure) = (None.into(), None.into());
    let stepped = five_link_f32::step(model, inputs, 0.0, (&mut motion).into(), report, failure);
    assert_eq!(stepped, Status::Ok);
}

/// As `suspension.h` says of numbers.
#[test]
fn numbers_on_which_a_result_does_not_depend_are_not_examined() {
    let (model, mut motion) = (model(), at_rest());
    let (model, design) = ((&model).into(), (&DESIGN).into());
    let drives: Drives =
        made(|drives| five_link_f32::model_drives(model, design, drives)).expect("drives");
    let no_rate = inputs(drives, f32::NAN);
    let mut step = |outputs| {
        let motion = (&mut motion).into();
        let (report, failure) = (None.into(), None.into());
        five_link_f32::bounded_step(
            model,
            (&no_rate).into(),
            outputs,
            0.0,
            motion,
            report,
            failure,
        )
    };
    assert_eq!([0, 1].map(&mut step), [Status::Ok, Status::Overflow]);
    let size = size_of::<Motion>();
    let assembled: Result<Motion, Status> = made(|motion| {
        let (assembly, failure) = (None.into(), None.into());
        five_link_f32::assemble(
            model,
            (&no_rate).into(),
            design,
            motion,
            size,
            assembly,
            failure,
        )
    });
    assert!(assembled.is_ok());
}

#[test]
fn a_refused_step_reports_part_value_and_bound() {
    let (model, mut motion) = (model(), at_rest());
    let far = inputs(Drives { values: [3.0] }, 0.5);
    let (status, culprit, details) = failure(|failure| {
        let (model, motion) = ((&model).into(), (&mut motion).into());
        five_link_f32::bounded_step(model, (&far).into(), 2, 0.0, motion, None.into(), failure)
    });
    assert!(
        matches!(status, Status::Diverging | Status::NotConverged),
        "{status:?}"
    );
    assert!(culprit.is_some());
    assert!(
        details.value > details.bound && details.bound > 0.0,
        "{details:?}"
    );
    assert_eq!(
        text(status_text(status as i32).as_ptr()),
        status.text().to_str().ok()
    );
    assert_eq!(text(status_text(1000).as_ptr()), Some("no such status"));

    // The step starts at rest and goes beyond the reach of the drive; `reached` says how far it got.
    let start = step_from_rest(&model, &mut motion);
    let (_, _, details) = failure(|failure| {
        let (model, motion) = ((&model).into(), (&mut motion).into());
        let ends = ((&start).into(), (&far).into());
        five_link_f32::step_between(model, ends.0, ends.1, 1.0, motion, None.into(), failure)
    });
    assert!((0.1..0.9).contains(&details.reached), "{details:?}");
}

/// Returns the inputs of the design position, and changes the motion to the one with their rates.
fn step_from_rest(model: &Model, motion: &mut Motion) -> Inputs {
    let drives = made(|drives| five_link_f32::model_drives(model.into(), (&DESIGN).into(), drives));
    let inputs = inputs(drives.expect("drives"), 0.5);
    let status = five_link_f32::step(
        model.into(),
        (&inputs).into(),
        0.0,
        motion.into(),
        None.into(),
        None.into(),
    );
    assert_eq!(status, Status::Ok);
    inputs
}

#[test]
fn names_of_points_drives_and_lengths_are_in_member_order() {
    let points: Vec<_> = (0..12)
        .map(|index| text(five_link_f32::point_name(index).as_ptr()))
        .collect();
    assert_eq!(points[0], Some("lower_front_inner"));
    assert_eq!(points[10], Some("wheel_centre"));
    assert_eq!(points[11], None);
    assert_eq!(text(five_link_f32::drive_name(0).as_ptr()), Some("theta"));
    assert_eq!(
        text(five_link_f32::measure_name(0).as_ptr()),
        Some("height")
    );
    assert_eq!(
        text(five_link_f32::length_name(4).as_ptr()),
        Some("track_rod")
    );
    assert_eq!(text(five_link_f32::length_name(14).as_ptr()), None);
}

#[test]
fn certify_returns_radius_and_uniqueness_of_the_root() {
    let (model, mut motion) = (model(), at_rest());
    let inputs = step_from_rest(&model, &mut motion);
    let certificate: Certificate = made(|certificate| {
        let (model, motion) = ((&model).into(), (&motion).into());
        five_link_f32::certify(model, (&inputs).into(), motion, certificate, None.into())
    })
    .expect("a proof");
    assert!(
        certificate.radius < 1e-4 && certificate.unique_within > 1e-3,
        "{certificate:?}"
    );
}

#[test]
fn a_kingpin_without_a_direction_is_reported() {
    let model = model();
    let nowhere = Points {
        values: [[0.0; 3]; 11],
    };
    let points = PointRates {
        value: nowhere,
        rate: nowhere,
        second_rate: nowhere,
    };
    let kingpin = |points: &Points| {
        made::<Kingpin>(|kingpin| five_link_f32::kingpin::read_kingpin(points.into(), kingpin))
            .map(|_| ())
    };
    assert_eq!(kingpin(&DESIGN), Ok(()));
    assert_eq!(kingpin(&nowhere), Err(Status::NoDirection));
    let mut unknown = DESIGN;
    unknown.values.fill([f32::NAN; 3]);
    assert_eq!(kingpin(&unknown), Err(Status::NoDirection));
    // Lengths whose squares overflow or underflow are refused like zero.
    for length in [0.0, 1e-30, 1e30, f32::NAN] {
        let chassis = RigidMotion {
            rotation: [length, 0.0, 0.0, 0.0],
            position: [0.0; 3],
            velocity: [0.0; 3],
            acceleration: [0.0; 3],
            omega: [0.0; 3],
            alpha: [0.0; 3],
        };
        let carried = made::<PointRates>(|carried| {
            five_link_f32::carry((&chassis).into(), (&points).into(), carried)
        });
        assert_eq!(carried.err(), Some(Status::Argument));
        let anchors = made::<ChassisRates>(|anchors| {
            five_link_f32::move_chassis((&model).into(), (&chassis).into(), anchors)
        });
        assert_eq!(anchors.err(), Some(Status::Argument));
    }
}

/// A chassis that turns about the vertical alone, which does not change an angle from the vertical, the
/// drive.
const CHASSIS: RigidMotion = RigidMotion {
    rotation: [0.8, 0.0, 0.0, 0.6],
    position: [3.0, -2.0, 1.0],
    velocity: [1.0, 2.0, -0.5],
    acceleration: [0.1, -0.2, 0.3],
    omega: [0.0, 0.0, 0.7],
    alpha: [0.0, 0.0, -0.4],
};

#[test]
fn solving_in_world_axes_agrees_with_carrying_the_points_there() {
    let model = model();
    let mut motion = at_rest();
    let inputs = step_from_rest(&model, &mut motion);
    let points: PointRates = made(|points| {
        five_link_f32::read_points((&model).into(), (&inputs).into(), (&motion).into(), points)
    })
    .expect("points");
    let carried: PointRates =
        made(|carried| five_link_f32::carry((&CHASSIS).into(), (&points).into(), carried))
            .expect("carried");
    let solved = solved_in_the_world(&model, &inputs, &carried.value);
    for (solved, carried, allowed) in [
        (solved.value, carried.value, 2e-6),
        (solved.rate, carried.rate, 2e-5),
        (solved.second_rate, carried.second_rate, 2e-4),
    ] {
        let solved = solved.values.as_flattened().iter();
        for (solved, carried) in solved.zip(carried.values.as_flattened()) {
            assert!((solved - carried).abs() < allowed, "{solved} {carried}");
        }
    }
}

/// Steps with chassis points that move, from rest at a position: by a step to tolerance and one of fixed
/// cost.
fn solved_in_the_world(model: &Model, inputs: &Inputs, start: &Points) -> PointRates {
    let anchors: ChassisRates =
        made(|anchors| five_link_f32::move_chassis(model.into(), (&CHASSIS).into(), anchors))
            .expect("anchors");
    let mut motion: Motion = made(|motion| {
        five_link_f32::motion_at_rest(model.into(), motion, size_of::<Motion>(), start.into())
    })
    .expect("a motion");
    let stepped = five_link_f32::moving_step(
        model.into(),
        (&anchors).into(),
        inputs.into(),
        0.0,
        (&mut motion).into(),
        None.into(),
        None.into(),
    );
    assert_eq!(stepped, Status::Ok);
    let stepped = five_link_f32::moving_bounded_step(
        model.into(),
        (&anchors).into(),
        inputs.into(),
        2,
        0.0,
        (&mut motion).into(),
        None.into(),
        None.into(),
    );
    assert_eq!(stepped, Status::Ok);
    made(|points| {
        let (model, anchors, motion) = (model.into(), (&anchors).into(), (&motion).into());
        five_link_f32::moving_read_points(model, anchors, inputs.into(), motion, points)
    })
    .expect("points")
}

//! The functions called from Rust as C would, which Miri can check
//! (`cargo +nightly miri test -p suspension-c --test pointers`).

#![allow(unsafe_code, reason = "it takes what C would pass")]

mod five_link;

use std::mem::MaybeUninit;

use five_link::{DESIGN, at_rest, inputs, made, model};
use suspension_c::catalogue::five_link_f32::{self, Drives, PointRates};
use suspension_c::of::f32::{BakedWheelRates, Curve, Failure, look_up_wheel};
use suspension_c::{In, InOut, Status};
use suspension_core::baked;

#[test]
fn a_bounded_step_from_rest_gives_points_and_rates() {
    let (model, mut motion) = (model(), at_rest());
    let drives =
        made(|drives| five_link_f32::model_drives((&model).into(), (&DESIGN).into(), drives));
    let inputs = inputs(drives.expect("drives"), 0.5);
    let status = five_link_f32::bounded_step(
        (&model).into(),
        (&inputs).into(),
        2,
        0.0,
        (&mut motion).into(),
        None.into(),
        None.into(),
    );
    assert_eq!(status, Status::Ok);
    let points: PointRates = made(|points| {
        five_link_f32::read_points((&model).into(), (&inputs).into(), (&motion).into(), points)
    })
    .expect("points");
    let found = points.value.values.as_flattened();
    for (found, design) in found.iter().zip(DESIGN.values.as_flattened()) {
        assert!((found - design).abs() < 1e-6, "{found} {design}");
    }
    assert!(points.rate.values[5][2] < -0.1);
}

#[test]
fn null_misaligned_and_foreign_objects_are_refused() {
    let motion = at_rest();
    // SAFETY: null, misaligned, or to an object of another kind, which the function refuses.
    let wrong = unsafe {
        [
            (In::from_raw(std::ptr::null()), Status::Null),
            (
                In::from_raw((&raw const motion).cast::<u8>().wrapping_add(1).cast()),
                Status::Misaligned,
            ),
            (In::from_raw((&raw const motion).cast()), Status::Object),
        ]
    };
    for (model, expected) in wrong {
        let mut motion = at_rest();
        let answered = made(|lengths| five_link_f32::model_lengths(model, lengths));
        assert_eq!(answered, Err(expected));
        let mut failure = MaybeUninit::<Failure>::uninit();
        let inputs = inputs(Drives { values: [1.0] }, 0.0);
        let status = five_link_f32::step(
            model,
            (&inputs).into(),
            0.001,
            InOut::from(&mut motion),
            None.into(),
            (&mut failure).into(),
        );
        assert_eq!(status, expected);
        // SAFETY: a status other than `Ok` means that the failure is written.
        assert_eq!(unsafe { failure.assume_init() }.status, expected);
    }
}

/// `x`, `x^2` ... `x^5` and 1, for x from 0 to 4.
static TABLE: [[[f32; 6]; 6]; 2] = [
    [
        [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
        [2.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 4.0, 0.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 8.0, 0.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 16.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 32.0, 0.0],
    ],
    [
        [2.0, 4.0, 8.0, 16.0, 32.0, 1.0],
        [2.0, 8.0, 24.0, 64.0, 160.0, 0.0],
        [0.0, 4.0, 24.0, 96.0, 320.0, 0.0],
        [0.0, 0.0, 8.0, 64.0, 320.0, 0.0],
        [0.0, 0.0, 0.0, 16.0, 160.0, 0.0],
        [0.0, 0.0, 0.0, 0.0, 32.0, 0.0],
    ],
];

#[test]
fn a_baked_wheel_equals_that_of_the_core() {
    let flat = TABLE.as_flattened().as_flattened();
    let curve = |numbers: &'static [f32]| Curve {
        range: [0.0, 4.0],
        segments_per_unit: 0.5,
        coefficients: numbers.into(),
    };
    let look_up = |numbers, drive| {
        let curve = curve(numbers);
        made::<BakedWheelRates>(|wheel| look_up_wheel((&curve).into(), drive, 1.5, -0.7, wheel))
    };
    let core = baked::Curve {
        range: [0.0, 4.0],
        segments_per_unit: 0.5,
        segments: &TABLE,
    };
    for drive in [0.0_f32, 0.3, 1.9, 2.0, 3.3, 4.0] {
        let found = look_up(flat, drive).expect("in range");
        let expected = core.at(drive).expect("in range").acceleration(1.5, -0.7);
        for (found, expected) in [found.value, found.rate, found.second_rate]
            .iter()
            .zip(expected)
        {
            assert_eq!([found.centre, found.axis].as_flattened(), expected);
        }
    }
    assert_eq!(look_up(flat, 4.1).unwrap_err(), Status::Outside);
    assert_eq!(look_up(flat, f32::NAN).unwrap_err(), Status::Outside);
    assert_eq!(look_up(&flat[1..], 1.0).unwrap_err(), Status::Argument);
    assert_eq!(look_up(&flat[..0], 1.0).unwrap_err(), Status::Argument);
    // Half of the coefficients, and a number of segments per unit that does not belong to this table.
    assert_eq!(look_up(&flat[36..], 1.0).unwrap_err(), Status::Argument);
    for segments_per_unit in [-1.0, 0.0, 1.0, f32::NAN] {
        let curve = Curve {
            segments_per_unit,
            ..curve(flat)
        };
        let found =
            made::<BakedWheelRates>(|wheel| look_up_wheel((&curve).into(), 1.0, 1.5, -0.7, wheel));
        assert_eq!(found.unwrap_err(), Status::Argument, "{segments_per_unit}");
    }
}

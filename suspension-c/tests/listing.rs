//! Listings from text: their contents and their motion.
#![allow(unsafe_code, reason = "it takes what C would pass")]

#[path = "listing/loads.rs"]
mod loads;
mod text;

use std::ffi::{CStr, c_char};

use suspension_c::Status;
use suspension_c::listing::{self, Listing};
use suspension_c::of::f64::{CarrierRotation, Kingpin, Wheel};
use suspension_core::Signal;
use suspension_core::linkages::double_wishbone_pushrod::{self as compiled, Drives};
use text::{DRIVE, MEASURE, PART, POINT, Read, from, made, placed, pushrod, to};

/// A crank: no wheel, no measure, and a point without a position.
const CRANK: &str = "fixed: hinge at [0.0, 0.0, 0.0];
    free: tip;
    link arm: hinge -> tip;
    drive turn: angle(hinge -> tip, z);
    drive along: tip.x;";

/// Returns a text that lives as long as the program or a listing of the test; `None` for NULL.
fn name(pointer: *const c_char) -> Option<String> {
    // SAFETY: NULL, or such a text.
    let name = (!pointer.is_null()).then(|| unsafe { CStr::from_ptr(pointer) });
    name.map(|name| name.to_str().expect("UTF-8").to_owned())
}

#[test]
fn every_mistake_in_a_listing_is_reported_with_line_and_column() {
    let mistakes = |text| Read::new(text).err().expect("mistakes");
    let reported = mistakes("fixed: a;\nfree: p, p;\nlink rod: a -> q;\ndrive y: p.y;\n");
    let lines: Vec<&str> = reported.lines().collect();
    assert!(lines.len() >= 2, "{reported}");
    assert!(
        lines.iter().any(|line| line.starts_with("listing:2:10: ")),
        "{reported}"
    );
    assert!(
        lines.iter().any(|line| line.starts_with("listing:3:16: ")),
        "{reported}"
    );
    assert!(mistakes("").starts_with("listing:1:1: "));
}

/// What `suspension list` prints of a motion file with includes and mirrors.
#[test]
fn the_printed_listing_of_an_imported_axle_is_read_with_its_positions() {
    let text = include_str!("../../tests/data/imported_axle.linkage");
    let listing = Read::new(text).expect("a listing");
    assert_eq!((listing.count(POINT), listing.count(DRIVE)), (21, 3));
    let ball = listing.find(POINT, c"right_lower_ball").expect("a point");
    let design = listing.design();
    assert_eq!(design[3 * ball..3 * ball + 3], [4.0, -560.0, 128.0]);
    let corner = listing.place(&design).map_err(|failure| failure.status);
    assert!(corner.is_ok(), "{:?}", corner.err());
}

#[test]
fn a_message_is_truncated_at_the_size_of_its_buffer() {
    let text = "fixed: \u{e9}\u{e9} at [0.0];".as_bytes();
    let message = |text: &[u8], size: usize| {
        let mut message = [b'?'; 64];
        let parsed = made(|listing| {
            let (length, place) = (text.len(), to(&mut message));
            listing::listing_parse(from(text), length, listing, place, size, None.into())
        });
        assert_eq!(parsed.map(|_: *mut Listing| ()), Err(Status::Listing));
        message
    };
    assert_eq!(message(text, 0), [b'?'; 64]);
    assert_eq!(message(text, 1)[..2], *b"\0?");
    assert_eq!(message(text, 9)[..10], *b"listing:\0?");
    let not_utf8 = message(b"fixed: \xff", 64);
    assert!(not_utf8.starts_with(b"listing: after 7 bytes"));
    let whole = message(text, 64);
    let cut = CStr::from_bytes_until_nul(&whole).expect("closed");
    assert!(cut.to_str().is_ok());
}

#[test]
fn parts_of_a_listing_are_found_by_number_and_by_name() {
    let listing = pushrod();
    assert_eq!(listing.count(POINT), 20);
    assert_eq!((listing.count(DRIVE), listing.count(MEASURE)), (2, 2));
    for kind in [POINT, DRIVE, MEASURE, PART] {
        for index in 0..listing.count(kind) {
            let text = listing::listing_name(listing.get(), kind, index).as_ptr();
            // SAFETY: the text lives as long as the listing.
            let found = listing.find(kind, unsafe { CStr::from_ptr(text) });
            assert_eq!(found, Ok(index));
        }
    }
    let of = |kind, index| name(listing::listing_name(listing.get(), kind, index).as_ptr());
    assert_eq!(of(DRIVE, 1).as_deref(), Some("steer"));
    assert_eq!(of(POINT, 19).as_deref(), Some("axle"));
    assert_eq!(of(POINT, 20), None);
    assert_eq!(of(PART, 0).as_deref(), Some("lower_wishbone"));
    assert_eq!(of(5, 0), None);
    assert_eq!(listing.find(POINT, c"nowhere"), Err(Status::Absent));
    assert_eq!(listing.find(-1, c"axle"), Err(Status::Argument));
}

#[test]
fn an_invalid_geometry_of_a_listing_names_the_point() {
    let listing = Read::new(CRANK).expect("a listing");
    let mut points = listing.design();
    let failure = listing
        .place(&points)
        .err()
        .expect("a point that is not stated");
    assert_eq!(failure.status, Status::PointNotFinite);
    assert_eq!(name(failure.culprit.as_ptr()).as_deref(), Some("tip"));
    points[3..].copy_from_slice(&[0.0; 3]);
    let failure = listing.place(&points).err().expect("no length");
    assert_eq!(failure.status, Status::BadLength);
    assert_eq!(name(failure.culprit.as_ptr()).as_deref(), Some("arm"));
    points[3..].copy_from_slice(&[0.0, 0.4, 0.3]);
    let mut crank = listing.place(&points).expect("a crank");
    drop(listing);
    crank.step([1.0, 0.0], true).expect("a step");
    assert_eq!(
        made::<Wheel>(|wheel| listing::corner_read_wheel(crank.get(), wheel)).err(),
        Some(Status::Absent)
    );
    assert_eq!(
        made::<Kingpin>(|kingpin| listing::corner_read_kingpin(crank.get(), kingpin)).err(),
        Some(Status::Absent)
    );
    assert_eq!(
        made::<CarrierRotation>(|rotation| listing::corner_read_rotation(crank.get(), rotation))
            .err(),
        Some(Status::Absent)
    );
}

/// Steps beyond the reach of the drive, from C and from the corner in Rust.
#[test]
fn a_refused_step_stays_and_a_stopped_advance_keeps_its_progress() {
    let (mut stays, mut goes) = (placed(), placed());
    let mut compiled = compiled::Corner::<f64>::design().expect("a geometry");
    let Drives { bump, steer } = compiled.drives();
    let far = Signal::still(Drives {
        bump: bump + 1.0,
        steer,
    });
    let stopped = compiled
        .step_towards(0.5, far)
        .expect_err("beyond reach")
        .error;

    let failure = stays
        .step([bump + 1.0, steer], true)
        .expect_err("beyond reach");
    assert_eq!((stays.time(), stays.drives()), (0.0, [bump, steer]));
    assert_eq!(failure.reached, stopped.reached);
    assert!(name(failure.culprit.as_ptr()).is_some());

    let failure = goes
        .step([bump + 1.0, steer], false)
        .expect_err("beyond reach");
    assert_eq!(failure.reached, stopped.reached);
    assert_eq!(goes.time(), compiled.time());
    assert_eq!(goes.drives(), [compiled.drives().bump, steer]);
    assert!((0.05..0.45).contains(&goes.time()), "{}", goes.time());
}

/// A copy continues with the same bits, even if the original has moved on or is freed.
#[test]
fn a_copy_of_a_corner_moves_independently_of_the_original() {
    let listing = pushrod();
    let mut corner = listing.place(&listing.design()).expect("a corner");
    let [bump, steer] = corner.drives();
    corner
        .step([bump + 0.02, steer], true)
        .expect("within reach");
    let mut copy = corner.copied();
    let mut other = corner.copied();
    drop(listing);
    corner
        .step([bump + 0.9, steer], false)
        .expect_err("beyond a lock");
    drop(corner);
    for corner in [&mut copy, &mut other] {
        assert_eq!(
            (corner.time(), corner.drives()),
            (0.5, [bump + 0.02, steer])
        );
        corner
            .step([bump, steer + 0.01], true)
            .expect("within reach");
    }
    assert_eq!(copy.points(), other.points());
}

#[test]
fn a_corner_returned_to_a_state_repeats_its_steps() {
    let listing = pushrod();
    let mut corner = listing.place(&listing.design()).expect("a corner");
    let mut later = corner.copied();
    let [bump, steer] = corner.drives();
    let to = |travel: f64| [bump + travel, steer + 0.3 * travel];
    corner.step(to(0.02), true).expect("within reach");
    let state = corner.state();
    let steps = |corner: &mut text::Moving| {
        [0.03, 0.035, 0.01].map(|travel| {
            corner.step(to(travel), true).expect("within reach");
            corner.points()
        })
    };
    let first = steps(&mut corner);
    for corner in [&mut corner, &mut later] {
        assert_eq!(corner.set_state(&state), Status::Ok);
        assert_eq!((corner.time(), corner.drives()), (0.5, to(0.02)));
        assert_eq!(corner.state(), state);
        assert_eq!(steps(corner), first);
    }
}

#[test]
fn kingpin_rotation_and_measures_equal_those_of_the_rust_corner() {
    let mut corner = placed();
    let mut compiled = compiled::Corner::<f64>::design().expect("a geometry");
    let Drives { bump, steer } = compiled.drives();
    let drives = Drives {
        bump: bump + 0.03,
        steer: steer + 0.01,
    };
    compiled.step(0.5, Signal::still(drives)).expect("a step");
    let report = corner
        .step([drives.bump, drives.steer], true)
        .expect("a step");
    assert!(report.steps >= 1);

    let kingpin: Kingpin =
        made(|kingpin| listing::corner_read_kingpin(corner.get(), kingpin)).expect("a kingpin");
    let expected = compiled.kingpin().expect("a kingpin");
    assert_eq!(
        (kingpin.angle, kingpin.caster),
        (expected.angle, expected.caster)
    );
    let rotation: CarrierRotation =
        made(|rotation| listing::corner_read_rotation(corner.get(), rotation)).expect("a wheel");
    assert!(rotation.omega.iter().all(|rate| rate.abs() < 1e-9));
    let mut measures = [0.0; 6];
    assert_eq!(
        listing::corner_read_measures(corner.get(), to(&mut measures), 6),
        Status::Ok
    );
    let expected = compiled.measures();
    assert_eq!(measures[0], expected.value.damper);
    assert_eq!(measures[3], expected.rate.bar_arm);
    assert_eq!(measures[4], expected.second_rate.damper);
}

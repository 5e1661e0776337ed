//! Listings from text with several wheels, each of which is read by its number.
#![allow(unsafe_code, reason = "it takes what C would pass")]

mod text;

use suspension_c::Status;
use suspension_c::listing;
use suspension_c::of::f64::{CarrierRotation, Kingpin, Wheel, WheelRates};
use suspension_core::linkages::LISTINGS;
use suspension_core::{Signal, Values};
use suspension_runtime::Listing;
use text::{DRIVE, Moving, Read, WHEEL, from, made, pushrod};

/// Heights of the left and the right wheel, and the rack, relative to the design.
const MOVED: [(&std::ffi::CStr, f64); 3] = [
    (c"bump_left", 0.03),
    (c"bump_right", -0.02),
    (c"steer", 0.01),
];

fn axle() -> &'static str {
    let mut listings = LISTINGS.iter();
    let found = listings.find(|(name, _)| *name == "steered_axle");
    found.expect("an axle").1
}

/// Moves the axle of the catalogue in half a second to rest.
fn moved() -> (Read, Moving) {
    let read = Read::new(axle()).expect("a listing");
    let mut corner = read.place(&read.design()).expect("a geometry");
    let mut drives = [0.0; 9];
    let status = listing::corner_drives(corner.get(), text::to(&mut drives[..3]), 3);
    assert_eq!(status, Status::Ok);
    for (name, by) in MOVED {
        drives[read.find(DRIVE, name).expect("a drive")] += by;
    }
    let none = None.into();
    let status = listing::corner_step(corner.get_mut(), from(&drives), 9, 0.5, none, None.into());
    assert_eq!(status, Status::Ok);
    (read, corner)
}

/// The numbers agree with the corner in Rust, which finds wheels by name.
#[test]
fn wheels_and_kingpins_by_number_equal_those_by_name() {
    let (read, corner) = moved();
    let listing = Listing::parse(axle()).expect("a listing");
    let mut expected = listing
        .corner::<60>(&listing.design().expect("stated"))
        .expect("a geometry");
    let mut drives = expected.drives();
    for (name, by) in MOVED {
        let drive = listing
            .drive(name.to_str().expect("UTF-8"))
            .expect("a drive");
        let value = drives.values().nth(drive).expect("a value");
        drives = drives.with(drive, value + by);
    }
    expected.step(0.5, Signal::still(drives)).expect("a step");
    assert_eq!(read.count(WHEEL), 2);
    let mut cambers = Vec::new();
    for name in [c"left", c"right"] {
        let index = read.find(WHEEL, name).expect("a wheel");
        let wheel: Wheel = made(|wheel| listing::corner_read_wheel_at(corner.get(), index, wheel))
            .expect("a wheel");
        let kingpin: Kingpin =
            made(|kingpin| listing::corner_read_kingpin_at(corner.get(), index, kingpin))
                .expect("a kingpin");
        let (of_rust, kingpin_of_rust) = expected
            .wheel_named(name.to_str().expect("UTF-8"))
            .expect("a wheel");
        let kingpin_of_rust = kingpin_of_rust.expect("a kingpin");
        assert_eq!((wheel.camber, wheel.toe), (of_rust.camber, of_rust.toe));
        let rates: WheelRates =
            made(|wheel| listing::corner_read_wheel_rates(corner.get(), index, wheel))
                .expect("a wheel");
        assert_eq!((rates.value.camber, rates.rate.camber), (wheel.camber, 0.0));
        assert_eq!(
            (kingpin.angle, kingpin.caster),
            (kingpin_of_rust.angle, kingpin_of_rust.caster)
        );
        cambers.push(wheel.camber);
    }
    assert!((cambers[0] - cambers[1]).abs() > 1e-3, "{cambers:?}");
}

/// In an axle the bump drive of a wheel changes its camber, and not that of the other wheel.
#[test]
fn camber_gain_and_bump_steer_of_a_wheel_are_those_of_its_points() {
    let (read, corner) = moved();
    let mut change = [0.0; 3];
    change[read.find(DRIVE, c"bump_left").expect("a drive")] = 1.0;
    let derivatives = |index, count| {
        made::<WheelRates>(|wheel| {
            let change = from(&change);
            let none = None.into();
            listing::corner_read_wheel_derivatives(corner.get(), index, change, count, wheel, none)
        })
    };
    let [left, right] = [c"left", c"right"].map(|name| {
        let index = read.find(WHEEL, name).expect("a wheel");
        let wheel: Wheel = made(|wheel| listing::corner_read_wheel_at(corner.get(), index, wheel))
            .expect("a wheel");
        let derived = derivatives(index, 3).expect("regular");
        assert_eq!(derived.value.toe, wheel.toe);
        derived.rate
    });
    assert!(left.camber.abs() > 0.1 && left.camber_to_ground.abs() > 0.1 && left.toe != 0.0);
    assert!((left.centre[2] - 1.0).abs() < 1e-14);
    assert!(right.camber.abs() < 1e-14 && right.toe.abs() < 1e-14);
    assert_eq!(derivatives(0, 2).err(), Some(Status::Size));
    assert_eq!(derivatives(2, 3).err(), Some(Status::Absent));
}

/// The mirrored wheels rotate at opposite rates at a symmetric place.
#[test]
fn each_carrier_has_its_own_angular_velocity() {
    let read = Read::new(axle()).expect("a listing");
    let mut corner = read.place(&read.design()).expect("a geometry");
    let mut drives = [0.0; 9];
    listing::corner_drives(corner.get(), text::to(&mut drives[..3]), 3);
    let [left, right] =
        [c"bump_left", c"bump_right"].map(|name| read.find(DRIVE, name).expect("a drive"));
    (drives[3 + left], drives[3 + right]) = (0.1, 0.1);
    let none = None.into();
    let status = listing::corner_step(corner.get_mut(), from(&drives), 9, 1e-3, none, None.into());
    assert_eq!(status, Status::Ok);
    let omega = [0, 1].map(|wheel| {
        let rotation: CarrierRotation =
            made(|rotation| listing::corner_read_rotation_at(corner.get(), wheel, rotation))
                .expect("a wheel");
        rotation.omega
    });
    let [[x, y, z], [of_x, of_y, of_z]] = omega;
    assert!(x.abs() > 1e-3, "{omega:?}");
    for off in [x + of_x, y - of_y, z + of_z] {
        assert!(off.abs() < 1e-12, "{omega:?}");
    }
}

#[test]
fn the_first_wheel_needs_no_number_and_further_numbers_are_refused() {
    for (read, corner, wheels) in [
        {
            let (read, corner) = moved();
            (read, corner, 2)
        },
        (pushrod(), text::placed(), 1),
    ] {
        assert_eq!(read.count(WHEEL), wheels);
        let first: Wheel =
            made(|wheel| listing::corner_read_wheel(corner.get(), wheel)).expect("a wheel");
        let same: Wheel =
            made(|wheel| listing::corner_read_wheel_at(corner.get(), 0, wheel)).expect("a wheel");
        assert_eq!(first.camber.to_bits(), same.camber.to_bits());
        for index in [wheels, usize::MAX] {
            let corner = || corner.get();
            assert_eq!(
                made::<Wheel>(|wheel| listing::corner_read_wheel_at(corner(), index, wheel)).err(),
                Some(Status::Absent)
            );
            assert_eq!(
                made::<Kingpin>(|kingpin| listing::corner_read_kingpin_at(
                    corner(),
                    index,
                    kingpin
                ))
                .err(),
                Some(Status::Absent)
            );
            assert_eq!(
                made::<CarrierRotation>(|rotation| listing::corner_read_rotation_at(
                    corner(),
                    index,
                    rotation
                ))
                .err(),
                Some(Status::Absent)
            );
        }
    }
    assert_eq!(pushrod().find(WHEEL, c""), Ok(0));
    assert_eq!(pushrod().find(WHEEL, c"left"), Err(Status::Absent));
}

//! Weight and inertia of parts: the results of the core, bit for bit; a wrong mass is refused and adds
//! nothing.
#![allow(unsafe_code, reason = "it takes what C would pass")]

mod five_link;
mod text;

use suspension_c::catalogue::five_link_f32::{self, Points};
use suspension_c::listing;
use suspension_c::of::{f32 as of_f32, f64 as of_f64};
use suspension_c::shared::{Mass, Masses};
use suspension_c::{In, InOut, Status};
use suspension_core::inertia::{RigidBody, rod};
use suspension_core::linkages::double_wishbone_pushrod::{self as compiled, Drives};
use suspension_core::nalgebra::{Matrix3, Vector3};
use suspension_core::{Signal, Values};
use text::{POINT, from, placed, pushrod, to};

const GRAVITY: [f64; 3] = [0.3, -2.0, -9.81];
const CENTRE: [f64; 3] = [0.01, 0.72, 0.29];
const INERTIA: [f64; 6] = [0.5, 0.9, 0.6, 0.02, -0.03, 0.05];

fn mass(points: &[u32], mass: f64) -> Mass<f64> {
    let mut held = [0; 3];
    held[..points.len()].copy_from_slice(points);
    Mass {
        count: points.len() as u32,
        points: held,
        mass,
        centre: CENTRE,
        inertia: INERTIA,
    }
}

/// Returns masses in a field of gravity, which live for the rest of the test program.
fn in_field<T: Copy + 'static>(masses: &[Mass<T>], gravity: [T; 3]) -> Masses<T> {
    Masses::new(Box::leak(masses.into()), gravity)
}

/// Returns a pointer to numbers that are read and written.
fn both(numbers: &mut [f64]) -> InOut<'_, f64> {
    // SAFETY: tests state the length of the slice.
    unsafe { InOut::from_raw(numbers.as_mut_ptr()) }
}

/// Forces and loads on the drives of an upright with its wheel, a pushrod and masses at a joint and at a
/// marker, in a suspension that moves and accelerates.
#[test]
fn forces_of_masses_of_a_listing_equal_those_of_the_core() {
    let (listing, mut corner) = (pushrod(), placed());
    let number = |name| listing.find(POINT, name).expect("a point") as u32;
    let upright = [c"lower_ball", c"upper_ball", c"wheel_centre"].map(number);
    let pushrod = [c"pushrod_lower", c"pushrod_upper"].map(number);
    let masses = [
        mass(&upright, 20.0),
        mass(&pushrod, 1.2),
        mass(&[number(c"damper_outer")], 0.8),
        mass(&[number(c"axle")], 3.0),
    ];
    let masses = in_field(&masses, GRAVITY);
    let [bump, steer] = corner.drives();
    let drives = [[bump + 0.02, steer + 0.003], [0.7, -0.1], [5.0, 2.0]];
    let row = drives.as_flattened();
    let none = None.into();
    let stepped = listing::corner_step(corner.get_mut(), from(row), 6, 0.1, none, None.into());
    assert_eq!(stepped, Status::Ok);
    let design = listing.design();
    let count = design.len();
    let mut forces = vec![0.0; count];
    forces[3 * upright[2] as usize..][..3].copy_from_slice(&[-300.0, 200.0, 4000.0]);
    let added = listing::corner_add_masses(
        corner.get(),
        (&masses).into(),
        from(&design),
        count,
        both(&mut forces),
        count,
    );
    assert_eq!(added, Status::Ok);

    let mut same = compiled::Corner::<f64>::design().expect("a geometry");
    let stated = same.points().value;
    let of = |[bump, steer]: [f64; 2]| Drives { bump, steer };
    let [value, rate, second_rate] = drives.map(of);
    let to_there = Signal {
        value,
        rate,
        second_rate,
    };
    same.step(0.1, to_there).expect("a step");
    let expected = by_the_core(&stated, &same.points());
    let in_a_row: Vec<f64> = expected.values().flat_map(<[f64; 3]>::from).collect();
    assert_eq!(forces, in_a_row);

    let mut on_drives = [0.0; 2];
    let read = listing::corner_read_loads(
        corner.get(),
        from(&forces),
        count,
        to(&mut on_drives),
        2,
        None.into(),
        0,
        None.into(),
        0,
        None.into(),
    );
    assert_eq!(read, Status::Ok);
    for (unit, borne) in [[1.0, 0.0], [0.0, 1.0]].into_iter().zip(on_drives) {
        let moved = same.per(of(unit)).expect("regular").points.rate;
        let work = moved.values().zip(expected.values());
        let work: f64 = work.map(|(moved, force)| moved.dot(&force)).sum();
        assert!((borne - work).abs() < 1e-9 * work.abs(), "{borne} {work}");
    }
}

fn by_the_core(
    stated: &compiled::Points<f64>,
    moving: &Signal<compiled::Points<f64>>,
) -> compiled::Points<f64> {
    let held = |points: &compiled::Points<f64>| {
        [points.lower_ball, points.upper_ball, points.wheel_centre]
    };
    let (gravity, [xx, yy, zz, xy, yz, zx]) = (Vector3::from(GRAVITY), INERTIA);
    let upright = RigidBody {
        points: held(stated),
        mass: 20.0,
        centre: CENTRE.into(),
        inertia: Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz),
    };
    let mut forces = compiled::Points {
        wheel_centre: Vector3::new(-300.0, 200.0, 4000.0),
        ..Default::default()
    };
    let of_upright = upright.forces(&moving.map(held), &gravity);
    let [lower, upper, centre] = of_upright.expect("three points");
    forces.lower_ball += lower;
    forces.upper_ball += upper;
    forces.wheel_centre += centre;
    let accelerations = &moving.second_rate;
    let ends = [accelerations.pushrod_lower, accelerations.pushrod_upper];
    let [lower, upper] = rod(1.2, ends, &gravity);
    forces.pushrod_lower += lower;
    forces.pushrod_upper += upper;
    forces.damper_outer += (gravity - accelerations.damper_outer) * 0.8;
    forces.axle += (gravity - accelerations.axle) * 3.0;
    assert!(accelerations.axle.norm() > 3.0);
    forces
}

#[test]
fn a_wrong_mass_of_a_listing_is_refused_and_adds_no_force() {
    let (listing, corner) = (pushrod(), placed());
    let design = listing.design();
    let count = design.len();
    let add = |masses: In<'_, Masses<f64>>, [designed, loaded]: [usize; 2]| {
        let mut forces = vec![7.0; count];
        let status = listing::corner_add_masses(
            corner.get(),
            masses,
            from(&design),
            designed,
            both(&mut forces),
            loaded,
        );
        assert!(status == Status::Ok || forces == vec![7.0; count]);
        status
    };
    let whole = [count; 2];
    let wrong = wrong(12, count as u32 / 3);
    for (mass, expected) in &wrong {
        let masses = [self::mass(&[12], 1.0), *mass];
        let masses = in_field(&masses, GRAVITY);
        assert_eq!(add((&masses).into(), whole), *expected, "{mass:?}");
    }
    for points in [&[12][..], &[12, 13], &[12, 13, 14]] {
        for (mass, gravity) in [(1.0, [f64::INFINITY; 3]), (f64::MAX, GRAVITY)] {
            let too_large = in_field(&[self::mass(points, mass)], gravity);
            assert_eq!(add((&too_large).into(), whole), Status::Overflow);
        }
    }
    let good = in_field(&[mass(&[12], 1.0)], GRAVITY);
    for counts in [[count - 1, count], [count, count + 3]] {
        assert_eq!(add((&good).into(), counts), Status::Size);
    }
    // SAFETY: null, which the function refuses.
    let null = unsafe { In::from_raw(std::ptr::null()) };
    assert_eq!(add(null, whole), Status::Null);
    assert_eq!(add((&good).into(), whole), Status::Ok);
    let none = in_field(&[], GRAVITY);
    assert_eq!(add((&none).into(), whole), Status::Ok);
}

/// Invalid masses, where `point` is a valid point and there are `points` points.
fn wrong(point: u32, points: u32) -> Vec<(Mass<f64>, Status)> {
    let good = mass(&[point], 1.0);
    let body = mass(&[point, point + 1, point + 2], 1.0);
    vec![
        (Mass { count: 0, ..good }, Status::Argument),
        (Mass { count: 4, ..good }, Status::Argument),
        (mass(&[point], -1.0), Status::Argument),
        (mass(&[point], f64::NAN), Status::Argument),
        (
            Mass {
                centre: [f64::INFINITY; 3],
                ..body
            },
            Status::Argument,
        ),
        (
            Mass {
                inertia: [f64::NAN; 6],
                ..body
            },
            Status::Argument,
        ),
        (mass(&[points], 1.0), Status::Absent),
        (mass(&[point, u32::MAX], 1.0), Status::Absent),
        (mass(&[point, point, point], 1.0), Status::NoDirection),
    ]
}

/// Masses of a compiled linkage, of which point 10 is a marker.
#[test]
fn a_wrong_mass_of_a_linkage_is_refused_and_adds_no_force() {
    let design = five_link::DESIGN;
    let points = five_link::made(|points| {
        let drives = five_link_f32::Drives { values: [0.7] };
        let inputs = five_link::inputs(drives, 0.0);
        let (model, motion) = (five_link::model(), five_link::at_rest());
        five_link_f32::read_points((&model).into(), (&inputs).into(), (&motion).into(), points)
    });
    let points = points.expect("points");
    let add = |mass: of_f32::Mass| {
        let before = Points {
            values: [[7.0; 3]; 11],
        };
        let mut forces = before;
        let masses = in_field(&[mass], GRAVITY.map(|part| part as f32));
        let (masses, design) = ((&masses).into(), (&design).into());
        let points = (&points).into();
        let status = five_link_f32::add_masses(masses, design, points, (&mut forces).into());
        (status, forces != before)
    };
    for (mass, expected) in wrong(5, 11) {
        assert_eq!(add(rounded(&mass)), (expected, false), "{mass:?}");
    }
    for points in [&[5][..], &[5, 6], &[5, 6, 7]] {
        let too_large = rounded(&mass(points, f64::from(f32::MAX)));
        assert_eq!(add(too_large), (Status::Overflow, false), "{points:?}");
    }
    for point in [9, 10] {
        assert_eq!(add(rounded(&mass(&[point], 1.0))), (Status::Ok, true));
    }
}

fn rounded(mass: &of_f64::Mass) -> of_f32::Mass {
    Mass {
        count: mass.count,
        points: mass.points,
        mass: mass.mass as f32,
        centre: mass.centre.map(|part| part as f32),
        inertia: mass.inertia.map(|part| part as f32),
    }
}

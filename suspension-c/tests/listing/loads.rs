//! Loads on listings from text and their reactions.

use std::ffi::CStr;

use suspension_c::listing::{self, Corner};
use suspension_c::{In, Status};
use suspension_core::linkages::double_wishbone_pushrod::{self as compiled, Drives};
use suspension_core::nalgebra::Vector3;

use crate::text::{DRIVE, PART, POINT, Read, from, placed, pushrod, to};

/// The results of forces.
struct Loads {
    drives: Vec<f64>,
    tensions: Vec<f64>,
    reactions: Vec<f64>,
}

fn loads(listing: &Read, corner: In<'_, Corner>, forces: &[f64]) -> Loads {
    let [points, parts, count] = [POINT, PART, DRIVE].map(|kind| listing.count(kind));
    let [mut drives, mut tensions, mut reactions] =
        [count, parts, 3 * parts * points].map(|count| vec![0.0; count]);
    let status = listing::corner_read_loads(
        corner,
        from(forces),
        forces.len(),
        to(&mut drives),
        count,
        to(&mut tensions),
        parts,
        to(&mut reactions),
        3 * parts * points,
        None.into(),
    );
    assert_eq!(status, Status::Ok);
    Loads {
        drives,
        tensions,
        reactions,
    }
}

/// A weight on the wheel's marker: the drive bears it by virtual work, and the forces of each part are in
/// equilibrium: their sum and moment vanish.
#[test]
fn a_wheel_load_leaves_the_drive_and_every_part_in_equilibrium() {
    let (listing, corner) = (pushrod(), placed());
    let points = listing.count(POINT);
    let marker = listing.find(POINT, c"axle").expect("a marker");
    let mut forces = vec![0.0; 3 * points];
    forces[3 * marker..][..3].copy_from_slice(&[-300.0, 200.0, 4000.0]);
    let Loads {
        drives,
        tensions,
        reactions,
    } = loads(&listing, corner.get(), &forces);

    let compiled = compiled::Corner::<f64>::design().expect("a geometry");
    let change = Drives {
        bump: 1.0,
        steer: 0.0,
    };
    let moved = compiled.per(change).expect("motion ratios").points;
    let work = moved.rate.axle.dot(&Vector3::new(-300.0, 200.0, 4000.0));
    assert!(
        (drives[0] - work).abs() <= 1e-9 * work.abs(),
        "{drives:?} {work}"
    );

    let at = listing.design();
    let (at, _) = at.as_chunks::<3>();
    let part = listing.find(PART, c"lower_wishbone").expect("a hinge");
    let by: &[f64] = &reactions[3 * points * part..][..3 * points];
    let (by, _) = by.as_chunks::<3>();
    let at = |point: usize| Vector3::from(at[point]);
    let by = by.iter().copied().map(Vector3::from);
    let by: Vec<_> = by.collect();
    let force: Vector3<f64> = by.iter().sum();
    let moment: Vector3<f64> = (0..points).map(|point| at(point).cross(&by[point])).sum();
    let largest = by.iter().map(|force| force.norm()).fold(0.0, f64::max);
    assert!(largest > 1000.0 && force.norm() < 1e-9 * largest && moment.norm() < 1e-9 * largest);

    let rod = listing.find(PART, c"tie_rod").expect("a link");
    let end = listing.find(POINT, c"tie_ball").expect("a point");
    let start = 3 * (points * rod + end);
    let pull = Vector3::from_row_slice(&reactions[start..][..3]).norm();
    assert!(
        pull > 100.0 && (tensions[rod].abs() - pull).abs() < 1e-9 * pull,
        "{tensions:?}"
    );

    let mut short = [0.0; 1];
    let status = listing::corner_read_loads(
        corner.get(),
        from(&forces),
        forces.len(),
        to(&mut short),
        1,
        None.into(),
        0,
        None.into(),
        0,
        None.into(),
    );
    assert_eq!(status, Status::Size);
}

/// A drive about the axis of an arm's bushes, which also turns the angle of a rod from an axis: the moment
/// that holds an angle acts on the parts that carry its lines.
#[test]
fn moments_of_angles_act_on_the_parts_that_carry_their_lines() {
    let listing = Read::new(
        "fixed: outer at [0.4, 0.6, 0.3], inner at [0.4, 0.3, 0.3], mark at [-0.1, 0.3, 0.3], foot at [0.0, 2.0, 0.3];
free: hub at [0.0, 0.45, 0.3], top at [0.0, 2.3, 0.7];
hinge arm: outer, inner -> hub;
drive bar: angle(inner -> mark, inner -> hub about inner -> outer);
link rod: foot -> top;
drive lean: angle(foot -> top, z);
drive ahead: top.x;",
    );
    let listing = listing.expect("a listing");
    let corner = listing.place(&listing.design()).expect("a corner");
    let points = listing.count(POINT);
    let point = |name: &CStr| listing.find(POINT, name).expect("a point");
    let mut forces = vec![0.0; 3 * points];
    forces[3 * point(c"hub") + 2] = 1000.0;
    forces[3 * point(c"top") + 1] = 500.0;
    let Loads {
        drives,
        tensions,
        reactions,
    } = loads(&listing, corner.get(), &forces);
    let by = |part: &CStr, at: &CStr| {
        let part = listing.find(PART, part).expect("a part");
        Vector3::from_row_slice(&reactions[3 * (points * part + point(at))..][..3])
    };
    for (at, expected) in [(c"outer", 500.0), (c"inner", 500.0), (c"hub", -1000.0)] {
        let off = by(c"arm", at) - Vector3::new(0.0, 0.0, expected);
        assert!(off.norm() < 1e-8, "{at:?} {off:?}");
    }
    // Three fifths of the force act along the rod, four fifths cause the moment, with a lever arm of half a
    // metre.
    let rod = listing.find(PART, c"rod").expect("a link");
    assert!((tensions[rod] - 300.0).abs() < 1e-8, "{tensions:?}");
    let lean = listing.find(DRIVE, c"lean").expect("a drive");
    assert!((drives[lean] - 200.0).abs() < 1e-8, "{drives:?}");
    assert!((by(c"rod", c"top") + Vector3::new(0.0, 500.0, 0.0)).norm() < 1e-8);
}

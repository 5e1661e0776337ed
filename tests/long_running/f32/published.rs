//! The published motion in steps of a millisecond from 0 to 1.95 s, the last instant of Table 2. It
//! locks at 1.978 s, where velocities and with them all errors grow without bound.

use nalgebra::{SVector, Vector3};
use suspension::bake::{Continuity, Path, RequestedPoints, TERMS, Wanted, bake};
use suspension_core::baked::Curve;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::model::local::LocalOrigin;
use suspension_core::{Build, Linkage, Motion, Tracker, Values};

use super::case::{Built, Errors, Single, Tested, WAYS, Way, single, theta};
use crate::support::{INSTANTS, Reference};

const STEP: f64 = 1e-3;
const LAST: usize = 1950;

/// The exact motion at each instant.
fn truth<G: Tested>(design: &G::Points<f64>) -> (G::Model<f64>, Vec<Motion<f64, 15>>) {
    let model = G::Model::<f64>::new(design).expect("a linkage");
    let mut motion = Motion::at_rest(model.unknowns(design));
    let motions = (0..=LAST).map(|step| {
        let dt = if step == 0 { 0.0 } else { STEP };
        let inputs = theta(STEP * step as f64);
        let stepped = Tracker::default().step(&model, &inputs, dt, &mut motion);
        stepped.expect("a regular motion");
        motion
    });
    let motions = motions.collect();
    (model, motions)
}

/// The worst of a whole motion. No step is refused.
fn worst<G: Tested>(
    single: &Single<G>,
    way: Way,
    (model, truth): &(G::Model<f64>, Vec<Motion<f64, 15>>),
) -> Errors {
    let mut motion = single.start;
    let errors = truth.iter().enumerate().map(|(step, exact)| {
        let t = STEP * step as f64;
        let dt = if step == 0 { 0.0 } else { STEP };
        let inputs = theta(t);
        let stepped = way.step(&single.model, &inputs, dt, &mut motion);
        stepped.unwrap_or_else(|error| panic!("{way:?} at {t} s: {error}"));
        let points = motion.points(&single.model, &inputs).value;
        let at = exact.points(model, &theta(t)).value;
        Errors::of((single, &motion, &points), (exact, &at))
    });
    errors.fold(Errors::default(), Errors::worse)
}

/// Prints the worst of each way, all coordinates with `away` more, and holds them against the bounds.
pub(super) fn check<G: Tested>(built: Built, away: [f64; 3], bounds: &Errors) -> Errors {
    let design = G::design().map(|point| point + Vector3::from(away));
    let exact = truth::<G>(&design);
    let single = single::<G>(&design, built).expect("a linkage");
    let each = WAYS.map(|way| {
        let found = worst(&single, way, &exact);
        println!("{} {built:?}, {away:?} m away, {way:?}: {found:?}", G::NAME);
        found.assert_within(bounds);
        found
    });
    each.into_iter().fold(Errors::default(), Errors::worse)
}

#[test]
fn f32_errors_of_five_link_are_within_their_bounds() {
    let bounds = Errors {
        position: 3e-7,
        centre: 2e-7,
        camber: 1.5e-6,
        toe: 2e-6,
        velocity: 1e-5,
        acceleration: 3e-5,
    };
    for built in [Built::FromLocalPoints, Built::Rounded] {
        check::<five_link::Listing>(built, [0.0; 3], &bounds);
    }
}

/// Three distances to points that are nearly in their plane hold a point less firmly than a body
/// does: rounding of lengths counts for more.
#[test]
fn f32_errors_of_attia2003_are_within_their_bounds() {
    let bounds = Errors {
        position: 2e-6,
        centre: 1.5e-6,
        camber: 1e-5,
        toe: 1e-5,
        velocity: 6e-5,
        acceleration: 2e-3,
    };
    check::<attia2003::Listing>(Built::Rounded, [0.0; 3], &bounds);
}

/// At the instants of Table 2, beside the 40-digit solution.
#[test]
fn f32_positions_agree_with_the_40_digit_solution() {
    let single = single::<five_link::Listing>(&five_link::Listing::design(), Built::Rounded);
    let single = single.expect("a linkage");
    let origin = SVector::<f64, 15>::from_fn(|row, _| single.origin[row % 3]);
    let reference = Reference::load();
    let (mut motion, mut met) = (single.start, 0);
    for step in 0..=LAST {
        let t = STEP * step as f64;
        let dt = if step == 0 { 0.0 } else { STEP };
        let stepped = Way::Bounded1.step(&single.model, &theta(t), dt, &mut motion);
        stepped.expect("a regular motion");
        if let Some(instant) = INSTANTS.iter().position(|at| (at - t).abs() < STEP / 2.0) {
            met += 1;
            let exact = reference.unknowns(instant, "");
            let off = (motion.position.map(f64::from) + origin - exact).amax();
            println!("t = {t} s: {off:.1e} m");
            assert!(off <= 3e-7, "{off:e} m at {t} s");
        }
    }
    assert_eq!(met, INSTANTS.len());
}

/// Curves of the motion about a local origin, baked in `f64` to 1e-8 m and rounded.
#[test]
fn f32_errors_of_baked_curves_are_within_their_bounds() {
    let design = five_link::Listing::design();
    let local = LocalOrigin::among(design.values()).to_local(&design);
    let (model, truth) = truth::<five_link::Listing>(&local);
    let held = five_link::Drives { theta: 0.7 };
    let range = [0.7, 2.150_312_5];
    let path = Path::new(
        &model,
        &truth[0],
        held,
        0,
        range,
        RequestedPoints::AllPoints,
    );
    let wanted = Wanted {
        range,
        tolerance: 1e-8,
        metre: 1.0,
        continuity: Continuity::Acceleration,
    };
    let baked = bake(&wanted, &path.expect("a regular range")).expect("within the tolerance");
    // Five points and the wheel centre.
    let table: Vec<[[f32; 18]; TERMS]> = baked.table().expect("eighteen outputs");
    let curve: Curve<'_, f32, 18, TERMS> = baked.curve(&table);
    let errors = truth.iter().enumerate().map(|(step, exact)| {
        let drive: five_link::Drives<f32> = theta(STEP * step as f64).drives.value;
        let place = curve.at(drive.theta);
        let place = place.or_else(|outside| curve.at(outside.nearest));
        let found = place.expect("inside").position();
        let unknowns = SVector::<f32, 15>::from_row_slice(&found[..15]);
        (unknowns.map(f64::from) - exact.position).amax()
    });
    let worst = errors.fold(0.0, f64::max);
    println!("{} segments: {worst:.1e} m", table.len());
    assert!(worst <= 3e-7, "{worst:e}");
}

//! The published mechanism: both ends of its drive, and once round its curve.

use suspension_core::path::{Continuation, End};
use suspension_core::{Build, Real, Signal};

use super::case::{Case, attia, five_link};

/// The values at which the drive turns, from a 40-digit solution, rad.
const LOWEST: f64 = 0.662_460_552_146_186_5;
const HIGHEST: f64 = 2.178_426_263_359_593;

fn turning_points<T: Real, L: Build<15, Scalar = T>>(case: &Case<T, L>, tolerance: f64) {
    for (increasing, expected) in [(true, HIGHEST), (false, LOWEST)] {
        let stretches = case.path(increasing);
        let turning = stretches.iter().find_map(|stretch| stretch.turning);
        let turning = turning.expect("the drive turns");
        let error = (turning.place.value - T::constant(expected)).abs();
        assert!(error <= T::constant(tolerance), "{expected} off by {error}");
        assert!(!turning.is_end_of_angle);
    }
}

fn follow_the_closed_curve<T: Real, L: Build<15, Scalar = T>>(case: &Case<T, L>, tolerance: f64) {
    for increasing in [true, false] {
        let stretches = case.path(increasing);
        let turns = stretches.iter().filter_map(|stretch| stretch.turning);
        // Two more lie on the way back, where the drive cannot lead.
        assert_eq!(turns.count(), 4);
        let last = stretches.last().expect("a path");
        let Some(End::Closed { gap }) = last.end else {
            panic!("{:?}", last.end)
        };
        assert!(gap <= T::constant(tolerance), "open by {gap}");
        for stretch in &stretches {
            let rounding = T::constant(16.0 * 1.5) * T::EPSILON;
            assert!(stretch.place.residual <= rounding);
        }
    }
}

#[test]
fn both_turning_points_are_found_to_rounding() {
    turning_points(&attia::<f64>(), 1e-13);
    turning_points(&five_link::<f64>(), 1e-13);
}

#[test]
fn the_curve_of_the_published_mechanism_is_closed() {
    follow_the_closed_curve(&attia::<f64>(), 1e-12);
    follow_the_closed_curve(&five_link::<f64>(), 1e-12);
}

#[test]
fn turning_points_and_closed_curve_are_found_in_f32() {
    turning_points(&attia::<f32>(), 1e-5);
    turning_points(&five_link::<f32>(), 1e-5);
    follow_the_closed_curve(&attia::<f32>(), 1e-4);
    follow_the_closed_curve(&five_link::<f32>(), 1e-4);
}

#[test]
fn a_path_stays_within_its_range() {
    let case = five_link::<f64>();
    let settings = Continuation {
        range: Some([0.68, 2.0]),
        ..Continuation::default()
    };
    for (increasing, bound) in [(true, 2.0), (false, 0.68)] {
        let path = settings.path(case.curve(), &case.q, increasing);
        let mut path = path.expect("a regular start");
        let last = path.by_ref().last().expect("a path").expect("regular");
        assert_eq!(last.end, Some(End::Range));
        assert!((last.place.value - bound).abs() < 1e-14);
        assert!(path.next().is_none());
    }
}

#[test]
fn a_path_that_starts_outside_its_range_makes_no_step() {
    let case = five_link::<f64>();
    let start = case.curve().value(&Signal {
        value: case.curve().configuration(&case.q).drive,
        rate: 0.0,
        second_rate: 0.0,
    });
    let ends = |range| {
        let settings = Continuation {
            range: Some(range),
            ..Continuation::default()
        };
        [true, false].map(|increasing| {
            let path = settings.path(case.curve(), &case.q, increasing);
            let mut path = path.expect("a regular start");
            let start_configuration = path.here().configuration;
            let last = path.by_ref().last().expect("a path").expect("regular");
            assert!(path.next().is_none());
            (last.end, last.place.configuration == start_configuration)
        })
    };
    let start = start.value;
    for outside in [[start + 0.1, start + 0.2], [start - 0.2, start - 0.1]] {
        assert_eq!(ends(outside), [(Some(End::OutOfRange), true); 2]);
    }
    // At a bound it is within.
    for within in [[start, start + 0.1], [start - 0.1, start]] {
        assert!(ends(within).iter().all(|end| end.0 == Some(End::Range)));
    }
}

#[test]
fn a_path_makes_no_more_steps_than_allowed() {
    let case = five_link::<f64>();
    let settings = Continuation {
        max_steps: 3,
        ..Continuation::default()
    };
    let path = settings.path(case.curve(), &case.q, true);
    let stretches: Vec<_> = path.expect("a regular start").collect();
    let ends: Vec<_> = stretches
        .iter()
        .map(|stretch| stretch.expect("regular").end)
        .collect();
    assert_eq!(ends, [None, None, Some(End::Steps)]);
}

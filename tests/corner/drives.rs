//! Drives that are not finite, and angles that are driven beyond their range.

use suspension_core::{Signal, SolveError, Values, linkage};
use suspension_runtime::{Listing, catalogue};

linkage! {
    /// A point on two links, and a chassis point that is driven and only measured.
    mod measured {
        fixed: left at [-3.0, 0.0, 0.0], right at [3.0, 0.0, 0.0], gauge at [0.0, 0.0, 9.0];
        free:  top at [0.0, 4.0, 0.0];
        link one: left -> top;
        link two: right -> top;
        drive height: top.z;
        drive slide: gauge.x;
        measure span: length(top -> gauge);
    }
}

/// The drive is in no residual: it is refused by name, and the corner stays unchanged.
#[test]
fn a_non_finite_drive_read_by_a_measure_alone_is_refused() {
    let mut corner: measured::Corner = measured::Corner::design().expect("a design");
    let start = corner.drives();
    let span = corner.measures().value.span;
    for slide in [f64::NAN, f64::INFINITY] {
        let wrong = measured::Drives { slide, ..start };
        let rate = measured::Drives { slide, height: 0.0 };
        let by_value = Signal::still(wrong);
        let by_rate = Signal {
            rate,
            ..Signal::still(start)
        };
        for drives in [by_value, by_rate] {
            for answer in [
                corner.step(0.1, drives),
                corner.step_towards(0.1, drives),
                corner.advance(0.1, |_| drives),
            ] {
                let message = answer.expect_err("not finite").to_string();
                assert!(message.contains("drive `slide`"), "{message}");
            }
        }
    }
    assert_eq!((corner.measures().value.span, corner.time()), (span, 0.0));
}

/// The drives that a function gives for such a time are no fault of its own.
#[test]
fn a_time_that_is_not_finite_is_refused_as_such() {
    let mut corner: measured::Corner = measured::Corner::design().expect("a design");
    let start = corner.drives();
    let rate = measured::Drives {
        height: 0.1,
        slide: 0.1,
    };
    for to in [f64::NAN, f64::INFINITY] {
        let advanced = corner.advance(to, |time| Signal::line(start, rate, time));
        let stopped = advanced.expect_err("no time").error;
        let (_, error) = stopped.refused.expect("a reason");
        assert_eq!(error, SolveError::StepNotFinite);
    }
    assert_eq!((corner.drives(), corner.time()), (start, 0.0));
}

/// Two such steps would make the time infinite.
#[test]
fn a_step_after_which_the_time_is_not_finite_is_refused() {
    let mut corner: measured::Corner = measured::Corner::design().expect("a design");
    let drives = Signal::still(corner.drives());
    for dt in [f64::MAX, -f64::MAX] {
        corner.step(dt, drives).expect("a finite time");
        let before = (corner.time(), *corner.motion());
        for refused in [corner.step(dt, drives), corner.step_towards(dt, drives)] {
            let stopped = refused.expect_err("an infinite time").error;
            assert_eq!(stopped.refused, Some((dt, SolveError::StepNotFinite)));
            assert_eq!((stopped.reached, *corner.motion()), before);
        }
        assert_eq!((corner.time(), *corner.motion()), before);
        corner.step(-dt, drives).expect("back to zero");
    }
}

/// The change is in no equation either: its derivatives would be NaN.
#[test]
fn a_change_of_drives_that_is_not_finite_has_no_derivatives() {
    let corner: measured::Corner = measured::Corner::design().expect("a design");
    for slide in [f64::NAN, f64::INFINITY] {
        let change = measured::Drives { slide, height: 1.0 };
        let refused = corner.per(change).expect_err("not finite").to_string();
        assert!(refused.contains("drive `slide`"), "{refused}");
    }
}

linkage! {
    /// A crank that an angle about its axis drives, and one that an angle from a chassis axis does.
    mod cranks {
        fixed: a at [0.0, 0.0, 0.0], e at [1.0, 0.0, 0.0], k at [0.0, 0.3, 0.0];
        free:  b at [0.0, 0.3, 0.0], c at [0.0, 0.15, 0.259_807_621_135_331_6];
        hinge crank: a, e -> b;
        hinge other: a, e -> c;
        drive turn:  angle(a -> k, a -> b about a -> e);
        drive angle: angle(a -> c, y);
    }
}

/// The equations contain the sine of a quarter of one angle and the cosine of the other, which are not monotonic beyond the
/// range.
#[test]
fn a_driven_angle_is_followed_through_its_range_and_refused_beyond() {
    let mut corner = cranks::Corner::<f64>::design().expect("a regular design");
    let start = corner.drives();
    let (mut turn, mut refused) = (0.0, None);
    while refused.is_none() && turn < 7.0 {
        turn += 0.01;
        let drives = cranks::Drives { turn, ..start };
        refused = corner.step(1e-3, Signal::still(drives)).err();
        let reached = corner.drives().turn;
        let off = corner.points().value.b.z - 0.3 * reached.sin();
        assert!(off.abs() < 1e-9, "{reached}: {off}");
    }
    assert!((turn - std::f64::consts::TAU).abs() < 0.05, "{turn}");
    for (turn, angle) in [
        (12.5, start.angle),
        (-6.3, start.angle),
        (std::f64::consts::TAU, start.angle),
        (0.5, -1.0),
        (0.5, 5.2),
    ] {
        let before = corner;
        let drives = Signal::still(cranks::Drives { turn, angle });
        let drive = if angle == start.angle {
            "turn"
        } else {
            "angle"
        };
        let expected = format!("an angle is driven beyond its range: drive `{drive}`");
        for refused in [corner.step(1e-3, drives), corner.step_towards(1e-3, drives)] {
            let sentence = refused.expect_err("beyond the range").to_string();
            assert!(sentence.contains(&expected), "{sentence}");
            assert_eq!(corner.motion(), before.motion());
        }
    }
}

/// A model at run time has room for more drives than its listing has.
#[test]
fn values_beyond_the_last_drive_change_nothing() {
    let text = catalogue::listing("double_wishbone").expect("a layout");
    let listing = Listing::parse(text).expect("valid");
    let design = listing.design().expect("a design");
    let corner = listing.corner::<15>(&design).expect("regular");
    let bump = listing.drive("bump").expect("a drive");
    let drives = corner.drives().with(bump, 0.31);
    let beyond = drives.with(7, f64::NAN);
    let one = drives.map(|_| 0.0).with(bump, 1.0);
    let [good, odd] = [drives, beyond].map(|drives| {
        let mut corner = corner;
        let step = corner.step(1e-3, Signal::still(drives));
        step.expect("within reach");
        corner
    });
    assert_eq!(good.motion(), odd.motion());
    let [good, odd] = [(good, one), (odd, one.with(7, f64::NAN))].map(|(corner, change)| {
        let derived = corner.per(change).expect("regular");
        derived.points
    });
    assert_eq!(good, odd);
}

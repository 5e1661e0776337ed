//! Steps whose length is zero or not a number.

use suspension_core::Signal;
use suspension_core::linkages::double_wishbone_pushrod::Drives;

use super::moved;

#[test]
fn a_step_of_zero_length_reaches_near_drives_and_their_rates() {
    let mut corner = moved(0.02, 0.0);
    let [time, before] = [corner.time(), corner.drives().bump];
    let drives = |by: f64, rate: f64| Signal {
        value: Drives {
            bump: before + by,
            steer: corner.drives().steer,
        },
        rate: Drives {
            bump: rate,
            steer: 0.0,
        },
        second_rate: Drives::default(),
    };
    // A pause, one with other rates, and a drive that has changed meanwhile.
    for (to, dt) in [
        (drives(0.0, 0.3), 0.0),
        (drives(0.0, -0.1), -0.0),
        (drives(1e-4, 0.2), 0.0),
    ] {
        corner.step(dt, to).expect("near by");
        assert_eq!(corner.time().to_bits(), time.to_bits());
        let points = corner.points();
        assert!((points.value.wheel_centre.z - to.value.bump).abs() < 1e-14);
        assert!((points.rate.wheel_centre.z - to.rate.bump).abs() < 1e-13);
    }
}

#[test]
fn a_step_of_zero_length_to_distant_drives_is_refused() {
    let mut corner = moved(0.02, 0.0);
    let before = (corner.time(), corner.drives(), *corner.motion());
    let to = |bump: f64, steer: f64| Drives {
        bump: before.1.bump + bump,
        steer: before.1.steer + steer,
    };
    for to in [to(0.1, 0.0), to(0.0, 0.3), to(f64::NAN, 0.0)] {
        corner.step(0.0, Signal::still(to)).expect_err("far away");
        assert_eq!((corner.time(), corner.drives(), *corner.motion()), before);
    }
}

#[test]
fn a_step_of_a_length_that_is_not_finite_is_refused() {
    for length in [f64::NAN, f64::INFINITY] {
        let mut corner = moved(0.02, 0.0);
        let before = (corner.time(), corner.drives(), *corner.motion());
        let drives = Signal::still(before.1);
        for stopped in [
            corner.step(length, drives),
            corner.step_towards(length, drives),
            corner.advance(length, |_| drives),
        ] {
            let message = stopped.expect_err("no length").to_string();
            let expected =
                "the time step or the time after it is not a finite number; give finite times";
            assert!(message.ends_with(expected), "{message}");
        }
        assert_eq!((corner.time(), corner.drives(), *corner.motion()), before);
    }
}

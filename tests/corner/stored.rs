//! A corner that goes on from a stored state.

use suspension_core::Signal;
use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives};

use super::design;

#[test]
fn a_corner_resumed_from_a_stored_state_makes_the_same_steps() {
    let start = design().drives();
    let at = |time: f64| {
        let (sine, cosine) = (3.0 * time).sin_cos();
        let drives = |bump, steer| Drives { bump, steer };
        Signal {
            value: drives(start.bump + 0.03 * sine, start.steer + 0.01 * sine),
            rate: drives(0.09 * cosine, 0.03 * cosine),
            second_rate: drives(-0.27 * sine, -0.09 * sine),
        }
    };
    let mut corner = design();
    corner.advance(0.4, at).expect("within reach");
    let (motion, drives, time) = (*corner.motion(), corner.drive_signal(), corner.time());
    assert_eq!(drives, at(0.4));

    let mut resumed = Corner::resumed(*corner.model(), motion, drives, time);
    assert_eq!(resumed.points(), corner.points());
    for tick in 401..=500 {
        let drives = at(1e-3 * f64::from(tick));
        for corner in [&mut corner, &mut resumed] {
            corner.step(1e-3, drives).expect("within reach");
        }
        assert_eq!(resumed.motion(), corner.motion());
    }
    assert_eq!(resumed.time(), corner.time());
}

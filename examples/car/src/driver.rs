//! A scripted driver: the rack and the pedals over time.

use std::f64::consts::PI;

use suspension_core::Signal;

use crate::car::{Car, Controls};

/// A driver who holds a speed and turns the rack: to the left, back, to the right, back, and again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driver {
    /// m/s.
    pub speed: f64,
    /// The amplitude of the rack, m.
    pub rack: f64,
    /// When it is first turned, s.
    pub from: f64,
    /// The duration of a turn, s.
    pub ramp: f64,
    /// The duration for which the rack is held between two turns, s.
    pub hold: f64,
}

/// The torque of each rear wheel, N m.
const FULL_TORQUE: f64 = 600.0;
/// The lack of speed at which the driver gives it, m/s.
const FULL_LACK: f64 = 2.0;

impl Driver {
    /// Returns the controls at a time, s.
    pub fn controls(&self, time: f64, car: &Car) -> Controls {
        let lack = self.speed - car.chassis.velocity.norm();
        Controls {
            rack: self.rack_at(time),
            drive: (lack / FULL_LACK).clamp(-1.0, 1.0) * FULL_TORQUE,
            brake: [0.0; 2],
        }
    }

    /// Each turn is half a period of a cosine, so that rates and second rates are known.
    fn rack_at(&self, time: f64) -> Signal<f64> {
        let period = self.ramp + self.hold;
        let periods = (time - self.from) / period;
        if periods < 0.0 {
            return Signal::default();
        }
        let turn = periods.floor();
        let [from, to] = match turn as usize % 4 {
            0 => [0.0, self.rack],
            1 => [self.rack, 0.0],
            2 => [0.0, -self.rack],
            _ => [-self.rack, 0.0],
        };
        let part = (periods - turn) * period / self.ramp;
        if part >= 1.0 {
            return Signal::still(to);
        }
        let (sine, cosine) = (PI * part).sin_cos();
        let (half, pace) = (0.5 * (to - from), PI / self.ramp);
        Signal {
            value: from + half * (1.0 - cosine),
            rate: half * pace * sine,
            second_rate: half * pace * pace * cosine,
        }
    }
}

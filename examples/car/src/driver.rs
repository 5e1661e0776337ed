//! Scripted drives: what the rack and the pedals do at a time.

use suspension_core::Signal;

use crate::car::{Car, Controls};

/// A driver who holds a speed and turns the rack now and then.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driver {
    /// m/s.
    pub speed: f64,
    /// Amplitude of the rack, m.
    pub rack: f64,
    /// When the rack is first turned, s.
    pub from: f64,
    /// How long it takes to turn it, s.
    pub ramp: f64,
    /// How long it is held before it is turned back, s.
    pub hold: f64,
}

impl Driver {
    /// What the driver does at a time.
    pub fn controls(&self, time: f64, car: &Car) -> Controls {
        let forward = car.chassis.frame().velocity.x;
        // Full torque where 2 m/s are lacking.
        const TORQUE: f64 = 600.0;
        Controls {
            rack: self.rack_at(time),
            drive: ((self.speed - forward) / 2.0).clamp(-1.0, 1.0) * TORQUE,
            brake: [0.0; 2],
        }
    }

    /// To the left, back, to the right, back, and again; each turn a cosine, so that rates and second rates are known.
    fn rack_at(&self, time: f64) -> Signal<f64> {
        let period = self.ramp + self.hold;
        let elapsed = time - self.from;
        if elapsed < 0.0 {
            return Signal::default();
        }
        let [from, to] = match (elapsed / period) as usize % 4 {
            0 => [0.0, 1.0],
            1 => [1.0, 0.0],
            2 => [0.0, -1.0],
            _ => [-1.0, 0.0],
        };
        let turn = ramp((elapsed % period) / self.ramp);
        let change = (to - from) * self.rack;
        Signal {
            value: from * self.rack + change * turn.value,
            rate: change * turn.rate / self.ramp,
            second_rate: change * turn.second_rate / (self.ramp * self.ramp),
        }
    }
}

/// From 0 to 1 while `x` is, with its derivatives.
fn ramp(x: f64) -> Signal<f64> {
    use std::f64::consts::PI;
    if x >= 1.0 {
        return Signal::still(1.0);
    }
    let (sine, cosine) = (PI * x).sin_cos();
    Signal {
        value: 0.5 * (1.0 - cosine),
        rate: 0.5 * PI * sine,
        second_rate: 0.5 * PI * PI * cosine,
    }
}

//! The time of a moving suspension.

use crate::arithmetic::scalar::Real;

/// A sum of steps with compensated rounding errors (Kahan's summation): after an hour of milliseconds a plain sum of
/// `f32` is off by more than a minute, and later it stops growing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock<T> {
    time: T,
    too_much: T,
}

impl<T: Real> Clock<T> {
    pub(super) fn at(time: T) -> Self {
        Self {
            time,
            too_much: T::zero(),
        }
    }

    #[inline]
    pub(super) fn time(&self) -> T {
        self.time
    }

    #[inline]
    pub(super) fn advance(&mut self, dt: T) {
        let step = dt - self.too_much;
        let time = self.time + step;
        self.too_much = (time - self.time) - step;
        self.time = time;
    }
}

#[cfg(test)]
mod tests {
    use super::Clock;

    #[test]
    fn an_f32_clock_adds_milliseconds_to_hours_without_drift() {
        let mut clock = Clock::at(0.0_f32);
        for _ in 0..40_000_000 {
            clock.advance(1e-3);
        }
        // A millisecond itself is rounded.
        let off = f64::from(clock.time()) / (f64::from(1e-3_f32) * 4e7) - 1.0;
        assert!(off.abs() < f64::from(f32::EPSILON), "{off:e}");
    }
}

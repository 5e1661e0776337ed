//! Spring, damper and stops of a corner.

/// A linear spring and damper along a measured length, and stops at the ends of the wheel's travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strut {
    /// N/m along the strut.
    pub stiffness: f64,
    /// N s/m along the strut.
    pub damping: f64,
    /// Length at which the spring bears nothing, m.
    pub free_length: f64,
    /// Travel up and down that the stops leave, m.
    pub clearance: f64,
    /// N/m of travel, beyond that.
    pub stop: f64,
}

impl Strut {
    /// The force that pushes the ends apart, N.
    pub fn force(&self, [length, rate]: [f64; 2]) -> f64 {
        self.stiffness * (self.free_length - length) - self.damping * rate
    }

    /// The force of a stop on the travel, N.
    pub fn stop_force(&self, travel: f64) -> f64 {
        -self.stop * self.beyond(travel)
    }

    /// Stored in spring and stop, J.
    pub fn energy(&self, length: f64, travel: f64) -> f64 {
        let [spring, stop] = [self.free_length - length, self.beyond(travel)];
        0.5 * (self.stiffness * spring * spring + self.stop * stop * stop)
    }

    /// The power of the damper, W, not positive.
    pub fn power(&self, rate: f64) -> f64 {
        -self.damping * rate * rate
    }

    fn beyond(&self, travel: f64) -> f64 {
        travel - travel.clamp(-self.clearance, self.clearance)
    }
}

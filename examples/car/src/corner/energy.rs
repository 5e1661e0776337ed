//! A corner's energy, its gains and losses, for tests.

use super::{Corner, Ground, Torque};
use crate::chassis::Frame;
use crate::kinematics::Hub;
use crate::saloon::GRAVITY;

impl Corner {
    /// Kinetic and stored energy, J, as of the last look and touch. The height of the chassis is that of the frame.
    pub fn energy(&self, frame: &Frame) -> f64 {
        let Hub { centre, strut, .. } = self.hub;
        let height = (frame.position + frame.rotation * centre.value).z;
        let deflection = self.ground.contact.deflection.max(0.0);
        0.5 * self.unsprung_mass * self.ground.centre_velocity.norm_squared()
            + 0.5 * self.spin_inertia * self.spin * self.spin
            + self.unsprung_mass * GRAVITY * height
            + self.strut.energy(strut[0], self.travel)
            + 0.5 * self.tyre.stiffness * deflection * deflection
    }

    /// The power of the shaft minus the power of brake, damper and tyre, W. The road is flat and at rest, and so is the
    /// rack.
    pub fn power(&self, frame: &Frame, torque: &Torque, dt: f64) -> f64 {
        let Ground { contact, force, .. } = self.ground;
        let tread = self.tread_velocity();
        let deflection = contact.deflection;
        let stored = contact.along_normal(self.tyre.stiffness * deflection.max(0.0));
        let shaft = self.spin - self.hub.axis.dot(&frame.turning);
        self.strut.power(self.hub.strut[1]) + (force - stored).dot(&tread) + torque.drive * shaft
            - self.brake(torque, dt) * self.rolling()
    }
}

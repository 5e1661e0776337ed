//! A quarter car: a mass that moves up and down, one corner below it, and a tyre without friction.
//!
//! The coordinates are the rise of the mass and the wheel's travel. The equations of motion are Kane's, with the partial velocities `z` and
//! `per_travel.centre` of the wheel centre.

use nalgebra::{Matrix2, Vector2, Vector3};
use suspension_core::Signal;

use crate::contact::Contact;
use crate::kinematics::{Drives, Hub, Kinematics, Refused};
use crate::saloon::{Axle, GRAVITY};
use crate::strut::Strut;
use crate::tyre::Tyre;

/// A quarter car. Rise and travel are zero at rest.
pub struct Quarter<K> {
    /// Rise of the mass and travel of the wheel, m.
    pub position: Vector2<f64>,
    /// The rates of both, m/s.
    pub velocity: Vector2<f64>,
    kinematics: K,
    masses: [f64; 2],
    strut: Strut,
    tyre: Tyre,
    clearance: f64,
    hub: Hub,
}

impl<K: Kinematics> Quarter<K> {
    /// A quarter car at rest under a sprung mass, with the spring that holds it there.
    ///
    /// # Errors
    ///
    /// Those of the kinematics.
    pub fn new(mut kinematics: K, sprung: f64, axle: &Axle, tyre: Tyre) -> Result<Self, Refused> {
        let hub = kinematics.step(1e-3, &Signal::default())?;
        let masses = [sprung, axle.unsprung_mass];
        let clearance =
            crate::equilibrium::clearance(&hub, &tyre, (sprung + axle.unsprung_mass) * GRAVITY);
        Ok(Self {
            position: Vector2::zeros(),
            velocity: Vector2::zeros(),
            strut: crate::equilibrium::strut(&hub, axle, &tyre, clearance),
            kinematics,
            masses,
            tyre,
            clearance,
            hub,
        })
    }

    /// One step of semi-implicit Euler.
    ///
    /// # Errors
    ///
    /// Those of the kinematics; the car is then unchanged.
    pub fn tick(&mut self, dt: f64) -> Result<(), Refused> {
        self.look(dt)?;
        self.velocity += self.acceleration() * dt;
        self.position += self.velocity * dt;
        Ok(())
    }

    /// Computes the hub at the present position of the wheel, a time after the last call.
    ///
    /// # Errors
    ///
    /// Those of the kinematics.
    pub fn look(&mut self, dt: f64) -> Result<(), Refused> {
        let drives = |travel| Drives { travel, rack: 0.0 };
        self.hub = self.kinematics.step(
            dt,
            &Signal {
                value: drives(self.position.y),
                rate: drives(self.velocity.y),
                second_rate: Drives::default(),
            },
        )?;
        Ok(())
    }

    /// Kinetic and stored energy as of the last look, J.
    pub fn energy(&self) -> f64 {
        let [sprung, unsprung] = self.masses;
        let Hub { centre, strut, .. } = self.hub;
        let wheel = centre.rate + Vector3::z() * self.velocity.x;
        let deflection = self.contact().deflection.max(0.0);
        0.5 * (sprung * self.velocity.x.powi(2) + unsprung * wheel.norm_squared())
            + GRAVITY * ((sprung + unsprung) * self.position.x + unsprung * centre.value.z)
            + self.strut.energy(strut[0], self.position.y)
            + 0.5 * self.tyre.stiffness * deflection * deflection
    }

    /// The power of damper and tyre in the last tick, W, not positive.
    pub fn power(&self) -> f64 {
        let contact = self.contact();
        let rate = contact.deflection_rate(&self.contact_velocity(&contact));
        let damped =
            self.tyre.load(contact.deflection, rate) - self.tyre.load(contact.deflection, 0.0);
        self.strut.power(self.hub.strut[1]) - damped * rate
    }

    fn acceleration(&self) -> Vector2<f64> {
        let [sprung, unsprung] = self.masses;
        let Hub {
            centre,
            strut,
            per_travel,
            ..
        } = self.hub;
        let contact = self.contact();
        let rate = contact.deflection_rate(&self.contact_velocity(&contact));
        let ground = contact.along_normal(self.tyre.load(contact.deflection, rate));
        let on_wheel = -(Vector3::z() * GRAVITY + centre.second_rate) * unsprung;
        let at_contact = per_travel.centre + per_travel.turn.cross(&contact.arm);
        let force = Vector2::new(
            on_wheel.z + ground.z - sprung * GRAVITY,
            per_travel.centre.dot(&on_wheel)
                + at_contact.dot(&ground)
                + per_travel.strut * self.strut.force(strut)
                + self.strut.stop_force(self.position.y),
        );
        let coupling = unsprung * per_travel.centre.z;
        let mass = Matrix2::new(
            sprung + unsprung,
            coupling,
            coupling,
            unsprung * per_travel.centre.norm_squared(),
        );
        // Positive definite wherever the wheel can move.
        mass.cholesky()
            .map_or_else(Vector2::zeros, |factors| factors.solve(&force))
    }

    fn contact(&self) -> Contact {
        let risen = self.hub.centre.value.z + self.position.x + self.clearance;
        Contact::new(risen, Vector3::z(), self.hub.axis, self.tyre.radius)
    }

    fn contact_velocity(&self, contact: &Contact) -> Vector3<f64> {
        Vector3::z() * self.velocity.x + self.hub.centre.rate + self.hub.turning.cross(&contact.arm)
    }
}

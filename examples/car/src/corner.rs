//! A corner of the car: wheel, tyre and strut on the hub's motion.

mod energy;
mod motion;

use nalgebra::{Vector2, Vector3};
use suspension_core::Signal;

use crate::chassis::Frame;
use crate::contact::Contact;
use crate::equilibrium;
use crate::kinematics::{Drives, Hub, Kinematics, Refused};
use crate::road::Road;
use crate::saloon::{Axle, Parameters};
use crate::strut::Strut;
use crate::tyre::Tyre;

pub use motion::Eliminated;

/// A corner.
pub struct Corner {
    /// Change of the wheel centre's height in chassis axes, from the design, m.
    pub travel: f64,
    /// m/s.
    pub travel_rate: f64,
    /// The second rate of the travel in the last tick, m/s^2, from which the kinematics predict.
    travel_second_rate: f64,
    /// Angular velocity of the wheel about its axis, rad/s, positive ahead.
    pub spin: f64,
    /// The slip of the tread: longitudinal and lateral.
    pub slip: Vector2<f64>,
    /// The hub from the last [`look`](Self::look), in chassis axes from the chassis' origin.
    pub hub: Hub,
    /// The contact from the last [`touch`](Self::touch).
    pub ground: Ground,
    kinematics: Box<dyn Kinematics>,
    on_the_right: bool,
    origin: Vector3<f64>,
    unsprung_mass: f64,
    spin_inertia: f64,
    strut: Strut,
    tyre: Tyre,
}

/// The contact of wheel and road, in chassis axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Where.
    pub contact: Contact,
    /// Along the road's normal, N.
    pub load: f64,
    /// On the wheel, load included, N.
    pub force: Vector3<f64>,
    /// The velocity of the carrier at the wheel centre, m/s.
    centre_velocity: Vector3<f64>,
    /// Angular velocity of the carrier, rad/s.
    carrier: Vector3<f64>,
}

/// Moments about a wheel's axis, N m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Torque {
    /// The torque from a differential on the chassis.
    pub drive: f64,
    /// The largest torque of a brake on the carrier.
    pub brake: f64,
}

impl Corner {
    /// A corner at rest under its load; `left` are the kinematics of the left corner, on either side.
    ///
    /// # Errors
    ///
    /// Those of the kinematics.
    pub fn new(
        mut left: Box<dyn Kinematics>,
        on_the_right: bool,
        axle: &Axle,
        car: &Parameters,
        load: f64,
    ) -> Result<Self, Refused> {
        let hub = left.step(1e-3, &Signal::default())?;
        let clearance = equilibrium::clearance(&hub, &car.tyre, load);
        let mut corner = Self {
            travel: 0.0,
            travel_rate: 0.0,
            travel_second_rate: 0.0,
            spin: 0.0,
            slip: Vector2::zeros(),
            hub,
            ground: Ground::none(&hub),
            kinematics: left,
            on_the_right,
            origin: Vector3::new(axle.ahead, 0.0, clearance - car.height),
            unsprung_mass: axle.unsprung_mass,
            spin_inertia: axle.spin_inertia,
            strut: equilibrium::strut(&hub, axle, &car.tyre, clearance),
            tyre: car.tyre,
        };
        corner.look(1e-3, &Signal::default())?;
        Ok(corner)
    }

    /// Computes the hub at the present position of the wheel, `dt` after the last call; `rack` is positive to the left of
    /// straight ahead.
    ///
    /// # Errors
    ///
    /// Those of the kinematics.
    pub fn look(&mut self, dt: f64, rack: &Signal<f64>) -> Result<(), Refused> {
        let drives = self.drives(rack);
        let hub = self.kinematics.step(dt, &drives)?;
        self.hub = if self.on_the_right {
            hub.mirrored()
        } else {
            hub
        };
        self.hub.centre.value += self.origin;
        Ok(())
    }

    /// Continues with other kinematics, which have entered at the position of this corner, and returns the former ones in
    /// their place.
    pub fn change(&mut self, other: &mut Box<dyn Kinematics>) {
        std::mem::swap(&mut self.kinematics, other);
    }

    /// Returns the drives of the kinematics of the left corner.
    pub fn drives(&self, rack: &Signal<f64>) -> Signal<Drives> {
        // Zero stays positive.
        let to_left = |rack: f64| if self.on_the_right { 0.0 - rack } else { rack };
        let drives = |travel, rack| Drives {
            travel,
            rack: to_left(rack),
        };
        Signal {
            value: drives(self.travel, rack.value),
            rate: drives(self.travel_rate, rack.rate),
            second_rate: drives(self.travel_second_rate, rack.second_rate),
        }
    }

    /// The spin axis away from the car, in chassis axes.
    pub fn outboard(&self) -> Vector3<f64> {
        if self.on_the_right {
            -self.hub.axis
        } else {
            self.hub.axis
        }
    }

    /// The tyre on the road below the wheel; the slip goes on by `dt`.
    pub fn touch(&mut self, frame: &Frame, road: &Road, dt: f64) {
        let Hub {
            centre,
            axis,
            turning,
            ..
        } = self.hub;
        let at = frame.position + frame.rotation * centre.value;
        let (height, normal) = road.at(at.x, at.y);
        let clearance = (at.z - height) * normal.z;
        let normal = frame.rotation.tr_mul(&normal);
        let contact = Contact::new(clearance, normal, axis, self.tyre.radius);
        let carrier = frame.turning + turning;
        let centre_velocity = frame.velocity + frame.turning.cross(&centre.value) + centre.rate;
        let velocity = centre_velocity + carrier.cross(&contact.arm);
        let load = self
            .tyre
            .load(contact.deflection, contact.deflection_rate(&velocity));
        let upwards = contact.along_normal(load);
        self.ground = Ground {
            contact,
            load: load / contact.upright,
            force: upwards,
            centre_velocity,
            carrier,
        };
        self.slip = if load > 0.0 {
            let tread = self.tread_velocity();
            let sliding = Vector2::new(contact.ahead.dot(&tread), contact.left.dot(&tread));
            self.tyre
                .slip(self.slip, sliding, contact.ahead.dot(&velocity), dt)
        } else {
            Vector2::zeros()
        };
        let force = self.tyre.force(self.slip, self.ground.load);
        self.ground.force += contact.ahead * force.x + contact.left * force.y;
    }

    /// Returns the brake's torque: the one that stops the wheel in one step, if the brake is strong enough.
    fn brake(&self, torque: &Torque, dt: f64) -> f64 {
        (self.rolling() * self.spin_inertia / dt).clamp(-torque.brake, torque.brake)
    }

    /// The wheel's angular velocity on its carrier, rad/s.
    fn rolling(&self) -> f64 {
        self.spin - self.hub.axis.dot(&self.ground.carrier)
    }

    fn tread_velocity(&self) -> Vector3<f64> {
        let Ground {
            contact,
            centre_velocity,
            carrier,
            ..
        } = self.ground;
        centre_velocity + (carrier + self.hub.axis * self.rolling()).cross(&contact.arm)
    }
}

impl Ground {
    fn none(hub: &Hub) -> Self {
        Self {
            contact: Contact::new(1.0, Vector3::z(), hub.axis, 0.0),
            load: 0.0,
            force: Vector3::zeros(),
            centre_velocity: Vector3::zeros(),
            carrier: Vector3::zeros(),
        }
    }
}

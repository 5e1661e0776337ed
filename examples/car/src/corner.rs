//! A corner of the car: wheel, tyre and strut on the hub's motion, and what they do to the equations of motion.
//!
//! Kane's equations with the speeds of the chassis, the rate of travel and the wheel's angular velocity about its axis. The unsprung
//! mass is in the wheel centre. The wheel's moment of inertia is the one about its axis, so that its spin stands in an equation of its own
//! and loads the carrier with the gyroscopic moment `-I spin (turning x axis)`.

use nalgebra::{Matrix3, Vector2, Vector3, Vector6};
use suspension_core::Signal;

use crate::chassis::{Equations, Frame, both};
use crate::contact::Contact;
use crate::equilibrium;
use crate::kinematics::{Drives, Hub, Kinematics, Refused};
use crate::road::Road;
use crate::saloon::{Axle, GRAVITY, Parameters};
use crate::strut::Strut;
use crate::tyre::Tyre;

/// A corner.
pub struct Corner {
    /// Change of the wheel centre's height in chassis axes, from the design, m.
    pub travel: f64,
    /// m/s.
    pub travel_rate: f64,
    /// Angular velocity of the wheel about its axis, rad/s, positive ahead.
    pub spin: f64,
    /// Of the tread: longitudinal and lateral.
    pub slip: Vector2<f64>,
    /// As of the last [`look`](Self::look), in chassis axes from the chassis' origin.
    pub hub: Hub,
    /// As of the last [`touch`](Self::touch).
    pub ground: Ground,
    kinematics: Box<dyn Kinematics>,
    on_the_right: bool,
    origin: Vector3<f64>,
    unsprung_mass: f64,
    spin_inertia: f64,
    strut: Strut,
    tyre: Tyre,
}

/// What is between wheel and road, in chassis axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Where.
    pub contact: Contact,
    /// Along the road's normal, N.
    pub load: f64,
    /// On the wheel, load included, N.
    pub force: Vector3<f64>,
    /// Of the carrier at the wheel centre, m/s.
    centre_velocity: Vector3<f64>,
    /// Angular velocity of the carrier, rad/s.
    carrier: Vector3<f64>,
}

/// Moments about a wheel's axis, N m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Torque {
    /// From a differential on the chassis.
    pub drive: f64,
    /// What a brake on the carrier takes at most.
    pub brake: f64,
}

/// A corner's travel, eliminated from the equations of motion: `inertia b'' + coupling . a = force`.
#[derive(Clone, Copy, Debug)]
pub struct Eliminated {
    inertia: f64,
    coupling: Vector6<f64>,
    force: f64,
    spin_rate: f64,
}

impl Corner {
    /// At rest under its load; `left` are the kinematics of the left corner, on either side.
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

    /// The hub where the wheel is now, `dt` after the last look; `rack` to the left, from straight ahead.
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

    /// What the kinematics of the left corner follow.
    pub fn drives(&self, rack: &Signal<f64>) -> Signal<Drives> {
        let to_left = if self.on_the_right { -1.0 } else { 1.0 };
        let drives = |travel, rack: f64| Drives {
            travel,
            rack: rack * to_left,
        };
        Signal {
            value: drives(self.travel, rack.value),
            rate: drives(self.travel_rate, rack.rate),
            second_rate: drives(0.0, rack.second_rate),
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

    /// Adds the corner to the chassis' equations, its travel eliminated; `bar` is what the anti-roll bar does to the travel, N.
    pub fn add_to(
        &self,
        equations: &mut Equations,
        frame: &Frame,
        torque: &Torque,
        bar: f64,
        dt: f64,
    ) -> Eliminated {
        let Hub {
            centre,
            axis,
            per_travel,
            strut,
            ..
        } = self.hub;
        let Ground {
            contact,
            force: ground,
            carrier,
            ..
        } = self.ground;
        let turning = frame.turning;
        let convective =
            turning.cross(&(turning.cross(&centre.value) + centre.rate * 2.0)) + centre.second_rate;
        let mass = self.unsprung_mass;
        let force = ground + (frame.gravity - convective) * mass;

        let of_ground = contact.arm.cross(&ground);
        let spinning = of_ground.dot(&axis);
        let gyroscopic = carrier.cross(&axis) * (-self.spin_inertia * self.spin);
        let brake = self.brake(torque, dt);
        let moment = of_ground - axis * (spinning - brake) + gyroscopic;

        let arm = centre.value.cross_matrix();
        equations.mass += point_mass(mass, &arm);
        equations.force += both(&force, &(arm * force + moment - axis * torque.drive));
        let row = Eliminated {
            inertia: mass * per_travel.centre.norm_squared(),
            coupling: both(&per_travel.centre, &(arm * per_travel.centre)) * mass,
            force: per_travel.centre.dot(&force)
                + per_travel.turn.dot(&moment)
                + per_travel.strut * self.strut.force(strut)
                + self.strut.stop_force(self.travel)
                + bar,
            spin_rate: (spinning + torque.drive - brake) / self.spin_inertia,
        };
        equations.mass -= row.coupling * row.coupling.transpose() / row.inertia;
        equations.force -= row.coupling * (row.force / row.inertia);
        row
    }

    /// Semi-implicit Euler, under the chassis' accelerations.
    pub fn advance(&mut self, row: &Eliminated, chassis: &Vector6<f64>, dt: f64) {
        self.travel_rate += (row.force - row.coupling.dot(chassis)) / row.inertia * dt;
        self.travel += self.travel_rate * dt;
        self.spin += row.spin_rate * dt;
    }

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

    /// What comes in by the shaft less what brake, damper and tyre take, W. The road is at rest and flat, and so is the rack.
    pub fn power(&self, frame: &Frame, torque: &Torque, dt: f64) -> f64 {
        let Ground { contact, force, .. } = self.ground;
        let tread = self.tread_velocity();
        let deflection = contact.deflection;
        let stored = contact.along_normal(self.tyre.stiffness * deflection.max(0.0));
        let shaft = self.spin - self.hub.axis.dot(&frame.turning);
        self.strut.power(self.hub.strut[1]) + (force - stored).dot(&tread) + torque.drive * shaft
            - self.brake(torque, dt) * self.rolling()
    }

    /// The brake's moment: what would stop the wheel in one step, if it can.
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

/// The mass matrix of a mass at the end of an arm, given the matrix of the arm's cross product.
fn point_mass(mass: f64, arm: &Matrix3<f64>) -> nalgebra::Matrix6<f64> {
    let mut matrix = nalgebra::Matrix6::zeros();
    matrix.fixed_view_mut::<3, 3>(0, 0).fill_diagonal(mass);
    matrix.fixed_view_mut::<3, 3>(3, 0).copy_from(&(arm * mass));
    matrix
        .fixed_view_mut::<3, 3>(0, 3)
        .copy_from(&(arm * -mass));
    matrix
        .fixed_view_mut::<3, 3>(3, 3)
        .copy_from(&(arm * arm * -mass));
    matrix
}

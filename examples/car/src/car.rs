//! The car, and its tick.

use std::error::Error;
use std::fmt;

use nalgebra::Vector6;
use suspension_core::Signal;

use crate::chassis::{Chassis, Frame};
use crate::corner::{Corner, Eliminated, Torque};
use crate::detail::Detail;
use crate::kinematics::{Kinematics, Refused};
use crate::road::Road;
use crate::saloon::Parameters;

/// A chassis on four corners: front left, front right, rear left, rear right.
pub struct Car {
    /// Chassis.
    pub chassis: Chassis,
    /// The four corners.
    pub corners: [Corner; 4],
    bars: [f64; 2],
}

/// Names of the corners, in their order.
pub const CORNERS: [&str; 4] = ["front_left", "front_right", "rear_left", "rear_right"];

/// A corner whose kinematics refuse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stopped {
    /// Its name.
    pub corner: &'static str,
    /// Why.
    pub refused: Refused,
}

/// The inputs of a driver.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Controls {
    /// Place of the rack to the left, from straight ahead, m: ahead of the axle, it turns the car to the left.
    pub rack: Signal<f64>,
    /// The torque at each rear wheel.
    pub drive: f64,
    /// The largest brake torque of each front wheel, and of each rear wheel.
    pub brake: [f64; 2],
}

impl Car {
    /// A car at rest in the design position, with its corners in a detail.
    ///
    /// # Errors
    ///
    /// Those of the details.
    pub fn new(parameters: &Parameters, detail: Detail) -> Result<Self, Box<dyn Error>> {
        let loads = parameters.static_loads();
        let corner = |place: usize| -> Result<Corner, Box<dyn Error>> {
            let [axle, side] = [place / 2, place % 2];
            let left = detail.corner(axle)?;
            Ok(Corner::new(
                left,
                side == 1,
                &parameters.axles[axle],
                parameters,
                loads[axle],
            )?)
        };
        Ok(Self {
            chassis: Chassis::level(
                parameters.sprung_mass,
                parameters.inertia_matrix(),
                parameters.height,
            ),
            corners: [corner(0)?, corner(1)?, corner(2)?, corner(3)?],
            bars: parameters.axles.map(|axle| axle.bar),
        })
    }

    /// Rolling ahead at a speed, m/s.
    pub fn rolling(mut self, speed: f64) -> Self {
        self.chassis.velocity.x = speed;
        let frame = self.chassis.frame();
        for corner in &mut self.corners {
            corner.touch(&frame, &Road::Flat, 0.0);
            corner.spin = speed / corner.ground.contact.arm.norm();
            corner.slip.fill(0.0);
        }
        self
    }

    /// Continues in another detail, whose kinematics are given in the order of the corners, and returns the car's former
    /// kinematics in their place.
    ///
    /// # Errors
    ///
    /// If one of them cannot reach the present position; then nothing has changed.
    pub fn change(
        &mut self,
        others: &mut [Box<dyn Kinematics>; 4],
        controls: &Controls,
    ) -> Result<(), Stopped> {
        for (place, other) in others.iter_mut().enumerate() {
            let drives = self.corners[place].drives(&controls.rack_of(place));
            other.enter(&drives.value).map_err(Stopped::at(place))?;
        }
        for (corner, other) in self.corners.iter_mut().zip(others) {
            corner.change(other);
        }
        Ok(())
    }

    /// One step of semi-implicit Euler.
    ///
    /// # Errors
    ///
    /// Those of the kinematics. Chassis and wheels then stay unchanged and may continue in another detail.
    pub fn tick(&mut self, dt: f64, road: &Road, controls: &Controls) -> Result<(), Stopped> {
        self.look(dt, controls)?;
        let frame = self.touch(dt, road);
        self.advance(dt, &frame, controls);
        Ok(())
    }

    /// Computes the kinematics of the four corners: the first part of a tick.
    ///
    /// # Errors
    ///
    /// Those of the kinematics.
    pub fn look(&mut self, dt: f64, controls: &Controls) -> Result<(), Stopped> {
        for (place, corner) in self.corners.iter_mut().enumerate() {
            let looked = corner.look(dt, &controls.rack_of(place));
            looked.map_err(Stopped::at(place))?;
        }
        Ok(())
    }

    /// The tyres: the second part.
    pub fn touch(&mut self, dt: f64, road: &Road) -> Frame {
        let frame = self.chassis.frame();
        for corner in &mut self.corners {
            corner.touch(&frame, road, dt);
        }
        frame
    }

    /// Accelerations, and a step by them: the last part.
    pub fn advance(&mut self, dt: f64, frame: &Frame, controls: &Controls) {
        let mut equations = self.chassis.equations(frame);
        let rows: [Eliminated; 4] = std::array::from_fn(|place| {
            let (torque, bar) = (controls.torque(place), self.bar(place));
            self.corners[place].add_to(&mut equations, frame, &torque, bar, dt)
        });
        // Masses are positive, so there is a solution.
        let acceleration = equations.solve().unwrap_or_else(Vector6::zeros);
        self.chassis.advance(frame, &acceleration, dt);
        for (corner, row) in self.corners.iter_mut().zip(&rows) {
            corner.advance(row, &acceleration, dt);
        }
    }

    /// Kinetic and stored energy, J, after [`touch`](Self::touch).
    pub fn energy(&self, frame: &Frame) -> f64 {
        let bars = self.bars.iter().enumerate().map(|(axle, bar)| {
            let twist = self.corners[2 * axle].travel - self.corners[2 * axle + 1].travel;
            0.5 * bar * twist * twist
        });
        let corners = self.corners.iter().map(|corner| corner.energy(frame));
        self.chassis.energy() + bars.sum::<f64>() + corners.sum::<f64>()
    }

    /// The power supplied minus the power dissipated, W, after [`touch`](Self::touch), on a flat road with the rack at rest.
    pub fn power(&self, dt: f64, frame: &Frame, controls: &Controls) -> f64 {
        let corners = self.corners.iter().enumerate();
        corners
            .map(|(place, corner)| corner.power(frame, &controls.torque(place), dt))
            .sum()
    }

    /// The force of the anti-roll bar on a corner's travel, N.
    fn bar(&self, place: usize) -> f64 {
        self.bars[place / 2] * (self.corners[place ^ 1].travel - self.corners[place].travel)
    }
}

impl Controls {
    /// The rack that a corner sees: those behind have none.
    pub fn rack_of(&self, place: usize) -> Signal<f64> {
        if place < 2 {
            self.rack
        } else {
            Signal::default()
        }
    }

    fn torque(&self, place: usize) -> Torque {
        Torque {
            drive: if place < 2 { 0.0 } else { self.drive },
            brake: self.brake[place / 2],
        }
    }
}

impl Stopped {
    fn at(place: usize) -> impl Fn(Refused) -> Self {
        move |refused| Self {
            corner: CORNERS[place],
            refused,
        }
    }
}

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.corner, self.refused)
    }
}

impl Error for Stopped {}

//! Tyres, road, struts, stops, bars and driver of the example car, for the motion that an engine reports.

use std::error::Error;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use suspension_car::car::{Car, Controls};
use suspension_car::chassis::Frame;
use suspension_car::detail::Detail;
use suspension_car::drive::{self, DRIVER, ROAD, TICK};
use suspension_car::equilibrium;
use suspension_car::saloon::SALOON;
use suspension_car::strut::Strut;

use crate::interface::{Forces, OnWheel, State, Wheel};

/// A car whose chassis and hubs follow an engine: its own equations are not used.
pub struct Led {
    pub car: Car,
    struts: [Strut; 2],
    design_heights: [f64; 2],
}

impl Led {
    pub fn new() -> Result<Self, Box<dyn Error>> {
        let car = drive::start(Detail::Exact)?;
        let loads = SALOON.static_loads();
        let mut struts = Vec::new();
        for (axle, parameters) in SALOON.axles.iter().enumerate() {
            let hub = Detail::Exact
                .corner(axle)?
                .step(TICK, &Default::default())?;
            let clearance = equilibrium::clearance(&hub, &SALOON.tyre, loads[axle]);
            struts.push(equilibrium::strut(
                &hub,
                parameters,
                &SALOON.tyre,
                clearance,
            ));
        }
        let design_heights = [0, 2].map(|place| car.corners[place].hub.centre.value.z);
        let struts = [struts[0], struts[1]];
        Ok(Self {
            car,
            struts,
            design_heights,
        })
    }

    /// Takes the state of the engine.
    pub fn follow(&mut self, state: &State) {
        let chassis = &mut self.car.chassis;
        let rotation = Matrix3::from(state.rotation);
        let attitude = Rotation3::from_matrix_unchecked(rotation);
        chassis.position = state.position.into();
        chassis.attitude = UnitQuaternion::from_rotation_matrix(&attitude);
        chassis.velocity = state.velocity.into();
        chassis.turning = rotation.tr_mul(&state.turning.into());
        let frame = chassis.frame();
        for (place, wheel) in state.wheels.iter().enumerate() {
            self.follow_wheel(place, wheel, &frame);
        }
    }

    fn follow_wheel(&mut self, place: usize, wheel: &Wheel, frame: &Frame) {
        let corner = &mut self.car.corners[place];
        let to_chassis = |v: [f64; 3]| frame.rotation.tr_mul(&Vector3::from(v));
        let carrier = to_chassis(wheel.turning);
        let hub = &mut corner.hub;
        hub.centre.value = frame
            .rotation
            .tr_mul(&(Vector3::from(wheel.centre) - frame.position));
        hub.centre.rate =
            to_chassis(wheel.velocity) - frame.velocity - frame.turning.cross(&hub.centre.value);
        hub.axis = to_chassis(wheel.axis);
        hub.turning = carrier - frame.turning;
        hub.strut = wheel.strut;
        corner.travel = hub.centre.value.z - self.design_heights[place / 2];
        corner.spin = wheel.rolling + hub.axis.dot(&carrier);
    }

    pub fn controls(&self, time: f64) -> Controls {
        DRIVER.controls(time, &self.car)
    }

    /// The slip of the tyres goes on by `dt`.
    pub fn forces(&mut self, controls: &Controls, dt: f64) -> Forces {
        let frame = self.car.touch(dt, &ROAD);
        let corners = &self.car.corners;
        let wheels = std::array::from_fn(|place| {
            let (corner, other) = (&corners[place], &corners[place ^ 1]);
            let (strut, ground) = (&self.struts[place / 2], &corner.ground);
            let bar = SALOON.axles[place / 2].bar * (other.travel - corner.travel);
            OnWheel {
                force: (frame.rotation * ground.force).into(),
                moment: (frame.rotation * ground.contact.arm.cross(&ground.force)).into(),
                drive: if place < 2 { 0.0 } else { controls.drive },
                travel: strut.stop_force(corner.travel) + bar,
                strut: strut.force(corner.hub.strut),
            }
        });
        Forces { wheels }
    }
}

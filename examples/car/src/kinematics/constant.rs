//! Constant ratios: all quantities change with the drives at their rates in the design.

use nalgebra::Vector3;
use suspension_core::Signal;

use super::{Drives, Hub, Kinematics, PerTravel, Refused};

/// A hub that moves along straight lines, with constant motion ratio, bump steer and camber gain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constant {
    design: Hub,
    per_rack: PerTravel,
}

impl Constant {
    /// Takes the rates of other kinematics at the design position.
    ///
    /// # Errors
    ///
    /// Those of the other kinematics.
    pub fn of(other: &mut dyn Kinematics) -> Result<Self, Refused> {
        let mut at_rate = |rack| {
            let mut drives = Signal::<Drives>::default();
            drives.rate.rack = rack;
            other.step(1e-3, &drives)
        };
        let steered = at_rate(1.0)?;
        Ok(Self {
            design: at_rate(0.0)?,
            per_rack: PerTravel {
                centre: steered.centre.rate,
                turn: steered.turning,
                strut: steered.strut[1],
            },
        })
    }
}

impl Kinematics for Constant {
    fn step(&mut self, _dt: f64, drives: &Signal<Drives>) -> Result<Hub, Refused> {
        let Self { design, per_rack } = self;
        let per_travel = design.per_travel;
        let both = |drives: &Drives, [travel, rack]: [Vector3<f64>; 2]| {
            travel * drives.travel + rack * drives.rack
        };
        let centre = |drives: &Drives| both(drives, [per_travel.centre, per_rack.centre]);
        let turn = |drives: &Drives| both(drives, [per_travel.turn, per_rack.turn]);
        let strut =
            |drives: &Drives| per_travel.strut * drives.travel + per_rack.strut * drives.rack;
        let mut moved = drives.map(centre);
        moved.value += design.centre.value;
        Ok(Hub {
            centre: moved,
            axis: (design.axis + turn(&drives.value).cross(&design.axis)).normalize(),
            turning: turn(&drives.rate),
            strut: [design.strut[0] + strut(&drives.value), strut(&drives.rate)],
            per_travel,
        })
    }
}

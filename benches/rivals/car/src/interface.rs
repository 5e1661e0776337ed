//! The inputs and outputs of the engines, laid out as in `native/car.h`. SI units; vectors are in world axes except in the design.

use std::ffi::c_void;

/// Most points of a corner.
pub const POINTS: usize = 14;

/// The car at its design position, vectors in chassis axes from the chassis' centre of mass.
#[repr(C)]
pub struct Design {
    pub mass: f64,
    pub inertia: [f64; 3],
    pub height: f64,
    pub speed: f64,
    pub gravity: f64,
    pub dt: f64,
    /// Inertia of a wheel across its axis: zero in the example car.
    pub across: f64,
    pub corners: [Corner; 4],
}

/// A corner: front left, front right, rear left, rear right.
#[repr(C)]
pub struct Corner {
    pub points: [[f64; 3]; POINTS],
    pub mass: f64,
    pub spin_inertia: f64,
    pub spin: f64,
}

/// The state that an engine reports before a step.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct State {
    pub position: [f64; 3],
    /// The rotation from chassis axes, column by column.
    pub rotation: [[f64; 3]; 3],
    pub velocity: [f64; 3],
    pub turning: [f64; 3],
    pub wheels: [Wheel; 4],
}

/// A wheel and its strut.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Wheel {
    pub centre: [f64; 3],
    pub velocity: [f64; 3],
    /// The unit vector of the spin axis, to the left.
    pub axis: [f64; 3],
    /// The angular velocity of the carrier.
    pub turning: [f64; 3],
    /// The angular velocity of the wheel on its carrier, about the axis.
    pub rolling: f64,
    /// Length and rate.
    pub strut: [f64; 2],
}

/// The forces of a step.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct Forces {
    pub wheels: [OnWheel; 4],
}

/// The forces at a corner.
#[repr(C)]
#[derive(Clone, Copy, Default)]
pub struct OnWheel {
    /// The force of the road on the wheel, at its centre.
    pub force: [f64; 3],
    pub moment: [f64; 3],
    /// Moment about the axis on the wheel, its opposite on the chassis.
    pub drive: f64,
    /// Force of stop and bar in the wheel centre, upwards in the chassis, its opposite in the same place of the chassis.
    pub travel: f64,
    /// The force that pushes the ends of the strut apart.
    pub strut: f64,
}

/// An engine; the racks are place, rate and second rate.
#[repr(C)]
pub struct Engine {
    pub this: *mut c_void,
    pub look: unsafe extern "C" fn(*mut c_void, *mut State),
    pub step: unsafe extern "C" fn(
        *mut c_void,
        *const Forces,
        rack: *const [f64; 3],
        next: *const [f64; 3],
    ),
}

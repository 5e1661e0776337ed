//! Code that the functions of all linkages share.

use suspension_core::Real;

use crate::describe::{Shape, Structure};
use crate::names::Text;
pub use crate::pointer::Numbers;
use crate::status::Status;

/// Defines structs for C and describes them.
macro_rules! structures {
    ($(
        $(#[doc = $doc:literal])*
        $name:ident { $($(#[doc = $about:literal])* $field:ident: $kind:ty,)* }
    )*) => {
        $(
            $(#[doc = $doc])*
            #[derive(Clone, Copy, Debug)]
            #[repr(C)]
            pub struct $name<T> { $($(#[doc = $about])* pub $field: $kind,)* }
        )*

        pub(crate) const STRUCTURES: &[Structure] = &[$(
            Structure {
                name: stringify!($name),
                docs: &[$($doc),*],
                shape: Shape::Fields(&[
                    $((stringify!($field), stringify!($kind), &[$($about),*])),*
                ]),
            }
        ),*];
    };
}

structures! {
    /// What went wrong.
    Failure {
        /// What the call answers.
        status: Status,
        /// The point, length, equation or unknown concerned, as the listing names it; NULL where there
        /// is none. Lives as long as the program; of a listing from text as long as the object.
        culprit: Text,
        /// What was found: the residual, correction, pivot or the like that `status` speaks of; in the
        /// unit of the points. 0 where nothing is compared.
        value: T,
        /// What `value` had to stay within, or to exceed.
        bound: T,
        /// Of a step in sub-steps: the time from its start, s, up to which there are solutions.
        reached: T,
    }

    /// What a step did.
    Report {
        /// Factorisations for the position.
        iterations: u32,
        /// Sub-steps.
        steps: u32,
        /// The residual that is left, in the unit of the points: the largest, of a bounded step the
        /// norm of all; without corrections a bound, the error.
        residual: T,
        /// What it was compared with.
        tolerance: T,
        /// The first correction of the last step, in the unit of the points: the error of the
        /// predicted position. The largest entry, of a bounded step the norm.
        error: T,
        /// Pivot growth, the norm of the pivots' inverses: rounding grows with it, at most.
        growth: T,
    }

    /// How a configuration was found.
    Assembly {
        /// How far it is from the guess: the norm over all coordinates, in the unit of the points.
        distance: T,
        /// How far the next nearest one that was met is from it; infinite where there is none. Where the
        /// two are nearly alike the guess does not tell which is meant.
        next: T,
        /// The largest residual that is left, in the unit of the points.
        residual: T,
        /// What it was compared with.
        tolerance: T,
    }

    /// A proof, rounding included, that a root lies near a position. Distances are the largest
    /// difference of any unknown, in the unit of the points.
    Certificate {
        /// A root lies within this distance.
        radius: T,
        /// No other root lies within this one.
        unique_within: T,
    }

    /// The wheel; of an axle the first that the listing states. Axes of ISO 8855: x forward, y left, z up.
    Wheel {
        /// Its centre, in the unit of the points.
        centre: [T; 3],
        /// Its spin axis, of unit length, outboard.
        axis: [T; 3],
        /// Camber, rad: positive where the top leans outboard, atan2(-s_z, |s_y|) of the axis s.
        camber: T,
        /// Camber as the angle between spin axis and ground, rad: asin(-s_z).
        camber_to_ground: T,
        /// Toe, rad: positive where the front points inboard, atan2(s_x, |s_y|).
        toe: T,
    }

    /// How the body that carries the wheel turns.
    CarrierRotation {
        /// Angular velocity, rad/s.
        omega: [T; 3],
        /// Angular acceleration, rad/s^2.
        alpha: [T; 3],
    }

    /// The kingpin k, which points upwards.
    Kingpin {
        /// Inclination, rad: positive where the top leans inboard, atan2(-k_y, k_z) on the left.
        angle: T,
        /// Caster, rad: positive where the top leans rearwards, atan2(-k_x, k_z).
        caster: T,
    }

    /// A part that has a mass: with points in m, kg.
    Mass {
        /// How many points say where it is: 1 of a mass in a point, 2 of a uniform rod between two, 3 of a body that three
        /// of its points hold, which are not in line.
        count: u32,
        /// Their numbers, from 0: the places of the members among the points, or what `susp_listing_find` tells.
        points: [u32; 3],
        /// From zero on.
        mass: T,
        /// Of a body, else anything finite: its centre of mass, where its points are as in `design`.
        centre: [T; 3],
        /// Of a body, else anything finite: its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
        /// and zx of the matrix, the products of inertia with a minus: with points in m, kg m^2.
        inertia: [T; 6],
    }

    /// How a chassis moves as a rigid body, in world axes.
    RigidMotion {
        /// From chassis axes to world axes: w, x, y, z. Of any length but zero, else SUSP_ERROR_ARGUMENT.
        rotation: [T; 4],
        /// Position of the chassis' origin, in the unit of the points.
        position: [T; 3],
        /// Its velocity, per second.
        velocity: [T; 3],
        /// Its acceleration, per second squared.
        acceleration: [T; 3],
        /// Angular velocity, rad/s.
        omega: [T; 3],
        /// Angular acceleration, rad/s^2.
        alpha: [T; 3],
    }

    /// A baked motion of the wheel, as `suspension bake` writes it: a piecewise polynomial of one drive.
    Curve {
        /// The drive's first and last value, in rad or the unit of the points.
        range: [T; 2],
        /// The number of segments divided by the length of the range.
        segments_per_unit: T,
        /// By segment, power (six, constants first) and output (six: centre, axis). They must live as
        /// long as the curve is used.
        coefficients: Numbers<T>,
    }

    /// A wheel that was looked up.
    BakedWheel {
        /// Its centre, in the unit of the points.
        centre: [T; 3],
        /// Its spin axis, outboard: of unit length within the tolerance of the curve.
        axis: [T; 3],
    }

    /// The same with its first and second time derivatives.
    BakedWheelRates {
        /// The wheel.
        value: BakedWheel<T>,
        /// Per second.
        rate: BakedWheel<T>,
        /// Per second squared.
        second_rate: BakedWheel<T>,
    }
}

/// See [`Numbers`], whose fields are not for Rust to set.
pub(crate) const NUMBERS: Structure = Structure {
    name: "Numbers",
    docs: &[" Numbers of the caller's."],
    shape: Shape::Fields(&[
        ("numbers", "*const T", &[" The first of them."]),
        ("count", "usize", &[" How many."]),
    ]),
};

/// Masses of the caller's in a field.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Masses<T> {
    // In C a pointer and a count: the same memory.
    masses: Numbers<Mass<T>>,
    gravity: [T; 3],
}

impl<T: Copy> Masses<T> {
    /// Of masses that stay.
    pub fn new(masses: &'static [Mass<T>], gravity: [T; 3]) -> Self {
        let masses = masses.into();
        Self { masses, gravity }
    }

    pub(crate) fn get(&self) -> Result<&[Mass<T>], Status> {
        self.masses.get()
    }

    pub(crate) fn gravity(&self) -> [T; 3] {
        self.gravity
    }
}

/// See [`Masses`], whose fields are not for Rust to set.
pub(crate) const MASSES: Structure = Structure {
    name: "Masses",
    docs: &[" Masses of the caller's in a field."],
    shape: Shape::Fields(&[
        ("masses", "*const Mass", &[" The first of them; not NULL."]),
        ("count", "usize", &[" How many."]),
        (
            "gravity",
            "[T; 3]",
            &[
                " The acceleration of free fall, in the unit of the points per second squared; less that of the chassis,",
                " where it has one.",
            ],
        ),
    ]),
};

impl<T: Real> Failure<T> {
    pub(crate) fn of(status: Status) -> Self {
        Self {
            status,
            culprit: Text::NONE,
            value: T::zero(),
            bound: T::zero(),
            reached: T::zero(),
        }
    }
}

//! Items that the functions of all linkages share.

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
    /// Details of a failure.
    Failure {
        /// The status that the call returns.
        status: Status,
        /// The drive, point, length, equation or unknown concerned, by its name in the listing; NULL if
        /// there is none. Lives as long as the program, or with a listing from text as long as the object.
        culprit: Text,
        /// The residual, correction, pivot or other number to which `status` refers, in the unit of the
        /// points; 0 if there is none.
        value: T,
        /// The limit for `value`.
        bound: T,
        /// For steps in sub-steps: the time from the start of the step, s, up to which there are solutions.
        reached: T,
    }

    /// The report of a step.
    Report {
        /// The number of factorisations for the position.
        iterations: u32,
        /// The number of sub-steps.
        steps: u32,
        /// The remaining residual, in the unit of the points: the largest, or for a bounded step the norm.
        /// Without corrections it is a bound, `error`.
        residual: T,
        /// The limit for the residual.
        tolerance: T,
        /// The first correction of the last step, in the unit of the points: the error of the predicted
        /// position. The largest entry, or for a bounded step the norm.
        error: T,
        /// Pivot growth, the norm of the inverses of the pivots: about how much rounding errors grow.
        growth: T,
    }

    /// The report of an assembly.
    Assembly {
        /// The distance from the guess: the norm over all coordinates, in the unit of the points.
        distance: T,
        /// The distance of the next nearest configuration that was found; infinite if there was none. If
        /// both distances are nearly equal the guess is ambiguous.
        next: T,
        /// The largest remaining residual, in the unit of the points.
        residual: T,
        /// The limit for the residual.
        tolerance: T,
    }

    /// A proof, rounding included, that a root is near a position. Distances are the largest difference of
    /// any unknown, in the unit of the points.
    Certificate {
        /// There is a root within this distance.
        radius: T,
        /// There is no other root within this distance.
        unique_within: T,
    }

    /// The wheel, or the first wheel that the listing of an axle states. Axes of ISO 8855: x forward, y
    /// left, z up.
    Wheel {
        /// The wheel centre, in the unit of the points.
        centre: [T; 3],
        /// The spin axis, of unit length, outboard.
        axis: [T; 3],
        /// Camber, rad: positive if the top leans outboard, atan2(-s_z, |s_y|) of the axis s.
        camber: T,
        /// Camber as the angle between spin axis and ground, rad: asin(-s_z).
        camber_to_ground: T,
        /// Toe, rad: positive if the front points inboard, atan2(s_x, |s_y|).
        toe: T,
    }

    /// The wheel with its first and second derivatives, with respect to time or to a change of the drives.
    WheelRates {
        /// The wheel.
        value: Wheel<T>,
        /// Per second, or per unit of the change.
        rate: Wheel<T>,
        /// Per second squared, or per unit of the change squared.
        second_rate: Wheel<T>,
    }

    /// The rotation of the body that carries the wheel.
    CarrierRotation {
        /// Angular velocity, rad/s.
        omega: [T; 3],
        /// Angular acceleration, rad/s^2.
        alpha: [T; 3],
    }

    /// The kingpin k, which points upwards.
    Kingpin {
        /// Inclination, rad: positive if the top leans inboard, atan2(-k_y, k_z) on the left.
        angle: T,
        /// Caster, rad: positive if the top leans rearwards, atan2(-k_x, k_z).
        caster: T,
    }

    /// A part with a mass. With points in m the mass is in kg, with points in mm in t: forces are then in N.
    Mass {
        /// The number of points that locate it: 1 for a mass at a point, 2 for a uniform rod between two
        /// points, 3 for a body with these three points, which are not in line.
        count: u32,
        /// The numbers of these points, from 0: the order of the members of the points, or the result of
        /// `susp_listing_find`.
        points: [u32; 3],
        /// The mass, zero or positive.
        mass: T,
        /// For a body, its centre of mass, for the points as in `design`; otherwise any finite numbers.
        centre: [T; 3],
        /// For a body, its inertia about that centre in the axes of `design`, entries xx, yy, zz, xy, yz
        /// and zx of the matrix, which are the products of inertia with a minus sign: with points in m, kg
        /// m^2, with points in mm, t mm^2. Otherwise any finite numbers.
        inertia: [T; 6],
    }

    /// The motion of the chassis as a rigid body, in world axes.
    RigidMotion {
        /// The quaternion w, x, y, z from chassis axes to world axes. Any length but zero, which is
        /// SUSP_ERROR_ARGUMENT.
        rotation: [T; 4],
        /// Position of the chassis' origin, in the unit of the points.
        position: [T; 3],
        /// Velocity of the origin, per second.
        velocity: [T; 3],
        /// Acceleration of the origin, per second squared.
        acceleration: [T; 3],
        /// Angular velocity, rad/s.
        omega: [T; 3],
        /// Angular acceleration, rad/s^2.
        alpha: [T; 3],
    }

    /// A baked motion of the wheel from `suspension bake`: a piecewise polynomial of one drive.
    Curve {
        /// The drive's first and last value, in rad or the unit of the points.
        range: [T; 2],
        /// The number of segments divided by the length of the range.
        segments_per_unit: T,
        /// By segment, power (six, constants first) and output (six: centre, axis). They must live as long
        /// as the curve is used.
        coefficients: Numbers<T>,
    }

    /// A wheel computed from a curve.
    BakedWheel {
        /// The wheel centre, in the unit of the points.
        centre: [T; 3],
        /// The spin axis, outboard: of unit length within the tolerance of the curve.
        axis: [T; 3],
    }

    /// The wheel with its first and second time derivatives.
    BakedWheelRates {
        /// The wheel.
        value: BakedWheel<T>,
        /// Per second.
        rate: BakedWheel<T>,
        /// Per second squared.
        second_rate: BakedWheel<T>,
    }
}

/// The description of [`Numbers`], whose fields are private in Rust.
pub(crate) const NUMBERS: Structure = Structure {
    name: "Numbers",
    docs: &[" An array of numbers of the caller."],
    shape: Shape::Fields(&[
        ("numbers", "*const T", &[" The first number."]),
        ("count", "usize", &[" The number of elements."]),
    ]),
};

/// An array of masses in a field of gravity.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Masses<T> {
    // A pointer and a count in C, with the same layout.
    masses: Numbers<Mass<T>>,
    gravity: [T; 3],
}

impl<T: Copy> Masses<T> {
    /// Makes the description of masses that live as long as the program.
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

/// The description of [`Masses`], whose fields are private in Rust.
pub(crate) const MASSES: Structure = Structure {
    name: "Masses",
    docs: &[" An array of masses of the caller, and the gravity that acts on them."],
    shape: Shape::Fields(&[
        ("masses", "*const Mass", &[" The first mass; not NULL."]),
        ("count", "usize", &[" The number of elements."]),
        (
            "gravity",
            "[T; 3]",
            &[
                " The acceleration of free fall minus that of the chassis, in the unit of the points per second",
                " squared.",
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

//! A mechanism of any linkage, ready to move, with the file's coordinates outside and local ones inside.
//!
//! `driven_linkage` is the mechanism, with its named `parts`. It is in `motion` over time, or at the places of a `grid` of its
//! drives; either way it has a `state`, with `derivatives`. A `lock` is where it goes no further, and why.

mod derivatives;
mod description;
mod driven_linkage;
mod extent;
mod grid;
mod lock;
mod measure;
mod motion;
mod parts;
mod plausibility;
mod points;
mod state;
mod statics;
mod suspension;

pub use derivatives::design_derivatives::{DesignDerivatives, Expansion};
pub use derivatives::gradient::{DRIVES_AT_ONCE, Gradient};
pub use derivatives::place_data::DerivativeOrder;
pub use derivatives::positions::Positions;
pub use derivatives::sensitive::{CHANGES_AT_ONCE, InDesign, Sensitive};
pub use description::Description;
pub use driven_linkage::{FindDesignDerivatives, Mechanism};
pub use extent::{ends, extent};
pub use grid::axis::GridAxis;
pub(crate) use grid::axis::moved_together;
pub use grid::place::{OnPlace, Place, VisitEnd};
pub use grid::visited::Visited;
pub use grid::{CountedFrom, Grid, MOST_PLACES, evenly_spaced};
pub use lock::{Lock, describe_change_from_design, report_of_singular};
pub(crate) use measure::nearest;
pub use motion::drive_laws::{DriveLaws, follow};
pub(crate) use motion::drive_laws::{inputs_at_rest, tracker, unit_change};
pub use motion::end::{End, Stop};
pub use motion::law::{Law, Sine};
pub use motion::lead::Lead;
pub(crate) use motion::lead::lead;
pub use motion::moving::OnState;
pub use motion::spline::Spline;
pub use parts::driven_length::DrivenLength;
pub use parts::guide::Guide;
pub use parts::hinge::Hinge;
pub use parts::mass::Mass;
pub use parts::names::{Drive, Measure, Names};
pub(crate) use parts::sides::name_on_other_side;
pub use parts::sides::{Pair, side_of};
pub use parts::spring::Spring;
pub use parts::vehicle::{Coupling, SteeringWheel, Vehicle, Wheel, WheelPoints};
pub use parts::words::{advice, listed, quoted};
pub use plausibility::DriveAtDesign;
pub use points::Points;
pub use state::{Moved, State, WheelMovement};
pub use statics::Borne;
pub use suspension::Suspension;
pub use suspension_motion_file::{Angle, Axes, Axle, Instants, Length, Torque, Unit, is_within};

//! The kinematic characteristics of a suspension: quantities at the design position with their derivatives, and curves
//! over travel and steering; and all quantities at the places of a grid.

mod all_curves;
mod check_spans;
mod curves;
mod design_number;
mod grid_table;
mod line;
mod mode_states;
mod modes;
mod movement;
mod over_wheel_travel;
mod parameters;
mod per_wheel;
mod poles;
mod small_steer;
mod span;
mod suggestions;
mod title;
mod wheel_rise;

pub use all_curves::all_curves;
pub use check_spans::check_spans;
pub use curves::{Curves, curves};
pub use design_number::{DesignNumber, refuse_unknown_numbers};
pub use grid_table::{GridTable, columns_of_positions};
pub use line::{Line, Sort};
pub use mode_states::{
    ModeStates, mode_states, no_steering, shorter_roll, unmet_range, usual_change,
};
pub use modes::{Mode, counted_downwards};
pub use movement::{Effect, Movement};
pub(crate) use parameters::columns_in;
pub use parameters::{Derivative, Parameter, columns, parameters};
pub use per_wheel::Rises;
pub use span::{Span, through_design};
pub(crate) use suggestions::meant;
pub use suggestions::{not_of_this, suggest_for_wheels};
pub use title::{Title, as_in_tables};
pub use wheel_rise::Rise;

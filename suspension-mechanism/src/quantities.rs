//! The quantities of a mechanism: one catalogue, from which tables, plots, summaries and help are made.

mod axis;
mod brake_and_drive;
mod catalogue;
mod formulas;
mod from_design;
mod in_roll;
mod inert;
mod number;
mod of_axle;
mod on_ground;
mod places;
mod quantity;
mod reader;
mod readings;
mod sprung;
mod steering_wheel;
mod two_drives;
mod wheel;
mod words;

pub use axis::Axis;
pub use catalogue::{
    ACCELERATIONS, ACKERMANN, ACKERMANN_ERROR, ALPHA, ANTI_DIVE, ANTI_LIFT, ANTI_LIFT_IN_DRIVE,
    ANTI_SQUAT, AXLE_ROLL_CENTRE, BRAKE_ANGLE, CAMBER, CAMBER_TO_GROUND, CASTER, CASTER_OFFSET,
    CENTRE, CONTACT, DRIVE_ANGLE, DRIVES, EFFECTIVE_MASS, FRONT_ARM, FRONT_CENTRE,
    HALF_TRACK_CHANGE, HEAVE_RATE, ITERATIONS, JACKING, KINGPIN, KINGPIN_OFFSET, MARKERS, MEASURES,
    MECHANICAL_TRAIL, OMEGA, POSITIONS, RECESSION, RESIDUAL, ROLL_CAMBER, ROLL_CENTRE, ROLL_RATE,
    ROLL_STEER, SCRUB_RADIUS, SIDE_ARM, SIDE_CENTRE, SPRING_FORCES, SPRING_LOAD, STEER_ANGLE,
    STEERING_RATIO, STEERING_WHEEL_ANGLE, TIME, TOE, TOTAL_TOE, TRACK, TRACK_CHANGE,
    TURNING_RADIUS, VELOCITIES, VIRTUAL_CASTER, VIRTUAL_KINGPIN, VIRTUAL_PITCH,
    VIRTUAL_SCRUB_RADIUS, VIRTUAL_TRAIL, WHEEL_RATE, WHEEL_TRAVEL, WHEELBASE_CHANGE, catalogue,
    from_design, is_driven_angle, of_axles,
};
pub use formulas::Compiled;
pub use number::Number;
pub use quantity::{Column, Quantity, Shown, columns, columns_in};
pub use reader::Reader;
pub use words::in_words;

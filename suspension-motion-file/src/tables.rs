//! The tables of a motion file, as they are written.

pub(crate) mod entries;
pub(crate) mod loads;
pub(crate) mod mass;
pub(crate) mod number_list;
pub(crate) mod per_wheel;
pub(crate) mod position;
pub(crate) mod several_notations;
pub(crate) mod spring;
pub(crate) mod stated_law;
pub(crate) mod target_values;
pub(crate) mod torque;
pub(crate) mod tune;
pub(crate) mod vehicle;

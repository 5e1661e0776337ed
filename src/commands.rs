//! The commands, each with its options, its work and its report. No command uses another.

pub mod assemblies;
pub mod bake;
pub mod check;
pub mod compare;
pub mod draw;
pub mod import;
pub mod list;
pub mod loads;
pub mod motion;
pub mod published;
pub mod range;
pub mod sensitivities;
pub mod sheet;
pub mod sweep;
pub mod tables;
pub mod tune;
pub mod vary;

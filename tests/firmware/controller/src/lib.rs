//! A control loop that drives the published five-point suspension through its motion, with one millisecond per step.
//!
//! The same code runs on emulated microcontrollers, where each step's instructions are counted, and on the host, whose
//! results must agree.
#![no_std]

pub mod baked;
mod checksum;
mod follow;
pub mod modes;
mod published;
pub mod steps;
#[rustfmt::skip]
mod wheel_by_theta;

pub use follow::{Gauge, Report};

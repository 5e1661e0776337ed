//! The motion as a polynomial in time: coefficients, order, radius and steps.

mod support;

#[path = "series/chassis.rs"]
mod chassis;
#[path = "series/coefficients.rs"]
mod coefficients;
#[path = "series/random.rs"]
mod random;
#[path = "series/steps.rs"]
mod steps;

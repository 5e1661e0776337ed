//! The motion as a polynomial in time: coefficients, order, radius and steps.

mod chassis;
mod coefficients;
mod steps;

//! Drives the car.

fn main() {}

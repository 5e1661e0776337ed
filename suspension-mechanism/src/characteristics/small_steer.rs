//! The curve of the Ackermann percentage without small steer angles.

use crate::characteristics::line::Line;
use crate::file::is_within;
use crate::quantities::{ACKERMANN, STEER_ANGLE};

/// The steer angle, in degrees, from which the Ackermann percentage is drawn. If a wheel is steered by less, static toe
/// is a large part of the difference between the wheels, and the percentage runs to values far from those at full lock.
pub(super) const LEAST_STEER: f64 = 5.0;

/// Removes the Ackermann percentage of each axle where one of its wheels is steered by less; returns whether it had a
/// value there.
pub(super) fn leave_out(lines: &mut [Line]) -> bool {
    let steered = lines.iter();
    let steered = steered.filter(|line| line.title.of_wheel == STEER_ANGLE.title);
    let steered: Vec<Line> = steered.cloned().collect();
    let mut is_left_out = false;
    let percentages = lines.iter_mut();
    for line in percentages.filter(|line| line.title.of_wheel == ACKERMANN.title) {
        let axle = line.title.wheel.clone().unwrap_or_default();
        let is_of_axle = |wheel: &&Line| {
            let name = wheel.title.wheel.as_deref().unwrap_or_default();
            axle.is_empty() || is_within(&axle, name)
        };
        for (place, value) in line.values.iter_mut().enumerate() {
            let mut angles = steered.iter().filter(is_of_axle);
            let is_small = angles
                .any(|angle| angle.values[place].is_none_or(|angle| angle.abs() < LEAST_STEER));
            is_left_out |= is_small && value.take_if(|_| is_small).is_some();
        }
    }
    is_left_out
}

//! Bars along an angle between two lines that no drive changes at the design position.

use nalgebra::Vector3;
use suspension_core::Values;
use suspension_runtime::Listing;

use crate::mechanism::{Names, Spring, Suspension};
use crate::prepare::design::Design;

/// What rounding alone may leave of an angle's derivative, as a part of how fast its lines turn; and of the sine of a zero angle.
const ROUNDING: f64 = 1e-7;

/// How the angle of two lines stands at the design position.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Angle {
    /// The lines are parallel, and the angle has no derivatives.
    Parallel,
    /// Drives turn the lines, and none changes the angle.
    Still,
    Changing,
}

/// A note on each spring along such an angle.
pub(in crate::prepare) fn notes<L: Suspension<N>, const N: usize>(
    names: &Names,
    design: &Design<L, N>,
    listing: &Listing,
) -> Vec<String> {
    let springs = names.vehicle.springs.iter();
    let notes = springs.filter_map(|spring| {
        let lines = listing.measured_between(spring.measure)?;
        let what = in_words(angle(names, design, lines), names, spring)?;
        let [one, other] = lines.map(|line| {
            let [from, to] = line.map(|point| &names.points[point]);
            format!("{from} -> {to}")
        });
        Some(format!(
            "{what}; an angle between two lines has no sign: state the twist of a bar about the line of the bar, as \
             angle({one}, {other} about bar_right -> bar_left)"
        ))
    });
    notes.collect()
}

fn in_words(angle: Angle, names: &Names, spring: &Spring) -> Option<String> {
    let (measure, spring) = (&names.measures[spring.measure].name, &spring.name);
    match angle {
        Angle::Parallel => Some(format!(
            "the lines of the angle `{measure}` are parallel at the design position, where it has no derivatives, and so the \
             spring `{spring}` no rate"
        )),
        Angle::Still => Some(format!(
            "no drive changes the angle `{measure}` at the design position, and so none twists the spring `{spring}` there"
        )),
        Angle::Changing => None,
    }
}

fn angle<L: Suspension<N>, const N: usize>(
    names: &Names,
    design: &Design<L, N>,
    lines: [[usize; 2]; 2],
) -> Angle {
    let points: Vec<_> = design.points.values().collect();
    let along = |points: &[Vector3<f64>]| lines.map(|[from, to]| points[to] - points[from]);
    let [one, other] = along(&points);
    let (lengths, normal) = ([one.norm(), other.norm()], one.cross(&other));
    if normal.norm() <= ROUNDING * lengths[0] * lengths[1] {
        return Angle::Parallel;
    }
    let normal = normal.normalize();
    let drives = (0..names.drives.len()).filter_map(|drive| design.per(drive));
    // How fast each line turns, and how fast the one turns to the other in their plane.
    let turns = drives.map(|rates| {
        let [of_one, of_other] = along(&rates);
        let rates = [
            one.cross(&of_one) / lengths[0].powi(2),
            other.cross(&of_other) / lengths[1].powi(2),
        ];
        let opens = (rates[1] - rates[0]).dot(&normal).abs();
        (rates[0].norm() + rates[1].norm(), opens)
    });
    let turns: Vec<(f64, f64)> = turns.collect();
    let turning = turns.iter().map(|(turns, _)| turns).sum::<f64>();
    let opening = turns.iter().map(|(_, opens)| opens).sum::<f64>();
    if turning > 0.0 && opening <= ROUNDING * turning {
        Angle::Still
    } else {
        Angle::Changing
    }
}

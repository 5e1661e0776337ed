//! Springs whose motion ratio changes its sign within the travel.

use suspension_core::listing::MeasureKind;

use crate::characteristics::{Curves, Effect, Line, Sort};
use crate::mechanism::{Names, Spring, Unit};
use crate::number::rounded;

/// Motion ratios of the other sign that count; those of rounding or of slightly different sides are smaller.
const LEAST: f64 = 0.01;

/// Returns a sentence for each spring whose measured length is longest or shortest within the travel.
pub(super) fn notes(names: &Names, curves: &[Curves], unit: Unit) -> Vec<String> {
    let springs = names.vehicle.springs.iter();
    let springs = springs.filter(|spring| spring.kind == MeasureKind::Length);
    springs
        .filter_map(|spring| note(spring, &names.measures[spring.measure].name, curves, unit))
        .collect()
}

fn note(spring: &Spring, measure: &str, curves: &[Curves], unit: Unit) -> Option<String> {
    let over_travel = curves
        .iter()
        .filter(|curves| curves.movement.effect == Effect::Travel);
    let (curves, at) = over_travel
        .flat_map(|curves| curves.lines.iter().map(move |line| (curves, line)))
        .filter(|(_, line)| line.sort == Sort::MotionRatio && line.quantity == measure)
        .find_map(|(curves, line)| Some((curves, change_of_sign(&curves.changes, line)?)))?;
    let (_, symbol) = curves.dimension.display_scale(unit);
    Some(format!(
        "`{measure}` is longest or shortest at {} {symbol} of {}, as where a rocker goes over centre; beyond, the spring `{}` moves \
         the other way",
        rounded(at, 3),
        curves.title,
        spring.name
    ))
}

/// Returns the first change at which a line passes through zero, if it has considerable values on both sides.
fn change_of_sign(changes: &[f64], line: &Line) -> Option<f64> {
    let values: Vec<(f64, f64)> = changes
        .iter()
        .zip(&line.values)
        .filter_map(|(change, value)| Some((*change, (*value)?)))
        .collect();
    let exceeds = |sign: f64| values.iter().any(|(_, value)| sign * value > LEAST);
    if !(exceeds(1.0) && exceeds(-1.0)) {
        return None;
    }
    values.windows(2).find_map(|pair| {
        let [(from, a), (to, b)] = *pair else {
            return None;
        };
        (a * b <= 0.0 && a != b).then(|| {
            let at = from + (to - from) * a / (a - b);
            // The design position itself, but for rounding.
            if at.abs() < 1e-6 * (to - from) {
                0.0
            } else {
                at
            }
        })
    })
}

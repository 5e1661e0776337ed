//! What masses are at the wheels: readings by kinetic energy.

use crate::mechanism::{Names, Points, State};
use crate::quantities::formulas::Reading;
use crate::quantities::kind::Kind;
use crate::quantities::number::Number;
use crate::quantities::readings::{of_each_wheel, without_derivatives};
use crate::quantities::wheel::Rolling;

/// The mass at each wheel centre that moves in height as all parts with masses do in travel.
pub(super) fn of_wheels<N: Number>(names: &Names) -> Vec<Reading<N>> {
    let has_masses = !names.vehicle.masses.is_empty();
    of_each_wheel(names, &|rolling| {
        let Some(drive) = rolling.travel.filter(|_| has_masses) else {
            return Vec::new();
        };
        let together = rolling.moved_together(names);
        let beside = rolling.beside(names);
        vec![without_derivatives(Kind::Mass, move |state| {
            let velocities = &state.moved_by(drive)?.value;
            match beside {
                Some(beside) => effective(state, &together, &held(state, velocities, beside)?),
                None => effective(state, &together, velocities),
            }
        })]
    })
}

/// Of one of the wheels that move together.
fn effective(state: &State, together: &[Rolling], velocities: &Points) -> Option<f64> {
    let energies = state.masses.iter();
    let energies =
        energies.map(|mass| mass.twice_energy(&state.points.value, velocities, state.metre));
    let twice_energy: f64 = energies.sum::<Option<f64>>()?;
    let rises = together
        .iter()
        .map(|rolling| rise(state, velocities, rolling) / state.metre);
    let squares: f64 = rises.map(|rise| rise * rise).sum();
    Some(twice_energy / squares)
}

/// Velocities with those of a wheel's own drive, so that it stays at its height.
fn held(state: &State, velocities: &Points, wheel: Rolling) -> Option<Points> {
    let own = &state.moved_by(wheel.travel?)?.value;
    let part = rise(state, velocities, &wheel) / rise(state, own, &wheel);
    let each = velocities.iter().zip(own.iter());
    let held = each.map(|(velocity, own)| velocity - own * part);
    part.is_finite().then(|| held.collect())
}

fn rise(state: &State, velocities: &Points, wheel: &Rolling) -> f64 {
    let [_, centre] = wheel.points.axis;
    state.axes.turned(velocities[centre]).z
}

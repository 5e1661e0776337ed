//! Effective masses at the wheels: readings by kinetic energy.

use crate::file::Dimension;
use crate::mechanism::{Names, State, WheelMovement};
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::reader::wheel::Rolling;
use crate::quantities::readings::{of_each_wheel, without_derivatives};

/// The mass at each wheel centre whose motion in height is equivalent to that of all parts with masses in travel.
pub(crate) fn of_wheels<N: Number>(names: &Names) -> Vec<Reading<N>> {
    let has_masses = !names.vehicle.masses.is_empty();
    of_each_wheel(names, &|rolling| {
        let drive = rolling.travel.filter(|_| has_masses)?;
        let together = rolling.moved_together(names);
        Some(without_derivatives(Dimension::Mass, move |state| {
            effective(state.moved_along(WheelMovement::Travel(drive))?, &together)
        }))
    })
}

/// The effective mass at one of the wheels that move together, in a state with derivatives along this movement.
fn effective(state: &State, together: &[Rolling]) -> Option<f64> {
    let velocities = &state.points.rate;
    let energies = state.masses.iter();
    let energies =
        energies.map(|mass| mass.twice_energy(&state.points.value, velocities, state.metre));
    let twice_energy: f64 = energies.sum::<Option<f64>>()?;
    let rises = together.iter().map(|rolling| {
        let [_, centre] = rolling.points.axis;
        state.axes.turned(velocities[centre]).z / state.metre
    });
    let squares: f64 = rises.map(|rise| rise * rise).sum();
    Some(twice_energy / squares)
}

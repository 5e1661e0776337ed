//! Masses, centres of mass and inertias that seem to be in another unit.

use suspension_core::inertia::RigidBody;

use crate::mechanism::{Mass, Names};
use crate::number::{number, rounded};
use crate::prepare::task::Task;

/// The mass in kg above which a part is not one of a suspension.
const LARGEST: f64 = 5000.0;

/// The radius of gyration above which an inertia is in another unit, as a multiple of the extent of the body's points.
const FAR: f64 = 10.0;

/// Notes on the masses of `names`, which are in the order of the file.
pub(in crate::prepare) fn notes(task: &Task<'_>, names: &Names) -> Vec<String> {
    let table = task.file.masses.iter();
    let stated = table.flat_map(|table| table.get_ref().iter());
    let masses = stated.zip(names.vehicle.masses.iter());
    let notes = masses.flat_map(|((name, _), mass)| {
        let name = name.get_ref();
        let (kg, body) = match mass {
            Mass::At(_, kg) | Mass::Rod(_, kg) => (*kg, None),
            Mass::Body { body, .. } => (body.mass, Some(body)),
        };
        let heavy = (kg > LARGEST).then(|| {
            let kg = number(kg);
            format!("the mass of `{name}` is {kg} kg: is it in grams? Masses are in kg")
        });
        let of_body =
            body.and_then(|body| inertia(name, body).or_else(|| centre(task, name, body)));
        [heavy, of_body].into_iter().flatten()
    });
    notes.collect()
}

/// A note on an inertia that no part of the size of the body has.
fn inertia(name: &str, body: &RigidBody<f64>) -> Option<String> {
    let radius = (body.inertia.trace() / (2.0 * body.mass)).sqrt();
    (body.mass > 0.0 && radius > FAR * extent(body)).then(|| {
        let radius = rounded(radius, 3);
        format!("the inertia of `{name}` is that of a mass {radius} m from its centre: is it in kg mm^2? Inertias are in kg m^2")
    })
}

/// A note on a centre of mass that is beside the body.
fn centre(task: &Task<'_>, name: &str, body: &RigidBody<f64>) -> Option<String> {
    let away = body.points.map(|point| (body.centre - point).norm());
    let nearest = away.into_iter().fold(f64::INFINITY, f64::min);
    (nearest > extent(body)).then(|| {
        let unit = task.file.length;
        let [nearest, extent] = [nearest, extent(body)].map(|metres| rounded(metres * unit.metre(), 3));
        let symbol = unit.symbol();
        format!(
            "the centre of mass of `{name}` is {nearest} {symbol} from the points of this part, which are up to {extent} {symbol} apart: \
             are its coordinates in the unit and the axes of the file?"
        )
    })
}

/// The largest distance between the points that hold a body.
fn extent(body: &RigidBody<f64>) -> f64 {
    let [a, b, c] = body.points;
    let sides = [a - b, b - c, c - a];
    sides.iter().map(|side| side.norm()).fold(0.0, f64::max)
}

//! The drawing of a load case.

use nalgebra::Vector3;
use suspension_runtime::Listing;

use crate::kinematics::Kinematics;
use crate::loads::{By, Case, Outcome, Structure};
use crate::mechanism::State;
use crate::output::drawing::{Acting, Drawing, Forces, InLink, drawing_of};

/// Draws the mechanism at the first place, in words `place`, with the forces of a case there.
pub(super) fn drawing(
    (mechanism, listing): (&dyn Kinematics, &Listing),
    structure: &Structure<'_>,
    case: &Case,
    (first, place, outcome): (&State, &str, Option<&Outcome>),
) -> Drawing {
    let mut drawing = drawing_of(mechanism, listing, None);
    for (number, at) in drawing.points.iter_mut().enumerate() {
        *at = first.position(number);
    }
    let links = outcome.into_iter().flat_map(|outcome| &outcome.links);
    let links = links.filter_map(|(statement, tension)| {
        let link = &structure.statements[*statement];
        Some(InLink {
            ends: *link.points.first_chunk()?,
            tension: *tension,
        })
    });
    let lengths = drawing.lengths.iter();
    let lengths = lengths.filter_map(|ends| in_length(outcome?, first, *ends));
    let links = links.chain(lengths).collect();
    let acting = structure.acting(mechanism, case, first).into_iter();
    let acting = acting.filter(|[_, force]| *force != Vector3::zeros());
    let acting = acting.map(|[at, force]| Acting { at, force });
    drawing.forces = Some(Forces {
        title: [
            format!(
                "load case {}: tension positive and blue, compression negative and red",
                case.name
            ),
            format!("at {place}"),
        ],
        links,
        acting: acting.collect(),
    });
    drawing
}

/// Returns the force along a measured length, for example of a spring; `None` if no load acts along it.
fn in_length(outcome: &Outcome, first: &State, [from, to]: [usize; 2]) -> Option<InLink> {
    let along = (first.position(to) - first.position(from)).normalize();
    let at = |end: usize| {
        let joints = outcome.joints.iter();
        joints.filter(move |(by, point, _)| matches!(by, By::Measure(_)) && *point == end)
    };
    // Without the moments about angles of the same line.
    let pressing = at(to).filter_map(|(by, _, force)| {
        let is_along = force.cross(&along).norm() <= 1e-9 * force.norm();
        let is_of_both = at(from).any(|(other, ..)| other == by);
        (is_along && is_of_both).then_some(force.dot(&along))
    });
    Some(InLink {
        ends: [from, to],
        tension: -pressing.reduce(|sum, force| sum + force)?,
    })
}

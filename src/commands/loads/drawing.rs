//! The picture of a load case.

use nalgebra::Vector3;
use suspension_runtime::Listing;

use crate::kinematics::Kinematics;
use crate::loads::{Case, Outcome, Structure};
use crate::mechanism::State;
use crate::output::drawing::{Acting, Drawing, Forces, InLink, drawing_of};

/// The mechanism at its first place, with what a case does there.
pub(super) fn drawing(
    (mechanism, listing): (&dyn Kinematics, &Listing),
    structure: &Structure<'_>,
    case: &Case,
    (first, outcome): (&State, Option<&Outcome>),
) -> Drawing {
    let mut drawing = drawing_of(mechanism, listing, None);
    for (number, (_, at)) in drawing.points.iter_mut().enumerate() {
        *at = first.position(number).into();
    }
    let links = outcome.into_iter().flat_map(|outcome| &outcome.links);
    let links = links.filter_map(|(statement, tension)| {
        let link = &structure.statements[*statement];
        Some(InLink {
            ends: *link.points.first_chunk()?,
            tension: *tension,
        })
    });
    let acting = structure.acting(mechanism, case, first).into_iter();
    let acting = acting.filter(|[_, force]| *force != Vector3::zeros());
    let acting = acting.map(|[at, force]| Acting {
        at: at.into(),
        force: force.into(),
    });
    drawing.forces = Some(Forces {
        title: format!(
            "load case {}: links in tension blue, in compression red",
            case.name
        ),
        links: links.collect(),
        acting: acting.collect(),
    });
    drawing
}

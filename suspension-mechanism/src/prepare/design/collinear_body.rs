//! The refusal of bodies whose first three points, which carry the other points, lie in line.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::GeometryError;
use suspension_runtime::{FlatBody, Listing};

use crate::failure::Failure;
use crate::prepare::task::Task;

/// The refusal, if this is why there is no model, with an order in which the points of the body can carry the others.
pub(crate) fn refused(
    task: &Task<'_>,
    listing: Option<&Listing>,
    positions: &[Vector3<f64>],
    error: &GeometryError,
) -> Option<Failure> {
    let GeometryError::Collinear { point } = *error else {
        return None;
    };
    let body = listing?.flat_body(point, positions)?;
    let Task { source, file, .. } = task;
    let points = file.points.get_ref();
    let [.., third] = body.in_line;
    let statement = file.statements.is_some();
    let statement = statement.then(|| statement_of(source.text(), &body));
    let place = statement
        .flatten()
        .or_else(|| Some(points.get(third)?.span()));
    let place = place.unwrap_or_else(|| file.points.span());
    let is_of_catalogue = file.linkage.is_some();
    Some(source.refuse(&place, in_words(&body, is_of_catalogue)))
}

/// A description of the mistake. The user cannot reorder the statements of the catalogue.
fn in_words(body: &FlatBody<'_>, is_of_catalogue: bool) -> String {
    let FlatBody {
        name,
        in_line: [first, second, third],
        is_hinge,
        instead,
    } = body;
    let remedy = match instead {
        _ if is_of_catalogue => String::new(),
        Some(instead) => format!("list `{instead}` before `{third}`, or "),
        None => format!("list a point off the line before `{third}`, or "),
    };
    if *is_hinge {
        format!(
            "point `{third}` of hinge `{name}` lies on the axis `{first}`, `{second}`, and the first point after the arrow must be \
             off the axis, because the axis and this point carry the other points; {remedy}move it off the axis"
        )
    } else {
        format!(
            "the first three points of body `{name}` carry the others, and `{first}`, `{second}` and `{third}` lie in line; \
             {remedy}move one of them off the line"
        )
    }
}

/// The name of a body in its statement.
fn statement_of(text: &str, body: &FlatBody<'_>) -> Option<Range<usize>> {
    let word = if body.is_hinge { "hinge" } else { "body" };
    let mut places = text.match_indices(body.name);
    let (start, _) = places.find(|(start, name)| {
        let (before, behind) = (&text[..*start], &text[start + name.len()..]);
        let is_behind_word =
            before.trim_end().ends_with(word) && before.ends_with(char::is_whitespace);
        is_behind_word && behind.trim_start().starts_with(':')
    })?;
    Some(start..start + body.name.len())
}

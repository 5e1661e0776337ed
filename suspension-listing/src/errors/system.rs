//! Of the listing as a whole: what is missing, unused or too much.

use proc_macro2::Span;
use syn::{Error, Ident};

use super::at;
use crate::name::Name;
use crate::system::Body;

pub fn no_such_link(from: &Ident, to: &Ident) -> Error {
    at(
        from,
        format!(
            "an angle needs the length of a link, and no link joins `{from}` and `{to}`; declare \
             `link name: {from} -> {to};`"
        ),
    )
}

/// The distance of two points of a body is none of its frame's.
pub fn angle_beside_frame(ends: [&Ident; 2], body: &Body) -> Error {
    let [from, to] = ends;
    let Body { name, frame, .. } = body;
    let [a, b, c] = frame.each_ref().map(|site| &site.name);
    // A frame takes chassis points first, wherever they are listed.
    let anchors: Vec<&Name> = frame
        .iter()
        .filter(|site| !site.is_free())
        .map(|site| &site.name)
        .collect();
    let is_other = |end: &&&Ident| !anchors.contains(&&Name::from(**end));
    let others = ends.iter().filter(is_other).count();
    let remedy = if anchors.len() + others > 3 {
        String::new()
    } else {
        format!(", or list `{from}` and `{to}` among the first three points of the body")
    };
    at(
        from,
        format!(
            "an angle needs a length that an equation keeps, and body `{name}` keeps those between \
             `{a}`, `{b}` and `{c}`; drive the angle between two of these{remedy}"
        ),
    )
}

pub fn drive_moves_nothing(point: &Ident) -> Error {
    at(
        point,
        format!(
            "the drive moves chassis point `{point}`, and nothing with it; join `{point}` by a link \
             or a body, or remove the drive"
        ),
    )
}

pub fn unused_chassis_point(point: &Ident) -> Error {
    at(
        point,
        format!(
            "nothing depends on chassis point `{point}`; join it by a link or a body, or remove it"
        ),
    )
}

pub fn nothing_declared(span: Span, keyword: &str) -> Error {
    Error::new(
        span,
        format!("there is no `{keyword}` statement; a linkage needs at least one"),
    )
}

pub fn wrong_count(
    span: Span,
    unknowns: usize,
    [links, bodies, drives]: [usize; 3],
    drives_chassis: bool,
) -> Error {
    let equations = links + bodies + drives;
    let remedy = if equations < unknowns {
        format!(
            "{} more needed: add a link, a drive, or list a point in its body",
            unknowns - equations
        )
    } else {
        format!(
            "{} too many: remove a link or a drive",
            equations - unknowns
        )
    };
    let note = if drives_chassis {
        " (a drive of a chassis point adds no equation)"
    } else {
        ""
    };
    Error::new(
        span,
        format!(
            "{equations} equations for {unknowns} unknowns: {links} of links + {bodies} of bodies + \
             {drives} of drives of free points, against 3 x {} free points; {remedy}{note}",
            unknowns / 3
        ),
    )
}

pub fn redundant_equation(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is one equation too many for the points it joins, while others have too few; move it there"
        ),
    )
}

pub fn undetermined(point: &Ident, axis: &str) -> Error {
    at(
        point,
        format!(
            "no equation is left to determine `{point}.{axis}`; join `{point}` by a link or a body"
        ),
    )
}

pub fn closed_twice(body: &Ident, a: &Name, b: &Name) -> Error {
    at(
        body,
        format!(
            "another body keeps the distance of `{a}` and `{b}` already, and `{body}` can share \
             one such pair only; join `{b}` to `{body}` by links instead"
        ),
    )
}

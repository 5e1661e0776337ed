//! Every message of the macro: the fact, and what to write instead.

use std::fmt::Display;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::{Attribute, Error, Ident, Lit};

use crate::system::Body;

/// Errors gathered so that all of them are reported at once.
#[derive(Default)]
pub(crate) struct Errors(Option<Error>);

impl Errors {
    pub(crate) fn push(&mut self, error: Error) {
        match &mut self.0 {
            Some(first) => first.combine(error),
            None => self.0 = Some(error),
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    pub(crate) fn into_result(self) -> Result<(), Error> {
        self.0.map_or(Ok(()), Err)
    }
}

fn at(ident: &Ident, message: impl Display) -> Error {
    Error::new(ident.span(), message)
}

pub(crate) fn not_a_doc_comment(attribute: &Attribute) -> Error {
    Error::new(
        attribute.span(),
        "only doc comments are allowed on statements; remove the attribute",
    )
}

pub(crate) fn unknown_statement(keyword: &Ident) -> Error {
    at(
        keyword,
        format!(
            "unknown statement `{keyword}`; write one of `fixed`, `free`, `link`, `body`, `drive`, \
             `point`, `wheel`, `kingpin`"
        ),
    )
}

pub(crate) fn no_points(keyword: &Ident) -> Error {
    at(
        keyword,
        format!("`{keyword}` lists no points; name one, or remove the statement"),
    )
}

pub(crate) fn unknown_quantity(function: &Ident) -> Error {
    at(
        function,
        format!(
            "a drive cannot prescribe `{function}(..)`; write `p.z`, `p.z - q.z` or `angle(p -> q, z)`"
        ),
    )
}

pub(crate) fn duplicate_name(name: &Ident, first: &str) -> Error {
    at(
        name,
        format!("the name `{name}` is already taken by a {first}; choose another"),
    )
}

pub(crate) fn reserved_name(name: &Ident) -> Error {
    at(
        name,
        format!("the name `{name}` is used by the generated code; choose another"),
    )
}

pub(crate) fn unknown_point(name: &Ident) -> Error {
    at(
        name,
        format!("there is no point `{name}`; declare it under `fixed:` or `free:`"),
    )
}

pub(crate) fn marker_in_constraint(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is a marker and has no unknowns; declare it under `free:` and list it in its body"
        ),
    )
}

pub(crate) fn same_point_twice(name: &Ident) -> Error {
    at(
        name,
        format!("point `{name}` is listed twice; name another point or remove it"),
    )
}

pub(crate) fn all_fixed(name: &Ident, kind: &str) -> Error {
    at(
        name,
        format!("{kind} `{name}` joins chassis points only; give it a free point or remove it"),
    )
}

pub(crate) fn too_few_points(name: &Ident) -> Error {
    at(
        name,
        format!("body `{name}` needs two points or more; list them, or remove the body"),
    )
}

pub(crate) fn immovable_body(name: &Ident) -> Error {
    at(
        name,
        format!(
            "body `{name}` has three chassis points and cannot move; its other points are chassis \
             points too: declare them under `fixed:`"
        ),
    )
}

pub(crate) fn length_stated_twice(name: &Ident, other: &str) -> Error {
    at(
        name,
        format!(
            "`{name}` joins two points whose distance `{other}` keeps already; remove one of them"
        ),
    )
}

pub(crate) fn shared_triangle(name: &Ident, other: &Ident) -> Error {
    at(
        name,
        format!(
            "body `{name}` shares three points with body `{other}`: they are one body; list all points in one"
        ),
    )
}

pub(crate) fn unknown_axis(axis: &Ident) -> Error {
    at(
        axis,
        format!("there is no axis `{axis}`; write `x`, `y` or `z`"),
    )
}

pub(crate) fn different_axes(axis: &Ident, expected: &Ident) -> Error {
    at(
        axis,
        format!("both coordinates must be along one axis; write `.{expected}`"),
    )
}

pub(crate) fn coordinate_driven_twice(name: &Ident, other: &Ident) -> Error {
    at(
        name,
        format!("drive `{other}` prescribes this coordinate already; remove one of them"),
    )
}

pub(crate) fn no_such_link(from: &Ident, to: &Ident) -> Error {
    at(
        from,
        format!(
            "an angle needs the length of a link, and no link joins `{from}` and `{to}`; declare \
             `link name: {from} -> {to};`"
        ),
    )
}

/// The distance of two points of a body is none of its frame's.
pub(crate) fn angle_beside_frame(ends: [&Ident; 2], body: &Body) -> Error {
    let [from, to] = ends;
    let Body { name, frame, .. } = body;
    let [a, b, c] = frame.each_ref().map(|site| &site.name);
    // A frame takes chassis points first, wherever they are listed.
    let anchors: Vec<&Ident> = frame
        .iter()
        .filter(|site| !site.is_free())
        .map(|site| &site.name)
        .collect();
    let others = ends.iter().filter(|end| !anchors.contains(end)).count();
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

pub(crate) fn drive_moves_nothing(point: &Ident) -> Error {
    at(
        point,
        format!(
            "the drive moves chassis point `{point}`, and nothing with it; join `{point}` by a link \
             or a body, or remove the drive"
        ),
    )
}

pub(crate) fn unused_chassis_point(point: &Ident) -> Error {
    at(
        point,
        format!(
            "nothing depends on chassis point `{point}`; join it by a link or a body, or remove it"
        ),
    )
}

pub(crate) fn bad_carriers(marker: &Ident, carriers: &[Ident]) -> Error {
    let message = match carriers {
        [one] => format!("there is no body `{one}` with three points or more to carry `{marker}`"),
        _ => format!(
            "`{marker}` is carried by one body or by three points; {} names are given",
            carriers.len()
        ),
    };
    at(carriers.first().unwrap_or(marker), message)
}

pub(crate) fn role_stated_twice(keyword: &Ident) -> Error {
    at(keyword, format!("`{keyword}` is stated twice; remove one"))
}

pub(crate) fn wheel_without_carrier(from: &Ident, to: &Ident) -> Error {
    at(
        from,
        format!(
            "no body carries both `{from}` and `{to}`; list them in one body, or declare one as \
             `point` carried by three points"
        ),
    )
}

pub(crate) fn nothing_declared(module: &Ident, keyword: &str) -> Error {
    at(
        module,
        format!("`{module}` has no `{keyword}` statement; a linkage needs at least one"),
    )
}

pub(crate) fn wrong_count(
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

pub(crate) fn redundant_equation(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is one equation too many for the points it joins, while others have too few; move it there"
        ),
    )
}

pub(crate) fn undetermined(point: &Ident, axis: &str) -> Error {
    at(
        point,
        format!(
            "no equation is left to determine `{point}.{axis}`; join `{point}` by a link or a body"
        ),
    )
}

pub(crate) fn not_a_position(keyword: &Ident) -> Error {
    at(
        keyword,
        format!("unexpected `{keyword}`; write `,`, or a design position: `at [x, y, z]`"),
    )
}

pub(crate) fn not_three_coordinates(span: Span, count: usize) -> Error {
    Error::new(
        span,
        format!("a design position has three coordinates, {count} are given; write `[x, y, z]`"),
    )
}

pub(crate) fn not_a_number(literal: &Lit) -> Error {
    Error::new(
        literal.span(),
        "a coordinate is a number, for example `-1.25`",
    )
}

pub(crate) fn behind_the_listing(span: Span) -> Error {
    Error::new(span, "nothing may follow the listing; remove it")
}

pub(crate) fn body_bent(drive: &Ident, point: &Ident, body: &Ident) -> Error {
    at(
        drive,
        format!(
            "`{point}` is one of two chassis points of body `{body}`: to move it alone would bend \
             the body; drive a free point of the body instead"
        ),
    )
}

pub(crate) fn closed_twice(body: &Ident, a: &Ident, b: &Ident) -> Error {
    at(
        body,
        format!(
            "another body keeps the distance of `{a}` and `{b}` already, and `{body}` can share \
             one such pair only; join `{b}` to `{body}` by links instead"
        ),
    )
}

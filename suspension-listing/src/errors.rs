//! Messages: the fact, and what to write instead. Messages about only one kind of statement are in its file.

mod of_parser;

use std::fmt::Display;

use proc_macro2::Span;
use syn::{Error, Ident};

use crate::did_you_mean::did_you_mean;
use crate::kind::Kind;
use crate::system::Body;

pub(crate) use of_parser::{
    at_statement_end, is_from_parser, keyword_as_name, lacks_semicolon, no_name, not_a_doc_comment,
    tokens,
};

/// Collects errors so that all of them are reported at once.
#[derive(Default)]
pub struct Errors(Option<Error>);

impl Errors {
    pub fn push(&mut self, error: Error) {
        match &mut self.0 {
            Some(first) => first.combine(error),
            None => self.0 = Some(error),
        }
    }

    pub(crate) fn append(&mut self, others: Self) {
        if let Some(error) = others.0 {
            self.push(error);
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    pub(crate) fn all(self) -> impl Iterator<Item = Error> {
        self.0.into_iter().flatten()
    }

    pub(crate) fn into_result(self) -> Result<(), Error> {
        self.0.map_or(Ok(()), Err)
    }
}

pub(crate) fn at(ident: &Ident, message: impl Display) -> Error {
    Error::new(ident.span(), message)
}

pub fn text_after_listing(span: Span) -> Error {
    Error::new(span, "nothing may follow the listing; remove it")
}

pub(crate) fn nothing_declared(span: Span, word: &str) -> Error {
    Error::new(
        span,
        format!("there is no `{word}` statement; a linkage needs at least one"),
    )
}

pub(crate) fn duplicate_name(name: &Ident, (first, kind): (&Ident, &Kind)) -> Error {
    let message = if name == first {
        format!(
            "the name `{name}` is already taken by {}; choose another",
            kind.with_article()
        )
    } else {
        format!(
            "`{name}` and the {kind} `{first}` are the same in capital letters, in which constants are \
             written; choose another name"
        )
    };
    at(name, message)
}

pub(crate) fn reserved_name(name: &Ident) -> Error {
    at(
        name,
        format!("the name `{name}` is used by the generated code; choose another"),
    )
}

pub(crate) fn unknown_point<'a>(
    name: &Ident,
    may_be_marker: bool,
    known: impl Iterator<Item = &'a Ident>,
) -> Error {
    let hint = did_you_mean_name(name, known);
    let as_marker = if may_be_marker {
        format!(", or as a marker by `point {name}: BODY;`")
    } else {
        String::new()
    };
    at(
        name,
        format!(
            "there is no point `{name}`; declare it under `fixed:` or `free:`{as_marker}{hint}"
        ),
    )
}

/// `; did you mean ...?`, or nothing if no name of the listing is near.
pub(crate) fn did_you_mean_name<'a>(
    wanted: &Ident,
    known: impl Iterator<Item = &'a Ident>,
) -> String {
    let known: Vec<String> = known.map(ToString::to_string).collect();
    did_you_mean(&wanted.to_string(), known.iter().map(String::as_str))
}

pub(crate) fn marker_in_constraint(name: &Ident) -> Error {
    at(
        name,
        format!(
            "`{name}` is a marker and has no unknowns; declare it under `free:` and list it in its body"
        ),
    )
}

/// The error that a marker is joined as if it had unknowns, although its body is collinear, so that the marker cannot
/// be added to the body.
pub(crate) fn marker_in_line(name: &Ident, body: &Ident, ends: [&Ident; 2]) -> Error {
    let ([from, to], sliding) = (ends, sliding(name, body, ends));
    at(
        name,
        format!(
            "`{name}` is a marker and has no unknowns, and lies in line with the points of its body `{body}`, about which a body spins: \
             declare `{name}` under `free:`, and in place of the body write `link {body}: {from} -> {to};` and for each other point, as \
             for `{name}`, {sliding}"
        ),
    )
}

/// How to write a point that stays in its place on the line of a link.
pub(crate) fn sliding(point: &Ident, link: &Ident, [from, to]: [&Ident; 2]) -> String {
    format!(
        "`slide {point}_on_{link}: {point} on {from} -> {to};` and `link {point}_from_{from}: {from} -> {point};`"
    )
}

/// The error that an angle is held between lines of constant lengths that meet in a point.
pub(crate) fn lines_meet(name: &Ident, shared: &Ident, [from, to]: [&Ident; 2]) -> Error {
    at(
        shared,
        format!(
            "the lines of `{name}` meet in `{shared}`, where a link between their other ends keeps the angle; in place of it write \
             `link {name}: {from} -> {to};`"
        ),
    )
}

pub(crate) fn same_point_twice(name: &Ident) -> Error {
    at(
        name,
        format!("point `{name}` is listed twice; name another point or remove it"),
    )
}

/// The error that nothing keeps the distance between two points, although a line of theirs must keep its length. `moved` is
/// the one that a drive moves, if both are on the chassis.
pub(crate) fn distance_not_constant(
    [from, to]: [&Ident; 2],
    line: &str,
    moved: Option<&Ident>,
) -> Error {
    let cause = match moved {
        Some(moved) => format!(
            "a drive moves chassis point `{moved}`; name one that no drive moves, or declare both under `free:` in one body"
        ),
        None => format!(
            "nothing holds `{from}` and `{to}` at one; list both in one body, join them by a link, or put both on the chassis"
        ),
    };
    at(
        from,
        format!("{line} needs two points at a constant distance, and {cause}"),
    )
}

/// The error that all points of a statement belong to one body, so that the statement has nothing to keep or to move.
/// `what` names the points and comes before the body; the remedy comes after it, and begins with its comma or
/// semicolon.
pub(crate) fn points_of_one_body(token: &Ident, what: &str, body: &Body, remedy: &str) -> Error {
    let body = &body.name;
    let message = format!("{what} of body `{body}`{remedy} of another body");
    at(token, message)
}

pub(crate) fn line_is_axis(from: &Ident, to: &Ident) -> Error {
    let message = format!(
        "the line `{from} -> {to}` is the axis of the angle itself; name a line off the axis"
    );
    at(from, message)
}

pub(crate) fn prescribed_twice(name: &Ident, other: &Ident, kind: Kind) -> Error {
    at(
        name,
        format!("{kind} `{other}` prescribes the same already; remove one of them"),
    )
}

pub(crate) fn prescribed_by_image(name: &Ident, image: &Ident, kind: Kind) -> Error {
    at(
        name,
        format!(
            "`mirror` makes {kind} `{image}`, which prescribes what `{name}` does; remove `{name}`"
        ),
    )
}

pub(crate) fn joins_only_chassis(name: &Ident, kind: Kind) -> Error {
    at(
        name,
        format!("{kind} `{name}` joins chassis points only; give it a free point or remove it"),
    )
}

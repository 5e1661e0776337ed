//! A check of whether the equations can determine the unknowns: counts and structural rank.

use std::cell::LazyCell;

use proc_macro2::Span;
use syn::{Error, Ident};

use crate::check::freedom::Freedom;
use crate::check::held::turning;
use crate::check::neither_side::{WithoutImage, hint_shared_point};
use crate::errors::{self, Errors};
use crate::kind::Kind;
use crate::listing::Listing;
use crate::matching::augment;
use crate::name::Name;
use crate::sides::Sides;
use crate::system::{AXES, Equation, System};

/// Checks that there are as many equations as unknowns, and that each equation can be assigned an unknown of its own
/// (structural rank).
pub(crate) fn determined(listing: &Listing, system: &System, errors: &mut Errors) {
    let freedom = LazyCell::new(|| Freedom::at_design(system).unwrap_or_default());
    if system.rows().len() == system.size() {
        structural_rank(listing, system, &freedom, errors);
    } else {
        errors.push(wrong_count(listing, system, &freedom));
    }
}

/// A hint on what can still move; empty if nothing is known.
fn loose_in_words(system: &System, freedom: &Freedom<'_>) -> String {
    let turning = turning(system);
    if turning.is_empty() {
        freedom.loose()
    } else {
        turning
    }
}

/// The place where an equation is stated.
pub(super) fn place_of(listing: &Listing, equation: &Equation) -> Span {
    let origin = &equation.origin;
    listing.place_of(&origin.statement, origin.operand.as_ref())
}

/// The place where the statement is named to which an unknown other than a coordinate belongs.
pub(super) fn place_of_scalar(listing: &Listing, system: &System, scalar: &Name) -> Span {
    let has = |equation: &&Equation| {
        let scalars = equation.form.equations().scalars();
        scalars.iter().any(|(name, _)| *name == scalar)
    };
    let equation = system.equations.iter().find(has);
    equation.map_or(listing.span, |equation| place_of(listing, equation))
}

fn wrong_count(listing: &Listing, system: &System, freedom: &Freedom<'_>) -> Error {
    let (equations, unknowns) = (system.rows().len(), system.size());
    let remedy = if equations < unknowns {
        let missing = unknowns - equations;
        let hint = loose_in_words(system, freedom);
        format!("{missing} more needed: add a link, a drive, or list a point in its body{hint}")
    } else {
        let excess = equations - unknowns;
        let mirrored = listing.sides.first();
        let remedy = mirrored
            .and_then(|sides| hint_shared_point(listing, sides))
            .unwrap_or_else(|| {
                let of_one_side = mirrored.map(describe_images).unwrap_or_default();
                format!("{}{of_one_side}", remedy_for_too_many(system))
            });
        let (redundant, loose) = (freedom.redundant(), freedom.loose());
        format!("{excess} too many: {remedy}{redundant}{loose}")
    };
    let drives_chassis = system.drives.iter().any(|drive| drive.moves.is_some());
    let note = if drives_chassis {
        " (a drive of a chassis point adds no equation)"
    } else {
        ""
    };
    let (by_kind, points) = (count_by_kind(listing, system), system.free.len());
    let scalars = match system.scalars.len() {
        0 => String::new(),
        1 => " + 1 other unknown".to_owned(),
        count => format!(" + {count} other unknowns"),
    };
    let error = Error::new(
        listing.free_span,
        format!(
            "{equations} equations for {unknowns} unknowns: {by_kind}, against 3 x {points} free \
             points{scalars}; {remedy}{note}"
        ),
    );
    let mut causes = WithoutImage::all(listing).filter(|_| equations < unknowns);
    match causes.find(WithoutImage::has_equations) {
        Some(cause) => cause.prepend_to(&error),
        None => error,
    }
}

/// The remedy for too many equations.
fn remedy_for_too_many(system: &System) -> &'static str {
    let has = |kind: Kind| {
        let mut equations = system.equations.iter();
        equations.any(|equation| equation.origin.kind == kind)
    };
    if !has(Kind::LINK) && has(Kind::HINGE) {
        "remove a drive, or write a `link`, which is one equation, in place of a `hinge`, which is two for its first point"
    } else {
        "remove a link or a drive"
    }
}

/// How a statement with an image is named, and one without, if there is a mirror.
fn describe_images(sides: &Sides) -> String {
    let [stated, _] = &sides.0;
    let named = sides.how_named();
    format!(
        "; `mirror` makes an image of every part with `{stated}` in its name: {named}, such as a Panhard rod"
    )
}

/// The number of equations of the statements of each kind.
fn count_by_kind(listing: &Listing, system: &System) -> String {
    let mut kinds: Vec<Kind> = Vec::new();
    for (_, kind) in listing.declared() {
        if !kinds.contains(&kind) {
            kinds.push(kind);
        }
    }
    let counts = kinds.into_iter().map(|kind| {
        let equations = system.equations.iter();
        let of_kind = equations.filter(|equation| equation.origin.kind == kind);
        let count: usize = of_kind.map(|equation| equation.rows().len()).sum();
        (kind, count)
    });
    let stated = counts.filter(|(_, count)| *count > 0);
    let words = stated.map(|(kind, count)| format!("{count} of {}", kind.plural()));
    words.collect::<Vec<_>>().join(" + ")
}

fn structural_rank<'s>(
    listing: &Listing,
    system: &'s System,
    freedom: &LazyCell<Freedom<'s>, impl FnOnce() -> Freedom<'s>>,
    errors: &mut Errors,
) {
    let pattern = system.pattern();
    let mut row_of = vec![None; system.size()];
    let equations = system.equations.iter();
    let rows = equations.flat_map(|equation| equation.rows().into_iter().map(move |_| equation));
    let names = system.rows();
    for (row, (equation, name)) in rows.zip(&names).enumerate() {
        if !augment(row, &pattern, &mut row_of, &mut vec![false; system.size()]) {
            let name = name.at(place_of(listing, equation));
            errors.push(redundant_equation(&name, &freedom.redundant()));
        }
    }
    for column in (0..system.size()).filter(|column| row_of[*column].is_none()) {
        let hint = loose_in_words(system, freedom);
        errors.push(undetermined(listing, system, column, &hint));
    }
}

fn redundant_equation(name: &Ident, hint: &str) -> Error {
    errors::at(
        name,
        format!(
            "`{name}` is one equation too many for the points it joins, while others have too few; move it there{hint}"
        ),
    )
}

fn undetermined(listing: &Listing, system: &System, column: usize, hint: &str) -> Error {
    let coordinates = 3 * system.free.len();
    let (name, unknown, place) = if column < coordinates {
        let point = &system.free[column / 3].named.name;
        let unknown = format!("{point}.{}", AXES[column % 3]);
        (point, unknown, listing.place_of(point, None))
    } else {
        let scalar = &system.scalars[column - coordinates];
        let place = place_of_scalar(listing, system, scalar);
        (scalar, scalar.to_string(), place)
    };
    Error::new(
        place,
        format!(
            "no equation is left to determine `{unknown}`; join `{name}` by a link or a body{hint}"
        ),
    )
}

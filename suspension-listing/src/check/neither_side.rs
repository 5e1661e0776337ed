//! Parts beside a `mirror` that are named for neither side but belong to one.

use proc_macro2::Span;
use syn::{Error, Ident};

use crate::errors;
use crate::kind::Kind;
use crate::listing::{Listing, Rank, Rigid, Statement};
use crate::sides::Sides;

/// A statement that is named for neither side, although its points, or what carries it, all belong to the stated
/// side.
pub(super) struct WithoutImage<'a> {
    name: &'a Ident,
    kind: Kind,
    rank: Rank,
    points: Vec<&'a Ident>,
    sides: &'a Sides,
}

impl<'a> WithoutImage<'a> {
    /// All such statements of a listing.
    pub(super) fn all(listing: &'a Listing) -> impl Iterator<Item = Self> {
        let of_sides = |sides: &'a Sides| {
            let statements = listing.statements.iter();
            statements.filter_map(move |statement| Self::find(statement.as_ref(), sides))
        };
        listing.sides.iter().flat_map(of_sides)
    }

    fn find(statement: &'a dyn Statement, sides: &'a Sides) -> Option<Self> {
        let (named, kind) = statement.named()?;
        let points = statement.operands();
        let is_stated = |point: &&Ident| sides.is_stated(&point.to_string());
        let is_of_side = !points.is_empty() && points.iter().all(is_stated);
        (is_of_side && !sides.is_named(&named.name.to_string())).then_some(Self {
            name: &named.name,
            kind,
            rank: statement.rank(),
            points,
            sides,
        })
    }

    /// Whether it has equations.
    pub(super) fn has_equations(&self) -> bool {
        [Rank::Constraint, Rank::Drive].contains(&self.rank)
    }

    /// The place of its name.
    pub(super) fn place(&self) -> Span {
        self.name.span()
    }

    /// Whether a message is about it, or about the image of something that it names.
    pub(super) fn is_in(&self, message: &str) -> bool {
        let images = self.points.iter();
        let images = images.map(|point| self.sides.exchanged(&point.to_string()));
        let mut names = images.chain([self.name.to_string()]);
        names.any(|name| message.contains(&format!("`{name}`")))
    }

    /// Puts the cause before an error that follows from it.
    pub(super) fn prepend_to(&self, error: &Error) -> Error {
        let ([stated, _], name, kind) = (&self.sides.0, self.name, self.kind);
        let beside = self.points.first();
        let beside = beside.map_or_else(String::new, |point| format!(", as `{point}` is"));
        errors::at(
            name,
            format!(
                "{kind} `{name}` is named for neither side, and `mirror` makes no image of it: name it `{stated}_{name}`{beside}; as it is, \
                 {error}"
            ),
        )
    }
}

/// The mistake of an image that states the same as its original, because their points are named for neither side.
pub(super) fn same_again(listing: &Listing, image: &dyn Statement) -> Option<Error> {
    let (named, kind) = image.named()?;
    let name = named.name.to_string();
    if !listing.images.contains(&name) || image.rank() > Rank::Drive {
        return None;
    }
    let mut sides = listing.sides.iter();
    let sides = sides.find(|sides| sides.is_named(&name))?;
    let original = sides.exchanged(&name);
    let mut statements = listing.statements.iter();
    let (of, stated) = statements.find_map(|stated| {
        let (of, _) = stated.named()?;
        (of.name == original).then_some((&of.name, stated))
    })?;
    let (points, others) = (image.operands(), stated.operands());
    let is_same = |point: &&&Ident| others.contains(*point) && !sides.is_named(&point.to_string());
    let same: Vec<&Ident> = points.iter().filter(is_same).copied().collect();
    let is_body = matches!(image.rigid(), Some(Rigid::Body(_)));
    let is_again = same.len() == points.len() || (is_body && same.len() >= 3);
    is_again.then(|| shared_with_image(kind, [of, &named.name], &same, sides))
}

fn shared_with_image(
    kind: Kind,
    [name, image]: [&Ident; 2],
    points: &[&Ident],
    sides: &Sides,
) -> Error {
    let [stated, _] = &sides.0;
    let listed: Vec<String> = points.iter().map(|point| format!("`{point}`")).collect();
    let listed = listed.join(", ");
    let first = points.first().map_or_else(String::new, ToString::to_string);
    let (of, remedy) = match points {
        [_] => (
            format!("the same point, {listed}, which is"),
            format!("name it `{stated}_{first}`"),
        ),
        _ => (
            format!("the same points, {listed}, which are"),
            format!("name them as `{stated}_{first}`"),
        ),
    };
    errors::at(
        name,
        format!(
            "{kind} `{name}` and its image `{image}` are of {of} named for neither side: {remedy} for each side to have its own, or name \
             the {kind} without `{stated}` for both sides to share one"
        ),
    )
}

/// A hint for a point that a body shares with its image.
pub(super) fn hint_shared_point(listing: &Listing, sides: &Sides) -> Option<String> {
    let [stated, _] = &sides.0;
    let bodies: Vec<(String, &[Ident])> = listing
        .bodies()
        .map(|(name, points)| (name.to_string(), points))
        .collect();
    let mut pairs = bodies
        .iter()
        .filter(|(name, _)| sides.is_stated(name))
        .filter_map(|(name, points)| {
            let image = sides.exchanged(name);
            let (_, of_image) = bodies.iter().find(|(other, _)| *other == image)?;
            let shared = points.iter().find(|point| of_image.contains(point))?;
            Some((name, image, shared))
        });
    let (body, image, point) = pairs.next()?;
    Some(format!(
        "`{point}` joins body `{body}` to its image `{image}`: name it `{stated}_{point}`, and each side has its own, or remove a link or \
         a drive"
    ))
}

//! The statements of a listing, one file each: how it is written, read, checked and lowered to forms.
//!
//! The register below is the only place that tells the statements apart; everything else asks a
//! statement what [`Statement`] has it answer.

mod body;
mod drive;
mod hinge;
mod link;
mod marker;
mod measure;
mod points;
mod quantity;
mod role;
mod slide;

use std::fmt;

use syn::Ident;
use syn::parse::ParseStream;

use crate::check::Check;
use crate::errors::Errors;
use crate::listing::{Listing, Named};
use crate::lower::Lowering;
use crate::parse;
use crate::system::System;

/// The statements by their first words.
pub(crate) const STATEMENTS: &[Word] = &[
    points::FIXED,
    points::FREE,
    link::LINK,
    body::BODY,
    hinge::HINGE,
    slide::SLIDE,
    drive::DRIVE,
    measure::MEASURE,
    marker::POINT,
    role::WHEEL,
    role::KINGPIN,
];

/// How a statement begins, and what is made of the rest.
pub(crate) struct Word {
    pub(crate) word: &'static str,
    /// An example.
    pub(crate) syntax: &'static str,
    /// Reads what follows the first word, to the semicolon, into a listing.
    pub(crate) read: fn(Head, ParseStream<'_>, &mut Listing) -> syn::Result<()>,
}

/// What a statement begins with.
pub(crate) struct Head {
    pub(crate) docs: Vec<String>,
    pub(crate) word: Ident,
}

impl Head {
    /// `name:` behind the first word.
    fn named(self, input: ParseStream<'_>) -> syn::Result<Named> {
        let name = parse::name(input)?;
        input.parse::<syn::Token![:]>()?;
        Ok(Named {
            docs: self.docs,
            name,
        })
    }
}

/// What a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind(pub(crate) &'static str);

impl Kind {
    pub const CHASSIS_POINT: Self = Self("chassis point");
    pub const FREE_POINT: Self = Self("free point");
    pub const MARKER: Self = Self("marker");

    pub(crate) fn plural(self) -> String {
        match self.0.strip_suffix('y') {
            Some(stem) => format!("{stem}ies"),
            None => format!("{self}s"),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

/// What each statement but those that declare points answers for itself.
pub(crate) trait Statement {
    /// Its name, and what that stands for.
    fn named(&self) -> Option<(&Named, Kind)>;

    /// The points that it names.
    fn operands(&self) -> Vec<&Ident>;

    /// Checks its operands, against the listing and the statements before.
    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]);

    /// When it is lowered.
    fn rank(&self) -> Rank;

    /// Adds to the system what it stands for.
    fn lower(&self, lowering: &mut Lowering<'_>);

    /// Checks what only the system shows.
    fn check_lowered(&self, _listing: &Listing, _system: &System, _errors: &mut Errors) {}

    /// The points that it keeps as they are to each other.
    fn rigid(&self) -> Option<Rigid<'_>> {
        None
    }

    /// A body, or three points, that it lets carry its name.
    fn carriers(&self) -> Option<&[Ident]> {
        None
    }

    /// The point that it moves, if that is on the chassis.
    fn moves(&self) -> Option<&Ident> {
        None
    }

    /// Whether it moves its point along a direction that is no axis.
    fn is_skew(&self) -> bool {
        false
    }

    /// What no other statement may state too.
    fn claim(&self) -> Option<String> {
        None
    }
}

/// Points that stay as they are to each other.
pub(crate) enum Rigid<'a> {
    Length(&'a [Ident; 2]),
    Body(&'a [Ident]),
}

impl<'a> Rigid<'a> {
    pub(crate) fn points(&self) -> &'a [Ident] {
        match self {
            Self::Length(ends) => *ends,
            Self::Body(points) => points,
        }
    }
}

/// Statements are lowered by rank, those of one rank as stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// What joins points.
    Constraint,
    /// What is prescribed of them.
    Drive,
    /// What is read off them.
    Reading,
}

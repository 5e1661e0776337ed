//! The listing that the user wrote: points and the statements about them, with their places in the source; and the
//! interface of a statement.

mod lookup;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;
use syn::Ident;

use crate::errors::Errors;
use crate::include::{Include, Included};
use crate::kind::Kind;
use crate::name::{self, Name};
use crate::sides::Sides;
use crate::system::System;
use crate::vector::Vector;

pub struct Listing {
    pub(crate) docs: Vec<String>,
    pub(crate) fixed: Vec<Point>,
    pub(crate) free: Vec<Point>,
    /// All other statements, in the order stated.
    pub(crate) statements: Vec<Box<dyn Statement>>,
    /// The words for the sides of the vehicle in names.
    pub(crate) mirror: Option<[Ident; 2]>,
    /// The sides of each mirror that made images, including those of included listings.
    pub(crate) sides: Vec<Sides>,
    /// The names of all images.
    pub(crate) images: BTreeSet<String>,
    /// The statement that was read last, if it includes another listing.
    pub(crate) include: Option<Include>,
    /// The included texts, including those that they include.
    pub(crate) included: Vec<Included>,
    /// The token for messages about the listing as a whole.
    pub(crate) span: Span,
    /// The place where the free points are declared: the token for messages about counts.
    pub(crate) free_span: Span,
    /// Whether a statement could not be read, so that missing names may have no other cause.
    pub(crate) incomplete: bool,
}

/// A name with its docs.
pub(crate) struct Named {
    pub(crate) docs: Vec<String>,
    pub(crate) name: Ident,
}

/// A chassis point or a free point.
pub(crate) struct Point {
    pub(crate) named: Named,
    /// The design position, if it is stated.
    pub(crate) at: Option<Vector>,
}

impl Named {
    /// The same name without its place in the source.
    pub(crate) fn plain(&self) -> name::Named {
        name::Named {
            name: Name::from(&self.name),
            docs: self.docs.clone(),
        }
    }
}

impl Listing {
    pub(crate) fn empty(span: Span) -> Self {
        Self {
            docs: Vec::new(),
            fixed: Vec::new(),
            free: Vec::new(),
            statements: Vec::new(),
            mirror: None,
            sides: Vec::new(),
            images: BTreeSet::new(),
            include: None,
            included: Vec::new(),
            span,
            free_span: span,
            incomplete: false,
        }
    }
}

/// The functions of every statement except those that declare points. The defaults are right for most statements that
/// join points.
pub(crate) trait Statement {
    /// Its name, and the kind of part that this stands for.
    fn named(&self) -> Option<(&Named, Kind)>;

    /// The points that it names.
    fn operands(&self) -> Vec<&Ident>;

    /// Checks its operands against the listing and the earlier statements.
    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        check.joins(self);
    }

    /// The rank by which it is lowered.
    fn rank(&self) -> Rank {
        Rank::Constraint
    }

    /// Adds its part to the system.
    fn lower(&self, lowering: &mut Lowering<'_>);

    /// Checks what can only be seen in the system.
    fn check_lowered(&self, _listing: &Listing, _system: &System, _errors: &mut Errors) {}

    /// The points whose distances from each other it keeps.
    fn rigid(&self) -> Option<Rigid<'_>> {
        None
    }

    /// The body, or the three points, that carry the point it names.
    fn carriers(&self) -> Option<&[Ident]> {
        None
    }

    /// The stated design position of the point that is carried.
    fn at(&self) -> Option<Vector> {
        None
    }

    /// The point that it moves, if that is on the chassis.
    fn moves(&self) -> Option<&Ident> {
        None
    }

    /// Whether it moves its point along a direction that is not an axis.
    fn is_skew(&self) -> bool {
        false
    }

    /// A text for what no other statement may state too.
    fn claim(&self) -> Option<String> {
        None
    }
}

/// Points whose distances from each other stay the same.
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

/// Statements are lowered by rank, and those of one rank in the order stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Rank {
    /// Statements that join points.
    Constraint,
    /// Statements that prescribe something of points.
    Drive,
    /// Statements that read something from points.
    Reading,
    /// Statements about a reading.
    OfReading,
}

/// The data with which statements check their operands.
pub(crate) struct Check<'a> {
    pub(crate) listing: &'a Listing,
    /// The kind of each name.
    pub(crate) taken: BTreeMap<Ident, Kind>,
    pub(crate) errors: &'a mut Errors,
}

/// The data with which statements lower themselves.
pub(crate) struct Lowering<'a> {
    pub(crate) listing: &'a Listing,
    pub(crate) system: System,
    /// Pairs of points whose distance an equation already keeps, or which a body carries.
    pub(crate) rigid: BTreeSet<[Name; 2]>,
    pub(crate) errors: &'a mut Errors,
}

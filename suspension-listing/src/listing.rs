//! The listing that the user wrote: points and the statements about them, with their places in the source; and the
//! interface of a statement.

mod lookup;

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;
use syn::Ident;

use crate::errors::Errors;
use crate::include::Include;
use crate::included::Included;
use crate::kind::Kind;
use crate::name::{self, Name};
use crate::sides::Sides;
use crate::system::System;
use crate::vector::Vector;

pub struct Listing {
    pub(crate) docs: Vec<String>,
    pub(crate) fixed: Vec<Point>,
    pub(crate) free: Vec<Point>,
    /// All others, in the order stated.
    pub(crate) statements: Vec<Box<dyn Statement>>,
    /// The words that the sides of the vehicle have in their names.
    pub(crate) mirror: Option<[Ident; 2]>,
    /// The same, of each mirror that made images, those of included listings among them.
    pub(crate) sides: Vec<Sides>,
    /// The names of all images.
    pub(crate) images: BTreeSet<String>,
    /// The statement that was read last, where it includes another listing.
    pub(crate) include: Option<Include>,
    /// The texts that it includes, those included in them among them.
    pub(crate) included: Vec<Included>,
    /// The token for messages about the listing as a whole.
    pub(crate) span: Span,
    /// Where the free points are declared: the token for messages about counts.
    pub(crate) free_span: Span,
    /// Whether a statement could not be read, so that names may be missing through no other fault.
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
    /// The design position, where it is stated.
    pub(crate) at: Option<Vector>,
}

impl Named {
    /// The same without the place in the source.
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

/// What each statement but those that declare points answers for itself. What it leaves out is as most
/// statements that join points have it.
pub(crate) trait Statement {
    /// Its name, and what that stands for.
    fn named(&self) -> Option<(&Named, Kind)>;

    /// The points that it names.
    fn operands(&self) -> Vec<&Ident>;

    /// Checks its operands, against the listing and the statements before.
    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        check.joins(self);
    }

    /// When it is lowered.
    fn rank(&self) -> Rank {
        Rank::Constraint
    }

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

    /// The design position that it states of what it lets be carried.
    fn at(&self) -> Option<Vector> {
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
    /// What is said of a reading.
    OfReading,
}

/// What statements check their operands with.
pub(crate) struct Check<'a> {
    pub(crate) listing: &'a Listing,
    /// What each name stands for.
    pub(crate) taken: BTreeMap<Ident, Kind>,
    pub(crate) errors: &'a mut Errors,
}

/// What statements lower themselves with.
pub(crate) struct Lowering<'a> {
    pub(crate) listing: &'a Listing,
    pub(crate) system: System,
    /// Pairs of points whose distance an equation keeps already, or a body carries.
    pub(crate) rigid: BTreeSet<[Name; 2]>,
    pub(crate) errors: &'a mut Errors,
}

//! From the checked listing to the system of equations: the tools with which statements lower themselves.

mod body;

use std::collections::BTreeSet;

use syn::Ident;

use crate::cluster;
use crate::errors::Errors;
use crate::form::{Distance, Form};
use crate::kind::Kind;
use crate::listing::{self, Listing, Lowering, Rank, Rigid, Statement};
use crate::name::{Name, Named};
use crate::system::{Body, Equation, Origin, Point, Site, SiteMotion, System};

/// Lowers a listing; if it has mistakes, as far as possible. Reports mistakes that can only be seen on the way.
pub(crate) fn system(listing: &Listing, errors: &mut Errors) -> System {
    let mut lowering = Lowering {
        listing,
        system: System {
            docs: listing.docs.clone(),
            fixed: points(&listing.fixed),
            free: points(&listing.free),
            markers: Vec::new(),
            bodies: Vec::new(),
            clusters: Vec::new(),
            scalars: Vec::new(),
            equations: Vec::new(),
            drives: Vec::new(),
            measures: Vec::new(),
            wheels: Vec::new(),
        },
        rigid: BTreeSet::new(),
        errors,
    };
    let mut statements: Vec<&dyn Statement> =
        listing.statements.iter().map(AsRef::as_ref).collect();
    statements.sort_by_cached_key(|statement| lowering.rank(*statement));
    for statement in statements {
        statement.lower(&mut lowering);
    }
    // With too many links there are too many clusters to search for.
    if lowering.system.rows().len() == lowering.system.size() {
        lowering.system.clusters = lowering.clusters();
    }
    lowering.system
}

fn points(stated: &[listing::Point]) -> Vec<Point> {
    let point = |point: &listing::Point| Point {
        named: point.named.plain(),
        at: point.at,
    };
    stated.iter().map(point).collect()
}

impl Lowering<'_> {
    /// Bodies with two chassis points come first, so that what they share with others is settled by then.
    fn rank(&self, statement: &dyn Statement) -> (Rank, bool) {
        let anchors = |points: &[Ident]| points.iter().filter(|p| !self.site(p).is_free()).count();
        let is_hinged =
            matches!(statement.rigid(), Some(Rigid::Body(points)) if anchors(points) == 2);
        (statement.rank(), !is_hinged)
    }

    /// A point by its name.
    pub(crate) fn site(&self, name: &Ident) -> Site {
        let place = |points: &[listing::Point]| points.iter().position(|p| p.named.name == *name);
        let mut moved = self.listing.statements.iter();
        let moved = moved.any(|statement| statement.moves() == Some(name));
        let (index, motion) = match (place(&self.listing.fixed), moved) {
            (None, _) => (place(&self.listing.free), SiteMotion::Free),
            (fixed, false) => (fixed, SiteMotion::Anchor),
            (fixed, true) => (fixed, SiteMotion::DrivenAnchor),
        };
        Site {
            name: Name::from(name),
            index: index.unwrap_or_default(),
            motion,
        }
    }

    pub(crate) fn body_named(&self, name: &Name) -> Option<&Body> {
        self.system.bodies.iter().find(|body| body.name == *name)
    }

    pub(crate) fn equation(&mut self, named: Named, origin: Origin, form: Form) {
        self.system.equations.push(Equation {
            named,
            origin,
            form,
        });
    }

    /// The equation that has a statement's own name.
    pub(crate) fn equation_of(&mut self, kind: Kind, stated: &listing::Named, form: Form) {
        let named = stated.plain();
        let origin = origin(kind, &named.name, None);
        self.equation(named, origin, form);
    }

    /// The equation that keeps a distance.
    pub(crate) fn distance(&mut self, named: Named, origin: Origin, [a, b]: [Site; 2]) {
        self.rigid.insert(pair(&a, &b));
        let (from, to) = if b.is_free() { (a, b) } else { (b, a) };
        self.equation(named, origin, Form::Distance(Distance { from, to }));
    }

    fn clusters(&self) -> Vec<Body> {
        let points = self.listing.fixed.iter().chain(&self.listing.free);
        let sites: Vec<Site> = points.map(|point| self.site(&point.named.name)).collect();
        cluster::clusters(&sites, &self.system.equations)
    }
}

/// The origin of an equation: a statement, or an operand of it.
pub(crate) fn origin(kind: Kind, statement: &Name, operand: Option<&Site>) -> Origin {
    Origin {
        kind,
        statement: statement.clone(),
        operand: operand.map(|site| site.name.clone()),
    }
}

/// An unordered pair of points.
fn pair(a: &Site, b: &Site) -> [Name; 2] {
    let mut names = [a.name.clone(), b.name.clone()];
    names.sort();
    names
}

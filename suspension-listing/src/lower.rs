//! From the checked listing to the system of equations.

use std::collections::BTreeSet;

use syn::Ident;

use crate::ast::{self, Axis, Constraint, Listing, Quantity};
use crate::cluster;
use crate::errors::{self, Errors};
use crate::form::{Carried, Distance, Form, Linear, Term};
use crate::name::{Name, Named};
use crate::system::{
    AXES, Body, Drive, Equation, Marker, Measure, Measured, Origin, Point, Site, SiteMotion,
    System, Wheel, carried_name, distance_between, pair_name,
};

/// Lowers a listing, of one with mistakes what can be told. What only shows on the way is reported.
pub fn system(listing: &Listing, errors: &mut Errors) -> System {
    let mut lowering = Lowering {
        listing,
        bodies: Vec::new(),
        equations: Vec::new(),
        rigid: BTreeSet::new(),
        errors,
    };
    // Bodies with two chassis points come first: what they share with others is settled by then.
    let (hinged, others): (Vec<_>, Vec<_>) = listing
        .constraints
        .iter()
        .partition(|constraint| lowering.is_hinged(constraint));
    for constraint in hinged.into_iter().chain(others) {
        match constraint {
            Constraint::Link(link) => lowering.link(link),
            Constraint::Body(body) => lowering.body(body),
        }
    }
    let drives: Vec<Drive> = listing
        .drives
        .iter()
        .map(|drive| lowering.drive(drive))
        .collect();
    let markers = listing
        .markers
        .iter()
        .filter_map(|marker| lowering.marker(marker))
        .collect();
    let wheel = listing.wheel.first().and_then(|axis| lowering.wheel(axis));
    let kingpin = listing.kingpin.first();
    System {
        docs: listing.docs.clone(),
        fixed: points(&listing.fixed),
        free: points(&listing.free),
        markers,
        clusters: lowering.clusters(),
        bodies: lowering.bodies,
        equations: lowering.equations,
        drives,
        measures: listing.measures.iter().map(measure).collect(),
        wheel,
        kingpin: kingpin.map(|axis| plain([&axis.from, &axis.to])),
    }
}

fn points(stated: &[ast::Point]) -> Vec<Point> {
    let point = |point: &ast::Point| Point {
        named: point.named.plain(),
        at: point.at,
    };
    stated.iter().map(point).collect()
}

fn plain<const K: usize>(names: [&Ident; K]) -> [Name; K] {
    names.map(Name::from)
}

struct Lowering<'a> {
    listing: &'a Listing,
    bodies: Vec<Body>,
    equations: Vec<Equation>,
    /// Pairs of points whose distance an equation keeps already, or a body carries.
    rigid: BTreeSet<[Name; 2]>,
    errors: &'a mut Errors,
}

impl Lowering<'_> {
    fn site(&self, name: &Ident) -> Site {
        let place = |points: &[ast::Point]| points.iter().position(|p| p.named.name == *name);
        let mut drives = self.listing.drives.iter();
        let driven = drives.any(|drive| match &drive.quantity {
            Quantity::Coordinate { of, minus: None } => of.point == *name,
            _ => false,
        });
        let (index, motion) = match (place(&self.listing.fixed), driven) {
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

    /// Whether a constraint is a body with two chassis points.
    fn is_hinged(&self, constraint: &Constraint) -> bool {
        let anchors = constraint
            .points()
            .filter(|point| !self.site(point).is_free());
        matches!(constraint, Constraint::Body(_)) && anchors.count() == 2
    }

    fn clusters(&self) -> Vec<Body> {
        let points = self.listing.fixed.iter().chain(&self.listing.free);
        let sites: Vec<Site> = points.map(|point| self.site(&point.named.name)).collect();
        cluster::clusters(&sites, &self.equations)
    }

    fn wheel(&self, Axis { from, to, .. }: &Axis) -> Option<Wheel> {
        let points = self.listing.carrier_of(from, to)?;
        let names: Vec<Name> = points.iter().map(Name::from).collect();
        let lists = |body: &Body, name: &Name| body.points().any(|site| site.name == *name);
        let mut bodies = self.bodies.iter();
        let body = bodies.find(|body| names.iter().all(|name| lists(body, name)));
        let carrier = match (body, names.as_slice()) {
            (Some(body), _) => body.frame.each_ref().map(|site| site.name.clone()),
            (None, [first, second, third, ..]) => [first, second, third].map(Name::clone),
            _ => return None,
        };
        Some(Wheel {
            axis: plain([from, to]),
            carrier,
        })
    }

    fn link(&mut self, link: &ast::Link) {
        let origin = origin("link", &link.named, None);
        let ends = [self.site(&link.from), self.site(&link.to)];
        self.distance(link.named.plain(), origin, ends);
    }

    fn distance(&mut self, named: Named, origin: Origin, [a, b]: [Site; 2]) {
        self.rigid.insert(pair(&a, &b));
        let (from, to) = if b.is_free() { (a, b) } else { (b, a) };
        let form = Form::Distance(Distance { from, to });
        self.push(named, origin, form);
    }

    fn push(&mut self, named: Named, origin: Origin, form: Form) {
        self.equations.push(Equation {
            named,
            origin,
            form,
        });
    }

    /// The points of a body, those of its frame first: chassis points, then points shared with
    /// another body, then in the order listed.
    fn in_frame_order(&self, body: &ast::Body) -> Vec<Site> {
        let sites: Vec<Site> = body.points.iter().map(|point| self.site(point)).collect();
        let is_shared = |site: &Site| {
            let mut others = sites.iter();
            others.any(|other| self.rigid.contains(&pair(site, other)))
        };
        let mut ordered = sites.clone();
        ordered.sort_by_key(|site| (site.is_free(), !is_shared(site)));
        ordered
    }

    /// A body of two points is a distance. A larger one has the three distances of its frame,
    /// less those that the chassis or another body keeps, and three equations for each point
    /// carried.
    fn body(&mut self, body: &ast::Body) {
        let sites = self.in_frame_order(body);
        if let [a, b] = sites.as_slice() {
            self.body_distance(body, a, b);
        }
        let [a, b, c, carried @ ..] = sites.as_slice() else {
            return;
        };
        let lowered = Body {
            name: Name::from(&body.named.name),
            frame: [a.clone(), b.clone(), c.clone()],
            carried: carried.to_vec(),
        };
        for [a, b] in lowered.frame_pairs() {
            self.body_distance(body, a, b);
        }
        for point in carried {
            self.carried_once(body, &sites, point);
        }
        for point in carried {
            self.carried(body, &lowered, point);
        }
        for (index, a) in sites.iter().enumerate() {
            self.rigid
                .extend(sites.iter().skip(index + 1).map(|b| pair(a, b)));
        }
        self.bodies.push(lowered);
    }

    /// Checks that no other body keeps a distance of a carried point.
    fn carried_once(&mut self, body: &ast::Body, sites: &[Site], point: &Site) {
        let mut others = sites.iter();
        if let Some(known) = others.find(|site| self.rigid.contains(&pair(site, point))) {
            let error = errors::closed_twice(&body.named.name, &known.name, &point.name);
            self.errors.push(error);
        }
    }

    fn carried(&mut self, body: &ast::Body, lowered: &Body, point: &Site) {
        let named = Named {
            name: carried_name(&lowered.name, &point.name),
            docs: Vec::new(),
        };
        let form = Form::Carried(Carried {
            body: lowered.name.clone(),
            frame: lowered.frame.clone(),
            point: point.clone(),
        });
        self.push(named, origin("body", &body.named, Some(point)), form);
    }

    fn body_distance(&mut self, body: &ast::Body, a: &Site, b: &Site) {
        let on_chassis = !a.is_free() && !b.is_free();
        if !on_chassis && !self.rigid.contains(&pair(a, b)) {
            let named = Named {
                name: pair_name(&Name::from(&body.named.name), &a.name, &b.name),
                docs: body.named.docs.clone(),
            };
            let origin = origin("body", &body.named, Some(a));
            self.distance(named, origin, [a.clone(), b.clone()]);
        }
    }

    fn drive(&mut self, drive: &ast::Drive) -> Drive {
        let (axis, of, minus, angle_of) = match &drive.quantity {
            Quantity::Coordinate { of, minus } => (
                &of.axis,
                &of.point,
                minus.as_ref().map(|minus| &minus.point),
                None,
            ),
            Quantity::Angle { from, to, axis } => {
                let [a, b] = plain([from, to]);
                let distance = distance_between(&self.equations, &a, &b);
                (axis, to, Some(from), distance.cloned())
            }
        };
        let (axis, of) = (axis_index(axis), self.site(of));
        if of.is_free() || minus.is_some() {
            let minus = minus.map(|minus| self.site(minus));
            let ends = [(1.0, Some(of.clone())), (-1.0, minus)];
            let term = |(factor, site): (f64, Option<Site>)| {
                let site = site?;
                Some(Term { factor, site, axis })
            };
            let form = Form::Linear(Linear {
                terms: ends.into_iter().filter_map(term).collect(),
                drive: Name::from(&drive.named.name),
            });
            self.push(
                drive.named.plain(),
                origin("drive", &drive.named, None),
                form,
            );
        }
        Drive {
            named: drive.named.plain(),
            axis,
            of,
            minus: minus.map(Name::from),
            angle_of,
        }
    }

    fn marker(&self, marker: &ast::Marker) -> Option<Marker> {
        let frame = match marker.carriers.as_slice() {
            [a, b, c] => [a, b, c].map(|point| self.site(point)),
            carriers => {
                let carriers: Vec<Name> = carriers.iter().map(Name::from).collect();
                let mut bodies = self.bodies.iter();
                let body = bodies.find(|body| carriers.contains(&body.name))?;
                body.frame.clone()
            }
        };
        Some(Marker {
            named: marker.named.plain(),
            frame,
        })
    }
}

fn origin(word: &'static str, named: &ast::Named, operand: Option<&Site>) -> Origin {
    Origin {
        word,
        statement: Name::from(&named.name),
        operand: operand.map(|site| site.name.clone()),
    }
}

fn measure(measure: &ast::Measure) -> Measure {
    let measured = match &measure.measured {
        ast::Measured::Quantity(Quantity::Coordinate { of, minus }) => Measured::Coordinate {
            axis: axis_index(&of.axis),
            of: Name::from(&of.point),
            minus: minus.as_ref().map(|minus| Name::from(&minus.point)),
        },
        ast::Measured::Quantity(Quantity::Angle { from, to, axis }) => Measured::Angle {
            axis: axis_index(axis),
            line: plain([from, to]),
        },
        ast::Measured::Length { from, to } => Measured::Length {
            line: plain([from, to]),
        },
    };
    Measure {
        named: measure.named.plain(),
        measured,
    }
}

fn axis_index(axis: &Ident) -> usize {
    let mut axes = AXES.iter();
    axes.position(|name| axis == name).unwrap_or_default()
}

/// An unordered pair of points.
fn pair(a: &Site, b: &Site) -> [Name; 2] {
    let mut names = [a.name.clone(), b.name.clone()];
    names.sort();
    names
}

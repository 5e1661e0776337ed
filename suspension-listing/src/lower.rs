//! From the checked listing to the system of equations.

use std::collections::BTreeSet;

use syn::Ident;

use crate::ast::{self, Axis, Constraint, Listing, Named, Quantity};
use crate::cluster;
use crate::system::{
    AXES, Body, Drive, Equation, Marker, Measure, Measured, Site, SiteMotion, System, Wheel,
    distance_between, pair_name,
};

/// Lowers a listing; of one with mistakes, what can be told.
pub fn system(listing: &Listing) -> System {
    let mut lowering = Lowering {
        listing,
        bodies: Vec::new(),
        equations: Vec::new(),
        rigid: BTreeSet::new(),
        closed_twice: Vec::new(),
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
    let kingpin = listing
        .kingpin
        .first()
        .map(|axis| [axis.from.clone(), axis.to.clone()]);
    System {
        docs: listing.docs.clone(),
        vis: listing.vis.clone(),
        name: listing.name.clone(),
        free_span: listing.free_span,
        fixed: listing.fixed.clone(),
        free: listing.free.clone(),
        design: listing
            .design
            .iter()
            .map(|(point, at)| (point.to_string(), *at))
            .collect(),
        markers,
        clusters: lowering.clusters(),
        bodies: lowering.bodies,
        equations: lowering.equations,
        closed_twice: lowering.closed_twice,
        drives,
        measures: listing.measures.iter().map(measure).collect(),
        wheel,
        kingpin,
    }
}

struct Lowering<'a> {
    listing: &'a Listing,
    bodies: Vec<Body>,
    equations: Vec<Equation>,
    /// Pairs of points whose distance an equation keeps already, or a body carries.
    rigid: BTreeSet<[String; 2]>,
    /// Bodies with a pair of points that another body keeps already.
    closed_twice: Vec<[Ident; 3]>,
}

impl Lowering<'_> {
    fn site(&self, name: &Ident) -> Site {
        let on_chassis = self.listing.fixed.iter().any(|fixed| fixed.name == *name);
        let driven = self
            .listing
            .drives
            .iter()
            .any(|drive| match &drive.quantity {
                Quantity::Coordinate { of, minus: None } => of.point == *name,
                _ => false,
            });
        let motion = match (on_chassis, driven) {
            (false, _) => SiteMotion::Free,
            (true, false) => SiteMotion::Anchor,
            (true, true) => SiteMotion::DrivenAnchor,
        };
        Site {
            name: name.clone(),
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
        let sites: Vec<Site> = points.map(|point| self.site(&point.name)).collect();
        cluster::clusters(&sites, &self.equations)
    }

    fn wheel(&self, Axis { from, to, .. }: &Axis) -> Option<Wheel> {
        let points = self.listing.carrier_of(from, to)?;
        let body = self.bodies.iter().find(|body| {
            points
                .iter()
                .all(|point| body.points().any(|site| site.name == *point))
        });
        let carrier = match (body, points) {
            (Some(body), _) => body.frame.each_ref().map(|site| site.name.clone()),
            (None, [first, second, third, ..]) => [first, second, third].map(Ident::clone),
            _ => return None,
        };
        Some(Wheel {
            axis: [from.clone(), to.clone()],
            carrier,
        })
    }

    fn link(&mut self, link: &ast::Link) {
        self.distance(
            link.named.clone(),
            self.site(&link.from),
            self.site(&link.to),
            false,
        );
    }

    fn distance(&mut self, named: Named, a: Site, b: Site, of_body: bool) {
        self.rigid.insert(pair(&a, &b));
        let (from, to) = if b.is_free() { (a, b) } else { (b, a) };
        self.equations.push(Equation::Distance {
            named,
            from,
            to,
            of_body,
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
        let name = &body.named.name;
        let sites = self.in_frame_order(body);
        if let [a, b] = sites.as_slice() {
            self.body_distance(body, a, b);
        }
        let [a, b, c, carried @ ..] = sites.as_slice() else {
            return;
        };
        let lowered = Body {
            name: name.clone(),
            frame: [a.clone(), b.clone(), c.clone()],
            carried: carried.to_vec(),
        };
        for [a, b] in lowered.frame_pairs() {
            self.body_distance(body, a, b);
        }
        for point in carried {
            let known = sites
                .iter()
                .find(|site| self.rigid.contains(&pair(site, point)));
            if let Some(known) = known {
                self.closed_twice
                    .push([name.clone(), known.name.clone(), point.name.clone()]);
            }
        }
        for point in carried {
            let (body, point, frame) = (name.clone(), point.clone(), lowered.frame.clone());
            self.equations
                .push(Equation::Carried { body, point, frame });
        }
        for (index, a) in sites.iter().enumerate() {
            self.rigid
                .extend(sites.iter().skip(index + 1).map(|b| pair(a, b)));
        }
        self.bodies.push(lowered);
    }

    fn body_distance(&mut self, body: &ast::Body, a: &Site, b: &Site) {
        let on_chassis = !a.is_free() && !b.is_free();
        if !on_chassis && !self.rigid.contains(&pair(a, b)) {
            let name = pair_name(&body.named.name, &a.name, &b.name);
            let named = Named {
                docs: body.named.docs.clone(),
                name,
            };
            self.distance(named, a.clone(), b.clone(), true);
        }
    }

    fn drive(&mut self, drive: &ast::Drive) -> Drive {
        let named = drive.named.clone();
        let (axis, of, minus, angle_of) = match &drive.quantity {
            Quantity::Coordinate { of, minus } => (
                &of.axis,
                &of.point,
                minus.as_ref().map(|minus| &minus.point),
                None,
            ),
            Quantity::Angle { from, to, axis } => (
                axis,
                to,
                Some(from),
                distance_between(&self.equations, from, to),
            ),
        };
        let axis = axis_index(axis);
        let of = self.site(of);
        if of.is_free() || minus.is_some() {
            let (drive, of) = (named.name.clone(), of.clone());
            let minus = minus.map(|minus| self.site(minus));
            self.equations.push(Equation::Coordinate {
                drive,
                axis,
                of,
                minus,
            });
        }
        Drive {
            named,
            axis,
            of,
            minus: minus.cloned(),
            angle_of,
        }
    }

    fn marker(&self, marker: &ast::Marker) -> Option<Marker> {
        let frame = match marker.carriers.as_slice() {
            [a, b, c] => [a, b, c].map(|point| self.site(point)),
            carriers => {
                let mut bodies = self.bodies.iter();
                let body = bodies.find(|body| carriers.contains(&body.name))?;
                body.frame.clone()
            }
        };
        Some(Marker {
            named: marker.named.clone(),
            frame,
        })
    }
}

fn measure(measure: &ast::Measure) -> Measure {
    let line = |from: &Ident, to: &Ident| [from.clone(), to.clone()];
    let measured = match &measure.measured {
        ast::Measured::Quantity(Quantity::Coordinate { of, minus }) => Measured::Coordinate {
            axis: axis_index(&of.axis),
            of: of.point.clone(),
            minus: minus.as_ref().map(|minus| minus.point.clone()),
        },
        ast::Measured::Quantity(Quantity::Angle { from, to, axis }) => Measured::Angle {
            axis: axis_index(axis),
            line: line(from, to),
        },
        ast::Measured::Length { from, to } => Measured::Length {
            line: line(from, to),
        },
    };
    Measure {
        named: measure.named.clone(),
        measured,
    }
}

fn axis_index(axis: &Ident) -> usize {
    let mut axes = AXES.iter();
    axes.position(|name| axis == name).unwrap_or_default()
}

/// An unordered pair of points.
fn pair(a: &Site, b: &Site) -> [String; 2] {
    let mut names = [a.name.to_string(), b.name.to_string()];
    names.sort();
    names
}

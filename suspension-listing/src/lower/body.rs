//! Rigid bodies: a frame of three points, and points that it carries.

use syn::{Error, Ident};

use super::{origin, pair};
use crate::errors;
use crate::form::{Carried, Form};
use crate::kind::Kind;
use crate::listing;
use crate::listing::Lowering;
use crate::name::{Name, Named};
use crate::system::{Body, Site, carried_name, pair_name};

impl Lowering<'_> {
    /// A body of two points is a distance. A larger body has the three distances of its frame, without those that the
    /// chassis or another body keeps, and three equations for each carried point.
    pub(crate) fn body(&mut self, kind: Kind, stated: &listing::Named, points: &[Ident]) {
        let named = stated.plain();
        let sites = self.sort_for_frame(points);
        if let [a, b] = sites.as_slice() {
            self.body_distance(kind, &named, a, b);
        }
        let [a, b, c, carried @ ..] = sites.as_slice() else {
            return;
        };
        let body = Body {
            name: named.name.clone(),
            frame: [a.clone(), b.clone(), c.clone()],
            carried: carried.to_vec(),
        };
        for [a, b] in body.frame_pairs() {
            self.body_distance(kind, &named, a, b);
        }
        for point in carried {
            self.carried_once(&stated.name, &sites, point);
        }
        for point in carried {
            self.carried(kind, &body, point);
        }
        for (index, a) in sites.iter().enumerate() {
            let others = sites.iter().skip(index + 1);
            self.rigid.extend(others.map(|b| pair(a, b)));
        }
        self.system.bodies.push(body);
    }

    /// The points of a body with those of its frame first: chassis points, then points shared with another body, then
    /// in the order listed.
    fn sort_for_frame(&self, points: &[Ident]) -> Vec<Site> {
        let sites: Vec<Site> = points.iter().map(|point| self.site(point)).collect();
        let is_shared = |site: &Site| {
            let mut others = sites.iter();
            others.any(|other| self.rigid.contains(&pair(site, other)))
        };
        let mut ordered = sites.clone();
        ordered.sort_by_key(|site| (site.is_free(), !is_shared(site)));
        ordered
    }

    fn body_distance(&mut self, kind: Kind, body: &Named, a: &Site, b: &Site) {
        let on_chassis = !a.is_free() && !b.is_free();
        if !on_chassis && !self.rigid.contains(&pair(a, b)) {
            let named = Named {
                name: pair_name(&body.name, &a.name, &b.name),
                docs: body.docs.clone(),
            };
            let origin = origin(kind, &body.name, Some(a));
            self.distance(named, origin, [a.clone(), b.clone()]);
        }
    }

    /// Checks that no other body keeps a distance of a carried point.
    fn carried_once(&mut self, body: &Ident, sites: &[Site], point: &Site) {
        let mut others = sites.iter();
        if let Some(known) = others.find(|site| self.rigid.contains(&pair(site, point))) {
            let error = closed_twice(body, &known.name, &point.name);
            self.errors.push(error);
        }
    }

    fn carried(&mut self, kind: Kind, body: &Body, point: &Site) {
        let named = Named {
            name: carried_name(&body.name, &point.name),
            docs: Vec::new(),
        };
        let form = Form::Carried(Carried {
            body: body.name.clone(),
            frame: body.frame.clone(),
            point: point.clone(),
        });
        self.equation(named, origin(kind, &body.name, Some(point)), form);
    }
}

fn closed_twice(body: &Ident, a: &Name, b: &Name) -> Error {
    errors::at(
        body,
        format!(
            "another body keeps the distance of `{a}` and `{b}` already, and `{body}` can share only \
             one such pair; join `{b}` to `{body}` by links instead"
        ),
    )
}

//! The places of lengths.

use suspension_listing::name::Name;
use suspension_listing::system::{self, System, distance_between, pair_name};

use super::places::{distance, position};
use crate::table::index;

/// The part that keeps a length.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Length {
    Distance(u16),
    /// An edge of a body's frame: first-second, first-third, second-third.
    Edge {
        body: u16,
        edge: u16,
    },
    /// A carried point, numbered among those of all bodies: the length to the first, second or third point of its
    /// body's frame.
    Reach {
        body: u16,
        carried: u16,
        corner: u16,
    },
}

/// The part that keeps the length of a line that a point slides on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum LineLength {
    /// A length; `None` if both ends are on the chassis.
    Given(Option<u16>),
    /// A body, by two of its points.
    Body { body: u16, ends: [BodyPoint; 2] },
}

/// A point of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum BodyPoint {
    /// The first, second or third point of its frame.
    Frame(u16),
    /// One of the points that all bodies carry.
    Carried(u16),
}

/// The names of the lengths.
pub(crate) struct LengthNames<'a> {
    system: &'a System,
    names: Vec<Name>,
}

impl<'a> LengthNames<'a> {
    pub(super) fn new(system: &'a System) -> Self {
        let lengths = system.lengths().into_iter();
        let names = lengths.map(|length| length.named.name).collect();
        Self { system, names }
    }

    /// The index of a length.
    pub(crate) fn place(&self, name: &Name) -> u16 {
        position(self.names.iter(), name)
    }

    /// The index of the length between two points of a body; `None` if both are on the chassis.
    pub(crate) fn body_length(&self, body: &Name, ends: [&system::Site; 2]) -> Option<u16> {
        let [a, b] = ends;
        let is_kept = a.is_free() || b.is_free();
        is_kept.then(|| self.place(&pair_name(body, &a.name, &b.name)))
    }

    /// The index of the length that an equation keeps between two points.
    pub(super) fn kept_length(&self, [a, b]: [&system::Site; 2]) -> Option<u16> {
        let name = distance_between(&self.system.equations, &a.name, &b.name)?;
        Some(self.place(name))
    }

    /// The part that keeps the length between two points that nothing moves relative to each other.
    pub(crate) fn line_length(&self, ends: [&system::Site; 2]) -> LineLength {
        let [a, b] = ends;
        let given = self.kept_length(ends);
        if given.is_some() || !(a.is_free() || b.is_free()) {
            return LineLength::Given(given);
        }
        let mut before = 0;
        for (body, of) in (0..).zip(&self.system.bodies) {
            let point = |end: &system::Site| {
                let place = of.points().position(|point| point.name == end.name)?;
                Some(match place.checked_sub(of.frame.len()) {
                    None => BodyPoint::Frame(index(place)),
                    Some(carried) => BodyPoint::Carried(index(before + carried)),
                })
            };
            if let (Some(a), Some(b)) = (point(a), point(b)) {
                return LineLength::Body { body, ends: [a, b] };
            }
            before += of.carried.len();
        }
        LineLength::Given(given)
    }

    /// The part that keeps each length.
    pub(super) fn lengths(&self) -> Vec<Length> {
        let bodies = (0..).zip(&self.system.bodies);
        let edges = bodies.clone().flat_map(|(body, of)| {
            let pairs = (0..).zip(of.frame_pairs());
            pairs.map(move |(edge, [a, b])| {
                let name = pair_name(&of.name, &a.name, &b.name);
                (name, Length::Edge { body, edge })
            })
        });
        let carried =
            bodies.flat_map(|(body, of)| of.carried.iter().map(move |point| (body, of, point)));
        let reaches = carried
            .enumerate()
            .flat_map(|(carried, (body, of, point))| {
                let corners = (0..).zip(&of.frame);
                corners.map(move |(corner, site)| {
                    let name = pair_name(&of.name, &point.name, &site.name);
                    let carried = index(carried);
                    (
                        name,
                        Length::Reach {
                            body,
                            carried,
                            corner,
                        },
                    )
                })
            });
        let of_bodies: Vec<(Name, Length)> = edges.chain(reaches).collect();
        let kept_by = |name: &Name| {
            let of_distance = Length::Distance(distance(self.system, name));
            let keeps = |equation: &system::Equation| {
                equation.named.name == *name && equation.form.equations().keeps().is_some()
            };
            if self.system.equations.iter().any(keeps) {
                return of_distance;
            }
            let mut of_bodies = of_bodies.iter();
            let of_body = of_bodies.find(|(of_body, _)| of_body == name);
            of_body.map_or(of_distance, |(_, length)| *length)
        };
        self.names.iter().map(kept_by).collect()
    }
}

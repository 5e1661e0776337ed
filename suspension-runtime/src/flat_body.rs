//! Bodies whose first three points, which carry the other points, lie in line.

use nalgebra::Vector3;
use suspension_core::model::constraint::Frame;
use suspension_core::model::parts;
use suspension_listing::Kind;
use suspension_listing::form::Form;
use suspension_listing::system::{Body, Equation, Site};

use crate::listing::Listing;

/// A body that its first three points cannot carry, because they are collinear.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FlatBody<'l> {
    /// The body's name.
    pub name: &'l str,
    /// Its three collinear points: chassis points first, then points that another body has too.
    pub in_line: [&'l str; 3],
    /// Whether it is a hinge, whose first two points are its axis.
    pub is_hinge: bool,
    /// A point of the body that would carry the others in place of the third one if it were listed before that.
    pub instead: Option<&'l str>,
}

impl Listing {
    /// The body whose first three points are collinear at these `positions` of all points, with `third` the last of
    /// them.
    pub fn flat_body(&self, third: usize, positions: &[Vector3<f64>]) -> Option<FlatBody<'_>> {
        let carries = |frame: [&Site; 3]| {
            let [a, b, c] = frame.map(|site| positions.get(self.place_of(site)).copied());
            let frame = Frame::new(a?, b?, c?);
            parts::frame(third, frame).ok().map(|_| sine(&frame))
        };
        let mut bodies = self.system().bodies.iter();
        let body = bodies.find(|body| {
            let [.., last] = &body.frame;
            self.place_of(last) == third && carries(body.frame.each_ref()).is_none()
        })?;
        let [first, second, last] = &body.frame;
        let others = body.carried.iter();
        let others = others.filter_map(|point| Some((point, carries([first, second, point])?)));
        let best = others.max_by(|(_, one), (_, other)| one.total_cmp(other));
        let instead = best.filter(|_| !self.is_shared(last, body));
        let mut equations = self.system().equations.iter();
        Some(FlatBody {
            name: body.name.as_str(),
            in_line: body.frame.each_ref().map(|site| site.name.as_str()),
            is_hinge: equations.any(|equation| is_of(equation, body, Kind::HINGE)),
            instead: instead.map(|(point, _)| point.name.as_str()),
        })
    }

    /// Whether another statement keeps the distance between a body's point and another of its points: such points
    /// come first.
    fn is_shared(&self, point: &Site, body: &Body) -> bool {
        let is_other = |site: &Site| site != point && body.points().any(|own| own == site);
        let mut bodies = self.system().bodies.iter();
        let in_a_body = bodies.any(|other| {
            other.name != body.name
                && other.points().any(|site| site == point)
                && other.points().any(is_other)
        });
        let mut equations = self.system().equations.iter();
        in_a_body
            || equations.any(|equation| match &equation.form {
                Form::Distance(distance) => {
                    let ends = [&distance.from, &distance.to];
                    equation.origin.statement != body.name
                        && ends.contains(&point)
                        && ends.into_iter().any(is_other)
                }
                _ => false,
            })
    }
}

fn is_of(equation: &Equation, body: &Body, kind: Kind) -> bool {
    equation.origin.statement == body.name && equation.origin.kind == kind
}

/// The sine of the angle between a frame's edges.
fn sine(frame: &Frame<f64>) -> f64 {
    frame.u.cross(&frame.v).norm() / (frame.u.norm() * frame.v.norm())
}

//! Lines on the chassis on which points slide, for example that of a rack.

use nalgebra::Vector3;
use suspension_listing::Kind;
use suspension_runtime::{Listing, Statement};

/// A line through two points on the chassis to which nothing else is joined.
#[derive(Clone, Debug, PartialEq)]
pub struct Guide {
    /// The two points, by number.
    ends: [usize; 2],
    /// The points that slide on it.
    sliding: Vec<usize>,
    /// Its direction at the design position; zero before that is known.
    along: Vector3<f64>,
}

impl Guide {
    /// All guides of a listing with this number of chassis points.
    pub(crate) fn all(listing: &Listing, chassis: usize) -> Vec<Self> {
        let statements = listing.statements();
        let lines = statements.iter().map(|statement| line(statement, chassis));
        let lines: Vec<Option<([usize; 2], usize)>> = lines.collect();
        let others = statements.iter().zip(&lines);
        let others = others.filter(|(_, line)| line.is_none());
        let others = others.flat_map(|(statement, _)| &statement.points);
        let taken = others.copied().chain(listing.driven_points());
        let taken: Vec<usize> = taken.collect();
        let mut guides: Vec<Self> = Vec::new();
        for (ends, sliding) in lines.into_iter().flatten() {
            if ends.iter().any(|end| taken.contains(end)) {
                continue;
            }
            match guides.iter_mut().find(|guide| guide.ends == ends) {
                Some(guide) => guide.sliding.push(sliding),
                None => guides.push(Self {
                    ends,
                    sliding: vec![sliding],
                    along: Vector3::zeros(),
                }),
            }
        }
        guides
    }

    /// Sets its direction from the points of the design.
    pub(crate) fn design(&mut self, points: &[Vector3<f64>]) {
        let [from, to] = self.ends.map(|end| points[end]);
        self.along = (to - from).normalize();
    }

    /// The points that move with a point that slides on it (the ends of the line and the other points that slide
    /// there), each with its displacement: the part of `by` across the line.
    pub(crate) fn moved_with(&self, point: usize, by: Vector3<f64>) -> Vec<(usize, Vector3<f64>)> {
        if !self.sliding.contains(&point) {
            return Vec::new();
        }
        let across = by - self.along * self.along.dot(&by);
        let others = self.sliding.iter().filter(|other| **other != point);
        let moved = self.ends.iter().chain(others);
        moved.map(|moved| (*moved, across)).collect()
    }
}

/// The ends of the line of a slide on the chassis, in the order of their numbers, and the point that slides there.
fn line(statement: &Statement<'_>, chassis: usize) -> Option<([usize; 2], usize)> {
    let is_fixed = |point: &usize| *point < chassis;
    let (mut fixed, free): (Vec<usize>, Vec<usize>) =
        statement.points.iter().copied().partition(is_fixed);
    fixed.sort_unstable();
    match (fixed.as_slice(), free.as_slice()) {
        ([from, to], [sliding]) if statement.kind == Kind::SLIDE => Some(([*from, *to], *sliding)),
        _ => None,
    }
}

//! How two joints share the force along the line through them, which rigid parts do not determine: each bears half of it.

use nalgebra::Vector3;
use suspension_listing::Kind;
use suspension_runtime::Statement;

use crate::loads::By;

/// Two joints of the same parts.
pub(super) struct Shared {
    /// The part by number, with the other part; without it the chassis.
    pub(super) parts: (usize, Option<usize>),
    /// The joints.
    points: [usize; 2],
}

impl Shared {
    /// The two bushes of each hinge and of each body with two chassis points, then the points of each two bodies that share
    /// two. `chassis` is the number of chassis points, which are the first of all points.
    pub(super) fn all(statements: &[Statement<'_>], chassis: usize) -> Vec<Self> {
        let bodies = || {
            let all = statements.iter().enumerate();
            all.filter(|(_, part)| [Kind::BODY, Kind::HINGE].contains(&part.kind))
        };
        let bushes = bodies().filter_map(|(number, part)| {
            let is_bush = |point: &usize| *point < chassis;
            let points = two(part.points.iter().copied().filter(is_bush))?;
            let parts = (number, None);
            Some(Self { parts, points })
        });
        let pairs = bodies().flat_map(|(number, part)| {
            bodies()
                .skip_while(move |(other, _)| *other <= number)
                .filter_map(move |(other, with)| {
                    let is_of_both = |point: &usize| with.points.contains(point);
                    let points = two(part.points.iter().copied().filter(is_of_both))?;
                    let parts = (number, Some(other));
                    let are_free = points.iter().any(|point| *point >= chassis);
                    are_free.then_some(Self { parts, points })
                })
        });
        let has_both = |points: [usize; 2]| {
            let are_of = |part: &Statement<'_>| points.iter().all(|at| part.points.contains(at));
            bodies().filter(|(_, part)| are_of(part)).count()
        };
        // Three bodies on one line may share the force in other ways.
        let alone = pairs.filter(|shared| has_both(shared.points) == 2);
        bushes.chain(alone).collect()
    }

    /// Gives each joint half of the force along the line, in the forces of parts at joints.
    pub(super) fn halve(&self, joints: &mut [(By, usize, Vector3<f64>)], at: &[Vector3<f64>]) {
        let (part, with) = self.parts;
        let [first, second] = self.points;
        let place = |part: usize, point: usize| {
            let mut each = joints.iter();
            each.position(|(by, at, _)| (*by, *at) == (By::Part(part), point))
        };
        let axis = (at[second] - at[first]).normalize();
        let of_each: Vec<([usize; 2], f64)> = [(Some(part), 1.0), (with, -1.0)]
            .into_iter()
            .filter_map(|(part, sign)| {
                let places = [place(part?, first)?, place(part?, second)?];
                Some((places, sign))
            })
            .collect();
        let apart = of_each.iter().map(|([first, second], sign)| {
            sign * (joints[*second].2 - joints[*first].2).dot(&axis)
        });
        let moved = axis * (0.5 * apart.sum::<f64>() / of_each.len() as f64);
        for ([first, second], sign) in of_each {
            joints[first].2 += moved * sign;
            joints[second].2 -= moved * sign;
        }
    }
}

/// The elements, if there are two.
fn two(mut elements: impl Iterator<Item = usize>) -> Option<[usize; 2]> {
    let both = [elements.next()?, elements.next()?];
    elements.next().is_none().then_some(both)
}

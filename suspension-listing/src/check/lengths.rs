//! A check that only one statement keeps a length.

use std::collections::BTreeSet;

use syn::{Error, Ident};

use crate::errors;
use crate::kind::Kind;
use crate::listing::{Check, Rigid, Statement};

impl Check<'_> {
    /// Checks that a statement keeps no distance that an earlier one keeps, except the common edge of two bodies.
    pub(crate) fn lengths_stated_once(
        &mut self,
        later: &dyn Statement,
        earlier: &[Box<dyn Statement>],
    ) {
        for earlier in earlier {
            let (Some((later_name, of_later)), Some((earlier_name, of_earlier))) =
                (rigid(later), rigid(earlier.as_ref()))
            else {
                continue;
            };
            let before: BTreeSet<&Ident> = of_earlier.points().iter().collect();
            let points = of_later.points().iter().collect::<BTreeSet<_>>();
            let common: Vec<&Ident> = points.intersection(&before).copied().collect();
            if !common.iter().any(|point| self.is(point, Kind::FREE_POINT)) {
                continue;
            }
            match (of_later, of_earlier, common.len()) {
                (Rigid::Body(_), Rigid::Body(_), 3..) => {
                    self.report(shared_triangle(later_name, earlier_name));
                }
                (Rigid::Body([_, _]), Rigid::Body(_), 2) => {
                    self.report(adds_nothing(later_name, earlier_name));
                }
                (Rigid::Body(_), Rigid::Body([_, _]), 2) => {
                    self.report(adds_nothing(earlier_name, later_name));
                }
                (Rigid::Body(_), Rigid::Body(_), _) | (_, _, 0 | 1) => {}
                (Rigid::Length(_), _, _) => self.length_twice(later_name, earlier_name),
                (_, Rigid::Length(_), _) => self.length_twice(earlier_name, later_name),
            }
        }
    }
}

impl Check<'_> {
    /// Reports a length that is kept already. If only one of the two statements is a mirror image, the error
    /// is at the other one.
    fn length_twice(&mut self, length: &Ident, other: &Ident) {
        if length == other {
            return; // That the name is taken is reported already.
        }
        let error = match (self.is_image(length), self.is_image(other)) {
            (true, false) => kept_by_image(other, length),
            (false, true) => kept_by_image(length, other),
            _ => stated_twice(length, other),
        };
        self.report(error);
    }
}

fn rigid(statement: &dyn Statement) -> Option<(&Ident, Rigid<'_>)> {
    let (named, _) = statement.named()?;
    Some((&named.name, statement.rigid()?))
}

fn stated_twice(name: &Ident, other: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "`{name}` joins two points whose distance `{other}` keeps already; remove one of them"
        ),
    )
}

fn kept_by_image(name: &Ident, image: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "`{name}` joins two points whose distance `{image}` keeps, which `mirror` makes; remove `{name}`"
        ),
    )
}

fn adds_nothing(body: &Ident, other: &Ident) -> Error {
    errors::at(
        body,
        format!(
            "body `{body}` has two points, whose distance body `{other}` keeps already, and adds nothing; remove it, or list its third point"
        ),
    )
}

fn shared_triangle(name: &Ident, other: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "body `{name}` shares three points with body `{other}`: they are one body; list all points in one"
        ),
    )
}

//! `body plate: c, d, e;`: a rigid body. Its first three points, the frame, must not be in line.

use syn::{Error, Ident};

use super::operands::names;
use super::word::{Head, Word};
use crate::errors;
use crate::kind::Kind;
use crate::listing::{Check, Lowering, Named, Rigid, Statement};

const KIND: Kind = Kind::BODY;

pub(crate) const BODY: Word = Word {
    word: "body",
    syntax: "body plate: c, d, e;",
    read: |head: Head, input, listing| {
        let body = Body {
            named: head.named(input)?,
            points: names(input)?,
        };
        listing.statements.push(Box::new(body));
        Ok(())
    },
};

struct Body {
    named: Named,
    points: Vec<Ident>,
}

impl Statement for Body {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, KIND))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.points.iter().collect()
    }

    fn check(&self, check: &mut Check<'_>, earlier: &[Box<dyn Statement>]) {
        let name = &self.named.name;
        check.sites(&self.points);
        if self.points.len() < 2 {
            check.report(too_few_points(name));
        } else if check.anchors(&self.points).len() < self.points.len() {
            if check.anchors(&self.points).len() > 2 {
                check.report(immovable_body(name));
            }
        } else {
            check.not_all_fixed(name, KIND, &self.points);
        }
        if let [first, second] = self.points.as_slice()
            && let Some(marker) = check.listing.markers_on(name).next()
        {
            let is_in_line = check.listing.body_in_line_with(marker).is_some();
            check.report(third_point_missing(
                name,
                [first, second],
                marker,
                is_in_line,
            ));
        }
        check.lengths_stated_once(self, earlier);
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        lowering.body(KIND, &self.named, &self.points);
    }

    fn rigid(&self) -> Option<Rigid<'_>> {
        Some(Rigid::Body(&self.points))
    }
}

fn too_few_points(name: &Ident) -> Error {
    errors::at(
        name,
        format!("body `{name}` needs two points or more; list them, or remove the body"),
    )
}

fn third_point_missing(
    name: &Ident,
    [first, second]: [&Ident; 2],
    marker: &Ident,
    is_in_line: bool,
) -> Error {
    let in_line = if is_in_line {
        let sliding = errors::sliding(marker, name, [first, second]);
        format!(
            ", or, as `{marker}` is in line with them, declare `{marker}` under `free:` and write `link {name}: {first} -> {second};` in place \
             of the body, {sliding}"
        )
    } else {
        String::new()
    };
    errors::at(
        name,
        format!(
            "body `{name}` has two points, `{first}` and `{second}`, and needs a third, not in line with these, to carry `{marker}`; list it{in_line}"
        ),
    )
}

fn immovable_body(name: &Ident) -> Error {
    errors::at(
        name,
        format!(
            "body `{name}` has three chassis points and cannot move; its other points are chassis \
             points too: declare them under `fixed:`"
        ),
    )
}

//! `point hub: plate;` or `point hub: c, d, e at [0.0, 0.7, 0.3];`: a marker that a body carries, or three
//! points, with or without a design position.

use syn::{Error, Ident};

use super::operands::names;
use super::points::position;
use super::word::{Head, Word};
use crate::errors;
use crate::kind::Kind;
use crate::listing::{Check, Listing, Lowering, Named, Rank, Statement};
use crate::name::Name;
use crate::system;
use crate::vector::Vector;

pub(crate) const POINT: Word = Word {
    word: "point",
    syntax: "point hub: plate at [0.0, 0.7, 0.3];",
    read: |head: Head, input, listing| {
        let marker = Marker {
            named: head.named(input)?,
            carriers: names(input)?,
            at: position(input)?,
        };
        listing.statements.push(Box::new(marker));
        Ok(())
    },
};

struct Marker {
    named: Named,
    carriers: Vec<Ident>,
    at: Option<Vector>,
}

impl Statement for Marker {
    fn named(&self) -> Option<(&Named, Kind)> {
        Some((&self.named, Kind::MARKER))
    }

    fn operands(&self) -> Vec<&Ident> {
        self.carriers.iter().collect()
    }

    fn check(&self, check: &mut Check<'_>, _earlier: &[Box<dyn Statement>]) {
        match self.carriers.as_slice() {
            // What is missing in a body is reported at the body.
            [body] if check.listing.body(body).is_some() => {}
            [_, _, _] => check.sites(&self.carriers),
            _ => check.report_missing(self.bad_carriers(check.listing)),
        }
    }

    fn rank(&self) -> Rank {
        Rank::Reading
    }

    fn lower(&self, lowering: &mut Lowering<'_>) {
        let frame = match self.carriers.as_slice() {
            [a, b, c] => [a, b, c].map(|point| lowering.site(point)),
            [body] => match lowering.body_named(&Name::from(body)) {
                Some(body) => body.frame.clone(),
                None => return,
            },
            _ => return,
        };
        lowering.system.markers.push(system::Marker {
            named: self.named.plain(),
            frame,
            at: self.at,
        });
    }

    fn carriers(&self) -> Option<&[Ident]> {
        Some(&self.carriers)
    }

    fn at(&self) -> Option<Vector> {
        self.at
    }
}

impl Marker {
    fn bad_carriers(&self, listing: &Listing) -> Error {
        let marker = &self.named.name;
        let message = match self.carriers.as_slice() {
            [one] => match listing.ends_of_link(one) {
                Some(ends) => describe_point_on_link(marker, one, ends),
                None => no_body(marker, one, listing),
            },
            carriers => format!(
                "`{marker}` is carried by one body or by three points; {} names are given",
                carriers.len()
            ),
        };
        errors::at(self.carriers.first().unwrap_or(marker), message)
    }
}

fn no_body(marker: &Ident, name: &Ident, listing: &Listing) -> String {
    let hint = errors::did_you_mean_name(name, listing.bodies().map(|(body, _)| body));
    format!(
        "there is no body `{name}` to carry `{marker}`; state it as a `body` or a `hinge`, or name three points that carry `{marker}`{hint}"
    )
}

/// The remedy for a point on a link.
fn describe_point_on_link(marker: &Ident, link: &Ident, [from, to]: &[Ident; 2]) -> String {
    format!(
        "`{link}` is a link, which carries no point; declare `{marker}` under `free:`, and write {}; the position of `{marker}` must lie on \
         the line of the link",
        errors::sliding(marker, link, [from, to])
    )
}

//! A check that the lengths that an angle needs are kept, and that a length that a drive prescribes is not.

use syn::{Error, Ident};

use crate::errors;
use crate::kind::Kind;
use crate::listing::Listing;
use crate::name::Name;
use crate::system::{Body, System, distance_between};

/// The mistake in an angle: an equation must keep the distance between its two points.
pub(super) fn angle(line: &[Ident; 2], listing: &Listing, system: &System) -> Option<Error> {
    let [from, to] = line;
    // Anything else is reported as an operand.
    let is = |name: &Ident, kind| listing.declared().any(|other| other == (name, kind));
    let ends = [from, to].map(|end| (is(end, Kind::FREE_POINT), is(end, Kind::CHASSIS_POINT)));
    let [(free, _), (other_free, _)] = ends;
    let all_known = ends.iter().all(|(free, fixed)| *free || *fixed);
    if from == to || !all_known || !(free || other_free) {
        return None;
    }
    let [a, b] = [from, to].map(Name::from);
    if distance_between(&system.equations, &a, &b).is_some() {
        return None;
    }
    Some(match system.body_of(line) {
        Some(body) => angle_beside_frame([from, to], body),
        None => no_such_link(from, to),
    })
}

/// The mistake in a driven length: nothing may keep it.
pub(super) fn length(line: &[Ident; 2], system: &System) -> Option<Error> {
    let [from, to] = line;
    let [a, b] = [from, to].map(Name::from);
    let equation = distance_between(&system.equations, &a, &b);
    let keeper = equation.or_else(|| Some(&system.body_of(line)?.name))?;
    (from != to).then(|| kept_already(from, to, keeper))
}

fn kept_already(from: &Ident, to: &Ident, keeper: &Name) -> Error {
    errors::at(
        from,
        format!(
            "`{keeper}` keeps the distance of `{from}` and `{to}`, and no drive can change it; remove \
             `{keeper}` or the drive"
        ),
    )
}

fn no_such_link(from: &Ident, to: &Ident) -> Error {
    errors::at(
        from,
        format!(
            "an angle needs the length of a link, and no link joins `{from}` and `{to}`; declare \
             `link name: {from} -> {to};`"
        ),
    )
}

/// The error that the distance between two points of a body is not an edge of its frame.
fn angle_beside_frame(ends: [&Ident; 2], body: &Body) -> Error {
    let [from, to] = ends;
    let Body { name, frame, .. } = body;
    let [a, b, c] = frame.each_ref().map(|site| &site.name);
    // A frame takes chassis points first, wherever they are listed.
    let anchors = frame.iter().filter(|site| !site.is_free());
    let anchors: Vec<&Name> = anchors.map(|site| &site.name).collect();
    let is_other = |end: &&&Ident| !anchors.contains(&&Name::from(**end));
    let others = ends.iter().filter(is_other).count();
    let remedy = if anchors.len() + others > 3 {
        String::new()
    } else {
        format!(", or list `{from}` and `{to}` among the first three points of the body")
    };
    errors::at(
        from,
        format!(
            "an angle needs a length that an equation keeps, and body `{name}` keeps those between \
             `{a}`, `{b}` and `{c}`; drive the angle between two of these{remedy}"
        ),
    )
}

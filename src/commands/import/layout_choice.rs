//! The choice of the layout for a file: the one that uses most of its points and lacks none.

mod candidate;
mod misfit;

use std::cmp::Reverse;
use std::collections::BTreeMap;
use std::ops::Deref;

use suspension_runtime::catalogue;

use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use super::rack::{self, RACK};
use super::upper_wishbone::{on_upper, point_on_upper};
use candidate::Candidate;
use misfit::Given;

/// The most missing points of a layout that the file may well be meant for.
const FEW: usize = 2;

/// A chosen listing: a candidate that lacks no points but those that are computed from others.
#[derive(Debug)]
pub(super) struct Choice<'a> {
    candidate: Candidate<'a>,
    /// The text of the listing, with the changes that the file asks for.
    pub(super) text: String,
    /// Whether there are such changes.
    pub(super) is_changed: bool,
    /// Why the inner end of the tie rod does not steer, in a layout with a rack; its drive is then not in `text`.
    pub(super) fixed: Option<String>,
    /// A layout that would use more points of the file, and the points that it lacks.
    pub(super) larger: Option<String>,
    /// The point that is on the upper wishbone, where the catalogue's listing has it on the lower one.
    pub(super) upper: Option<&'static str>,
}

impl<'a> Deref for Choice<'a> {
    type Target = Candidate<'a>;

    fn deref(&self) -> &Candidate<'a> {
        &self.candidate
    }
}

impl<'a> Choice<'a> {
    fn new(candidate: Candidate<'a>, larger: Option<String>, stated: &Hardpoints<'_>) -> Self {
        let fixed = candidate.point(RACK);
        let fixed = fixed.and_then(|inner| rack::why_fixed(inner, stated));
        let layout = candidate.layout.text;
        let upper = point_on_upper(layout, |name| candidate.point(name));
        let mut text = layout.to_owned();
        if fixed.is_some() {
            text = rack::fixed(&text);
        }
        if upper.is_some() {
            text = on_upper(&text);
        }
        Self {
            candidate,
            text,
            is_changed: fixed.is_some() || upper.is_some(),
            fixed,
            larger,
            upper,
        }
    }

    /// Returns the name of the layout.
    pub(super) fn linkage(&self) -> &'static str {
        self.layout.name
    }

    /// Returns the points that are not on the axis of the wheel, each with its name in the listing.
    pub(super) fn off_axis(&self) -> impl Iterator<Item = (&str, &'a Hardpoint)> + Clone {
        let found = self.found.iter().map(|(name, point)| (&**name, *point));
        found.filter(|(name, _)| !["wheel_centre", "axle"].contains(name))
    }
}

/// Returns the listing that the user names, or else the one that uses most of the points.
///
/// # Errors
///
/// A sentence that names the missing points, or the listings that use equally many.
pub(super) fn choose<'a>(
    stated: &Hardpoints<'_>,
    points: &[&'a Hardpoint],
    names: &'a Names,
    wanted: Option<&str>,
) -> Result<Choice<'a>, String> {
    let mut candidates = candidates(points, names, wanted).into_iter();
    let Some(best) = candidates.next() else {
        return Err(catalogue::unknown(wanted.unwrap_or_default(), ""));
    };
    let given = Given {
        stated,
        points,
        names,
    };
    if let Some(why) = best.does_not_fit(candidates.as_slice(), given, wanted) {
        return Err(why);
    }
    match candidates.next() {
        Some(other)
            if other.missing.is_empty()
                && other.found.len() == best.found.len()
                && other.spare.len() == best.spare.len() =>
        {
            Err(format!(
                "the points are those of {} and of {}: say which with --linkage",
                best.layout.name, other.layout.name
            ))
        }
        other => {
            let others = other.into_iter().chain(candidates);
            let larger = larger(others, &best).map(|larger| larger.beside(&best, given));
            Ok(Choice::new(best, larger, stated))
        }
    }
}

/// Returns the candidate that uses most of the points, if these are more than the best one uses and few others are missing.
fn larger<'a>(
    others: impl Iterator<Item = Candidate<'a>>,
    best: &Candidate<'_>,
) -> Option<Candidate<'a>> {
    let larger = others.filter(|other| other.found.len() > best.found.len());
    let larger = larger.filter(|other| other.needed().len() <= FEW);
    larger.max_by_key(|other| (other.found.len(), Reverse(other.needed().len())))
}

/// Returns how much the layout nearest to some points lacks: first whether none of its points is among them, then how many are
/// missing, then how many there are.
pub(super) fn lacking(
    points: &[&Hardpoint],
    names: &Names,
    wanted: Option<&str>,
) -> Option<(bool, usize, Reverse<usize>)> {
    let candidates = candidates(points, names, wanted);
    candidates.first().map(|nearest| {
        let found = nearest.found.len();
        (found == 0, nearest.needed().len(), Reverse(found))
    })
}

/// Returns the layouts, or the one that the user names, with the points of a file; the nearest one is the first.
fn candidates<'a>(
    points: &[&'a Hardpoint],
    names: &'a Names,
    wanted: Option<&str>,
) -> Vec<Candidate<'a>> {
    let layouts = names.layouts.iter();
    let layouts = layouts.filter(|layout| wanted.is_none_or(|wanted| wanted == layout.name));
    // Points of one name are in one place, or the candidate refuses them: the first is taken.
    let by_form = points
        .iter()
        .rev()
        .map(|point| (names.normal(&point.key), *point));
    let by_form: BTreeMap<String, &Hardpoint> = by_form.collect();
    let candidates = layouts.map(|layout| Candidate::new(layout, &by_form, names));
    let mut candidates: Vec<Candidate<'a>> = candidates.collect();
    candidates.sort_by_cached_key(|candidate| {
        let (found, needed) = (candidate.found.len(), candidate.needed().len());
        // Of two listings with equally many points, prefer the one that states its spin axis.
        (
            found == 0,
            needed,
            Reverse(found),
            Reverse(candidate.spare.len()),
        )
    });
    candidates
}

//! The choice of the layout for a file: the one that uses most of its points and lacks none.

use std::cmp::Reverse;

use suspension_core::linkages::LISTINGS;
use suspension_listing::did_you_mean::nearest;
use suspension_listing::text;
use suspension_runtime::{CatalogueAndFiles, Listing, Mistakes, catalogue};

use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::{MOST_NAMES, Names, and_more, is_same};
use super::stand_in::has_stand_in;

/// The most names that a message gives for a missing point.
const FEW_NAMES: usize = 4;

/// A chosen listing, with the points that the file has for it.
#[derive(Debug)]
pub(super) struct Choice<'a> {
    pub(super) linkage: &'static str,
    /// The text of the listing.
    pub(super) text: &'static str,
    pub(super) listing: Listing,
    /// The points that the file has, in the order of the listing, each with its name in the listing.
    pub(super) found: Vec<(String, &'a Hardpoint)>,
    /// Missing points that are computed from others.
    pub(super) spare: Vec<String>,
}

impl<'a> Choice<'a> {
    /// Returns the file's point for a point of the listing.
    pub(super) fn point(&self, name: &str) -> Option<&'a Hardpoint> {
        let mut found = self.found.iter();
        found.find_map(|(other, point)| (other == name).then_some(*point))
    }
}

/// A listing that may be chosen, with the points that the file has for it.
#[derive(Debug)]
struct Candidate<'a> {
    linkage: &'static str,
    text: &'static str,
    /// As in [`Choice`].
    found: Vec<(String, &'a Hardpoint)>,
    spare: Vec<String>,
    /// The points that are missing.
    missing: Vec<String>,
}

impl<'a> Candidate<'a> {
    fn new(
        (linkage, text): (&'static str, &'static str),
        points: &[&'a Hardpoint],
        names: &Names,
    ) -> Result<Self, Mistakes> {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        let named = |name: &str| {
            let mut points = points.iter();
            points.find(|point| is_same(&point.key, name)).copied()
        };
        for name in points_of(linkage, text)? {
            let point = names.of_point(&name).find_map(named);
            match point {
                Some(point) => found.push((name, point)),
                None => missing.push(name),
            }
        }
        let has = |name: &str| found.iter().any(|(other, _)| other == name);
        let (spare, missing) = missing
            .into_iter()
            .partition(|name| has_stand_in(name, has));
        Ok(Self {
            linkage,
            text,
            found,
            spare,
            missing,
        })
    }

    fn chosen(self) -> Result<Choice<'a>, Mistakes> {
        Ok(Choice {
            linkage: self.linkage,
            text: self.text,
            listing: Listing::parse_file(self.text, self.linkage)?,
            found: self.found,
            spare: self.spare,
        })
    }

    /// Lists the missing points with the names that import knows for them, without those that can be placed from others.
    fn lacks(&self, names: &Names) -> String {
        let found = self.found.iter().map(|(name, _)| name);
        let with_missing: Vec<&String> = found.chain(&self.missing).collect();
        let has = |name: &str| with_missing.iter().any(|other| *other == name);
        let needed = self.missing.iter().filter(|name| !has_stand_in(name, has));
        let each = needed.map(|name| {
            let others: Vec<&str> = names.of_point(name).skip(1).collect();
            match others.as_slice() {
                [] => format!("`{name}`"),
                others => {
                    let (first, more) = others.split_at(others.len().min(FEW_NAMES));
                    let mut first: Vec<String> = first.iter().map(ToString::to_string).collect();
                    first.extend(and_more(more.len()));
                    format!("`{name}` (or {})", first.join(", "))
                }
            }
        });
        each.collect::<Vec<_>>().join("; ")
    }

    /// Lists the unknown names of the file, each with the missing point that may have been meant.
    fn unknown(&self, points: &[&Hardpoint], names: &Names, stated: &Hardpoints<'_>) -> String {
        let missing = self.missing.iter();
        let wanted: Vec<&str> = missing.flat_map(|name| names.of_point(name)).collect();
        let is_found = |key: &str| self.found.iter().any(|(_, found)| found.key == key);
        let is_known = |key: &str| names.is_point(key) || is_found(key);
        let unknown = points.iter().filter(|point| !is_known(&point.key));
        let mut unknown = unknown.peekable();
        let told = unknown.by_ref().take(MOST_NAMES).map(|point| {
            let hint = nearest(&point.key, wanted.iter().copied());
            let hint = hint.map(|name| format!(", did you mean {name}?"));
            let line = stated.line(&point.place);
            format!("`{}` ({line}){}", point.name, hint.unwrap_or_default())
        });
        let mut each: Vec<String> = told.collect();
        each.extend(and_more(unknown.count()));
        match each.join("; ") {
            none if none.is_empty() => none,
            each => format!("; not known: {each}"),
        }
    }

    /// Says why the points do not suit the listing; `None` if they do.
    fn does_not_fit(
        &self,
        stated: &Hardpoints<'_>,
        points: &[&Hardpoint],
        names: &Names,
        wanted: Option<&str>,
    ) -> Option<String> {
        if self.found.is_empty() {
            let first = points.first().map_or("", |point| point.name.as_str());
            if points.iter().any(|point| names.is_point(&point.key)) {
                return Some(format!(
                    "{} has none of the file's points, `{first}` for one; without --linkage they choose the layout",
                    self.linkage
                ));
            }
            return Some(format!(
                "no point has a known name, for example `{first}` has none; suspension import --names lists the known names"
            ));
        }
        if !self.missing.is_empty() {
            let what = match wanted {
                Some(_) => format!("{} lacks", self.linkage),
                None => format!(
                    "no layout has all its points here; the nearest, {}, lacks",
                    self.linkage
                ),
            };
            let unknown = self.unknown(points, names, stated);
            let lacks = self.lacks(names);
            return Some(format!(
                "{what} {lacks}{unknown}; suspension import --names lists all names"
            ));
        }
        None
    }
}

/// Returns the names of a listing's points without the search for an order of elimination.
fn points_of(linkage: &str, text: &str) -> Result<Vec<String>, Mistakes> {
    let system = text::parse(text, linkage, &CatalogueAndFiles::beside(linkage))?;
    let points = system.fixed.iter().chain(&system.free);
    let points = points.map(|point| &point.named.name);
    let markers = system.markers.iter().map(|marker| &marker.named.name);
    Ok(points.chain(markers).map(ToString::to_string).collect())
}

/// Returns the listing that the user names, or else the one that uses most of the points.
///
/// # Errors
///
/// A sentence that names the missing points, or the listings that use equally many.
pub(super) fn choose<'a>(
    stated: &Hardpoints<'_>,
    points: &[&'a Hardpoint],
    names: &Names,
    wanted: Option<&str>,
) -> Result<Choice<'a>, String> {
    let listings = LISTINGS.iter();
    let listings = listings.filter(|(name, _)| wanted.is_none_or(|wanted| wanted == *name));
    let refuse = |mistakes: Mistakes| mistakes.to_string();
    let candidates = listings.map(|listing| Candidate::new(*listing, points, names));
    let candidates = candidates.collect::<Result<_, _>>();
    let mut candidates: Vec<Candidate<'a>> = candidates.map_err(refuse)?;
    candidates.sort_by_key(|candidate| {
        let (found, missing) = (candidate.found.len(), candidate.missing.len());
        // Of two listings with equally many points, prefer the one that states its spin axis.
        (
            found == 0,
            missing,
            Reverse(found),
            Reverse(candidate.spare.len()),
        )
    });
    let mut candidates = candidates.into_iter();
    let Some(best) = candidates.next() else {
        return Err(catalogue::unknown(wanted.unwrap_or_default(), ""));
    };
    if let Some(why) = best.does_not_fit(stated, points, names, wanted) {
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
                best.linkage, other.linkage
            ))
        }
        _ => best.chosen().map_err(refuse),
    }
}

/// Lists the names that import knows for the points of each layout, one line per point.
///
/// # Errors
///
/// The mistakes of a listing.
pub(super) fn known_names(names: &Names) -> Result<String, Mistakes> {
    let mut text = String::new();
    for (linkage, listing) in LISTINGS {
        text += &format!("{linkage}\n");
        for point in points_of(linkage, listing)? {
            let others: Vec<&str> = names.of_point(&point).skip(1).collect();
            let line = format!("  {point:18}{}", others.join(", "));
            text += &format!("{}\n", line.trim_end());
        }
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::super::names::spelled;
    use super::*;

    #[test]
    fn every_row_of_names_toml_has_a_catalogue_point_in_normal_spelling() {
        let names = Names::read().expect("a table");
        let listings = LISTINGS.iter();
        let points = listings.flat_map(|(linkage, text)| points_of(linkage, text).unwrap());
        let points: Vec<String> = points.collect();
        for (point, others) in &names.points {
            assert!(points.contains(point), "no listing has {point}");
            for name in others {
                assert_eq!(*name, spelled(name));
            }
        }
        let arrangement = &names.arrangement;
        let ordered = arrangement.ahead.iter().chain(&arrangement.above).flatten();
        for point in ordered.chain(arrangement.near.iter().flatten()) {
            assert!(points.contains(point), "no listing has {point}");
        }
    }
}

//! Which listing of the catalogue a file is of: the one that takes most of its points, and lacks none.

use suspension_core::linkages::LISTINGS;
use suspension_listing::did_you_mean::nearest;
use suspension_runtime::{Listing, Mistakes, catalogue};

use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use super::stand_in::has_stand_in;
use crate::load;

/// A listing, with the points of the file that are its own.
#[derive(Debug)]
pub(super) struct Choice<'a> {
    pub(super) linkage: &'static str,
    /// The text of the listing.
    pub(super) text: &'static str,
    pub(super) listing: Listing,
    /// The points that the file has, in the order of the listing, each with its name there.
    pub(super) found: Vec<(String, &'a Hardpoint)>,
    /// The points that others of the file determine.
    pub(super) spare: Vec<String>,
    /// The points that are missing.
    missing: Vec<String>,
}

impl<'a> Choice<'a> {
    fn of(
        (linkage, text): (&'static str, &'static str),
        points: &[&'a Hardpoint],
        names: &Names,
    ) -> Result<Self, Mistakes> {
        let listing = Listing::parse_file(text, linkage)?;
        let mut choice = Self {
            linkage,
            text,
            found: Vec::new(),
            spare: Vec::new(),
            missing: Vec::new(),
            listing,
        };
        let named = |name: &str| points.iter().find(|point| point.key == name).copied();
        for name in load::points(&choice.listing) {
            let found = names.of_point(name).find_map(named);
            match found {
                Some(point) => choice.found.push((name.to_owned(), point)),
                None => choice.missing.push(name.to_owned()),
            }
        }
        let has = |name: &str| choice.found.iter().any(|(other, _)| other == name);
        (choice.spare, choice.missing) = choice
            .missing
            .into_iter()
            .partition(|name| has_stand_in(name, has));
        Ok(choice)
    }

    /// The point of the file that is one of the listing.
    pub(super) fn point(&self, name: &str) -> Option<&'a Hardpoint> {
        let mut found = self.found.iter();
        found.find_map(|(other, point)| (other == name).then_some(*point))
    }

    /// The points that are missing, with the names that would do.
    fn lacks(&self, names: &Names) -> String {
        let each = self.missing.iter().map(|name| {
            let others: Vec<&str> = names.of_point(name).skip(1).collect();
            match others.as_slice() {
                [] => format!("`{name}`"),
                others => format!("`{name}` (or {})", others.join(", ")),
            }
        });
        each.collect::<Vec<_>>().join("; ")
    }

    /// The names of the file that are not known, each with the one of a missing point that may have been meant.
    fn unknown(&self, points: &[&Hardpoint], names: &Names, stated: &Hardpoints<'_>) -> String {
        let missing = self.missing.iter();
        let wanted: Vec<&str> = missing.flat_map(|name| names.of_point(name)).collect();
        let is_found = |key: &str| self.found.iter().any(|(_, found)| found.key == key);
        let is_known = |key: &str| names.is_point(key) || is_found(key);
        let unknown = points.iter().filter(|point| !is_known(&point.key));
        let each = unknown.map(|point| {
            let hint = nearest(&point.key, wanted.iter().copied());
            let hint = hint.map(|name| format!(", did you mean {name}?"));
            let line = stated.line(&point.place);
            format!("`{}` ({line}){}", point.name, hint.unwrap_or_default())
        });
        match each.collect::<Vec<_>>().join("; ") {
            none if none.is_empty() => none,
            each => format!("; not known: {each}"),
        }
    }
}

/// The listing that is wanted, or else the one that takes most of the points.
///
/// # Errors
///
/// What is missing, or that several listings take as many, in words.
pub(super) fn choose<'a>(
    stated: &Hardpoints<'_>,
    points: &[&'a Hardpoint],
    names: &Names,
    wanted: Option<&str>,
) -> Result<Choice<'a>, String> {
    let listings = LISTINGS.iter();
    let listings = listings.filter(|(name, _)| wanted.is_none_or(|wanted| wanted == *name));
    let choices = listings.map(|listing| Choice::of(*listing, points, names));
    let choices = choices.collect::<Result<_, _>>();
    let mut choices: Vec<Choice<'a>> = choices.map_err(|mistakes| mistakes.to_string())?;
    choices.sort_by_key(|choice| {
        let (found, missing) = (choice.found.len(), choice.missing.len());
        (found == 0, missing, usize::MAX - found)
    });
    let mut choices = choices.into_iter();
    let Some(best) = choices.next() else {
        return Err(catalogue::unknown(wanted.unwrap_or_default(), ""));
    };
    if best.found.is_empty() {
        let first = points.first().map_or("", |point| point.name.as_str());
        return Err(format!(
            "no name of a point is known, `{first}` for one; suspension import --names lists those that are"
        ));
    }
    if !best.missing.is_empty() {
        let what = match wanted {
            Some(_) => format!("{} lacks", best.linkage),
            None => format!(
                "no layout has all its points here; the nearest, {}, lacks",
                best.linkage
            ),
        };
        let unknown = best.unknown(points, names, stated);
        return Err(format!("{what} {}{unknown}", best.lacks(names)));
    }
    match choices.next() {
        Some(other) if other.missing.is_empty() && other.found.len() == best.found.len() => {
            Err(format!(
                "the points are those of {} and of {}: say which with --linkage",
                best.linkage, other.linkage
            ))
        }
        _ => Ok(best),
    }
}

/// The names by which the points of each listing are known, a line each.
///
/// # Errors
///
/// The mistakes of a listing.
pub(super) fn known_names(names: &Names) -> Result<String, Mistakes> {
    let mut text = String::new();
    for (linkage, listing) in LISTINGS {
        text += &format!("{linkage}\n");
        for point in load::points(&Listing::parse_file(listing, linkage)?) {
            let others: Vec<&str> = names.of_point(point).skip(1).collect();
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
    fn every_row_is_of_a_point_of_the_catalogue_in_the_spelling_that_is_compared() {
        let names = Names::read().expect("a table");
        let listings = LISTINGS.iter().map(|(_, text)| Listing::parse(text));
        let points: Vec<String> = listings
            .flat_map(|listing| {
                load::points(&listing.unwrap())
                    .map(str::to_owned)
                    .collect::<Vec<_>>()
            })
            .collect();
        for (point, others) in &names.points {
            assert!(points.contains(point), "no listing has {point}");
            for name in others {
                assert_eq!(*name, spelled(name));
            }
        }
        let order = &names.order;
        let ordered = order.ahead.iter().chain(&order.above).flatten();
        for point in ordered.chain(order.near.iter().flatten()) {
            assert!(points.contains(point), "no listing has {point}");
        }
    }
}

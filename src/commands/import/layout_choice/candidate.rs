//! A layout that may be chosen for a file, and why its points do not suit the layout.

use std::collections::BTreeMap;

use super::is_used;
use crate::commands::import::hardpoints::{Hardpoint, Hardpoints};
use crate::commands::import::layout::Layout;
use crate::commands::import::names::{MOST_NAMES, Names, and_more};
use crate::commands::import::stand_in::has_stand_in;

/// The most names that a message gives for a missing point.
const FEW_NAMES: usize = 4;

/// Words of the names of points at a rocker, a point of its axis in all layouts that have one, and the outer end of a damper in
/// layouts that have none.
const OF_ROCKER: [&str; 3] = ["rocker", "pushrod", "pullrod"];
const ROCKER: &str = "rocker_front";
const DAMPER: &str = "damper_lower";

/// Pairs of points that state nothing but the axis of a part.
const AXES: [[&str; 2]; 3] = [
    ["rocker_front", "rocker_rear"],
    ["crank_front", "crank_rear"],
    ["pivot_inner", "pivot_outer"],
];

/// A listing that may be chosen, with the points that the file has for it.
#[derive(Debug)]
pub(super) struct Candidate<'a> {
    pub(super) layout: &'a Layout,
    /// The points that the file has, each with its name in the listing.
    pub(super) found: Vec<(String, &'a Hardpoint)>,
    /// Missing points that are computed from others.
    pub(super) spare: Vec<String>,
    /// The other missing points.
    pub(super) missing: Vec<String>,
}

impl<'a> Candidate<'a> {
    /// The layout with the points that the file has for it, given by the forms of their names.
    pub(super) fn new(
        layout: &'a Layout,
        by_form: &BTreeMap<String, &'a Hardpoint>,
        names: &Names,
    ) -> Self {
        let (mut found, mut missing) = (Vec::new(), Vec::new());
        for name in layout.points.iter().cloned() {
            let mut forms = names.forms_of(&name).iter();
            let point = forms.find_map(|form| by_form.get(form)).copied();
            match point {
                Some(point) => found.push((name, point)),
                None => missing.push(name),
            }
        }
        let has = |name: &str| found.iter().any(|(other, _)| other == name);
        let (spare, missing) = missing
            .into_iter()
            .partition(|name| has_stand_in(name, layout.text, has));
        Self {
            layout,
            found,
            spare,
            missing,
        }
    }

    /// Returns the missing points that cannot be placed from the others.
    pub(super) fn needed(&self) -> Vec<&str> {
        let found = self.found.iter().map(|(name, _)| name);
        let with_missing: Vec<&String> = found.chain(&self.missing).collect();
        let has = |name: &str| with_missing.iter().any(|other| *other == name);
        let missing = self.missing.iter().map(String::as_str);
        missing
            .filter(|name| !has_stand_in(name, self.layout.text, has))
            .collect()
    }

    /// Says how many more points of the file than another one this layout uses, and what it lacks.
    pub(super) fn in_words(&self, other: &Self, names: &Names, stated: &Hardpoints<'_>) -> String {
        let more = self.found.len() - other.found.len();
        let lacks = self.lacks(names, stated);
        let linkage = self.layout.name;
        format!("{linkage} would use {more} more of the points, but lacks {lacks}")
    }

    /// Lists the needed points with the names that import knows for them.
    fn lacks(&self, names: &Names, stated: &Hardpoints<'_>) -> String {
        let each = self.needed().into_iter().map(|name| {
            if let Some(other) = of_other_corner(name, names, stated) {
                return format!("`{name}`{other}");
            }
            let others: Vec<&str> = names.of_point(name).skip(1).collect();
            let (first, more) = others.split_at(others.len().min(FEW_NAMES));
            let mut first: Vec<String> = first.iter().map(ToString::to_string).collect();
            first.extend(and_more(more.len()));
            let or = match first.as_slice() {
                [] => String::new(),
                others => format!(" (or {})", others.join(", ")),
            };
            format!("`{name}`{or}{}", self.of_axis(name).unwrap_or_default())
        });
        each.collect::<Vec<_>>().join("; ")
    }

    /// Says that a missing point may be any one of an axis of which another point is found.
    fn of_axis(&self, name: &str) -> Option<String> {
        let other = AXES.iter().find_map(|[one, other]| {
            (name == *one)
                .then_some(other)
                .or((name == *other).then_some(one))
        })?;
        let mut found = self.found.iter();
        let (_, found) = found.find(|(found, _)| found == other)?;
        Some(format!(
            ": any second point of the axis through `{}` will do",
            found.name
        ))
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
            let hint = names.meant(&point.key, wanted.clone());
            let hint = hint.map(|name| format!(", did you mean {name}?"));
            stated.quoted(point) + &hint.unwrap_or_default()
        });
        let mut each: Vec<String> = told.collect();
        each.extend(and_more(unknown.count()));
        match each.join("; ") {
            none if none.is_empty() => none,
            each => format!("; not known: {each}"),
        }
    }

    /// Lists the points of the file that other layouts have.
    fn of_others(&self, points: &[&Hardpoint], names: &Names, stated: &Hardpoints<'_>) -> String {
        let is_of_other = |point: &&&Hardpoint| names.is_point(&point.key) && !self.uses(point);
        let others = points.iter().filter(is_of_other);
        let mut each: Vec<String> = others.map(|point| stated.quoted(point)).collect();
        // A row with a point of each side.
        each.dedup();
        if each.is_empty() {
            return String::new();
        }
        let more = each.len().saturating_sub(FEW_NAMES);
        each.truncate(FEW_NAMES);
        each.extend(and_more(more));
        format!("; of other layouts: {}", each.join(", "))
    }

    fn uses(&self, point: &Hardpoint) -> bool {
        is_used(&self.found, point)
    }

    /// Names two points of the file that have names of one point of the listing and are in different places.
    fn named_twice(
        &self,
        stated: &Hardpoints<'_>,
        points: &[&Hardpoint],
        names: &Names,
    ) -> Option<String> {
        let is_unused = |point: &&&Hardpoint| names.is_point(&point.key) && !self.uses(point);
        let unused: Vec<&&Hardpoint> = points.iter().filter(is_unused).collect();
        self.found.iter().find_map(|(name, taken)| {
            let forms = names.forms_of(name);
            let mut others = unused.iter().filter(|point| point.at != taken.at);
            let other = others.find(|other| forms.contains(&names.normal(&other.key)))?;
            let [other, taken] = [**other, *taken].map(|point| stated.quoted(point));
            Some(format!(
                "{other} and {taken} are names of one point, {name}, in different places: leave one of them, or give the other a \
                 name that import does not know"
            ))
        })
    }

    /// Names a point of a rocker, if the listing has a damper but no rocker: the damper of such a file ends at the rocker.
    fn unused_rocker(
        &self,
        stated: &Hardpoints<'_>,
        points: &[&Hardpoint],
        names: &Names,
    ) -> Option<String> {
        let has = |name: &str| self.found.iter().any(|(found, _)| found == name);
        let is_of_rocker = |point: &&&Hardpoint| {
            let form = names.normal(&point.key);
            form.split('_').any(|word| OF_ROCKER.contains(&word))
        };
        let rocker = points.iter().find(is_of_rocker)?;
        (has(DAMPER) && !has(ROCKER)).then(|| {
            format!(
                "the damper would end at a wishbone or knuckle, but {} is of a rocker: --linkage double_wishbone_rocker says \
                 which points are missing, for example the ends of the rocker's axis, `Rocker front` and `Rocker rear`; leave out \
                 all points of the rocker and its rod if the damper does not end at it",
                stated.quoted(rocker)
            )
        })
    }

    /// Says why the points do not suit the listing, the nearest one; `None` if they do.
    pub(super) fn does_not_fit(
        &self,
        others: &[Self],
        stated: &Hardpoints<'_>,
        points: &[&Hardpoint],
        names: &Names,
        wanted: Option<&str>,
    ) -> Option<String> {
        let linkage = self.layout.name;
        if self.found.is_empty() {
            let first = points.first().map_or("", |point| point.name.as_str());
            let is_known = points.iter().any(|point| names.is_point(&point.key));
            return Some(match is_known {
                true => format!(
                    "{linkage} has none of the file's points, `{first}` for one; without --linkage they choose the layout"
                ),
                false => format!(
                    "no point has a known name, for example `{first}` has none; suspension import --names lists the known names"
                ),
            });
        }
        if self.missing.is_empty() {
            let twice = self.named_twice(stated, points, names);
            return twice.or_else(|| self.unused_rocker(stated, points, names));
        }
        let (lacks, unknown) = (
            self.lacks(names, stated),
            self.unknown(points, names, stated),
        );
        // The user may name a layout that leaves points of the file out.
        let (what, of_others) = match wanted {
            Some(_) => (format!("{linkage} lacks"), String::new()),
            None => {
                let has_half = |each: &Self| each.found.len() >= each.needed().len();
                let none = match has_half(self) || others.iter().any(has_half) {
                    true => "no layout has all its points here",
                    false => {
                        "no layout has half of its points here under known names; a suspension of another kind needs a listing of its own, see \
                         suspension motion --help"
                    }
                };
                (
                    format!("{none}; the nearest, {linkage}, lacks"),
                    self.of_others(points, names, stated),
                )
            }
        };
        Some(format!(
            "{what} {lacks}{unknown}{of_others}; suspension import --names lists all names, suspension list {linkage} says what the points \
             are"
        ))
    }
}

/// Says that the file has a missing point in the other corner.
fn of_other_corner(name: &str, names: &Names, stated: &Hardpoints<'_>) -> Option<String> {
    let forms = names.forms_of(name);
    let mut points = stated.points.iter();
    let point = points.find(|point| forms.contains(&names.normal(&point.key)))?;
    let (corner, line) = (point.side?.name(), stated.line(&point.place));
    Some(format!(
        ", which only the {corner} corner has (`{}`, {line})",
        point.name
    ))
}

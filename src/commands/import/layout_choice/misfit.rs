//! Why the points of a file do not suit a layout.

use super::candidate::Candidate;
use crate::commands::import::hardpoints::{Hardpoint, Hardpoints};
use crate::commands::import::listed::{MOST_NAMES, listed};
use crate::commands::import::names::Names;

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

/// A file, its points for a corner, and the names that import knows.
#[derive(Clone, Copy)]
pub(super) struct Given<'g> {
    pub(super) stated: &'g Hardpoints<'g>,
    pub(super) points: &'g [&'g Hardpoint],
    pub(super) names: &'g Names,
}

impl Given<'_> {
    fn is_known(&self, point: &Hardpoint) -> bool {
        self.names.is_point(&point.key)
    }

    /// Says that the file has a missing point in the other corner.
    fn of_other_corner(&self, name: &str) -> Option<String> {
        let Self { stated, names, .. } = self;
        let mut points = stated.points.iter();
        let point = points.find(|point| names.is_of_point(name, &point.key))?;
        let (corner, line) = (point.side?.name(), stated.line(&point.place));
        Some(format!(
            ", which only the {corner} corner has (`{}`, {line})",
            point.name
        ))
    }
}

impl Candidate<'_> {
    /// Says why the points do not suit the listing, the nearest one; `None` if they do.
    pub(super) fn does_not_fit(
        &self,
        others: &[Self],
        given: Given<'_>,
        wanted: Option<&str>,
    ) -> Option<String> {
        let linkage = self.layout.name;
        if self.found.is_empty() {
            let first = given.points.first().map_or("", |point| point.name.as_str());
            let mut points = given.points.iter();
            return Some(match points.any(|point| given.is_known(point)) {
                true => format!(
                    "{linkage} has none of the file's points, `{first}` for one; without --linkage they choose the layout"
                ),
                false => format!(
                    "no point has a known name, for example `{first}` has none; suspension import --names lists the known names"
                ),
            });
        }
        if self.missing.is_empty() {
            return self
                .named_twice(given)
                .or_else(|| self.unused_rocker(given));
        }
        let (lacks, unknown) = (self.lacks(given), self.unknown(given));
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
                    self.of_others(given),
                )
            }
        };
        Some(format!(
            "{what} {lacks}{unknown}{of_others}; suspension import --names lists all names, suspension list {linkage} says what the points \
             are"
        ))
    }

    /// Says how many more points of the file than another one this layout uses, and what it lacks.
    pub(super) fn beside(&self, other: &Self, given: Given<'_>) -> String {
        let more = self.found.len() - other.found.len();
        let (linkage, lacks) = (self.layout.name, self.lacks(given));
        format!("{linkage} would use {more} more of the points, but lacks {lacks}")
    }

    /// Lists the needed points with the names that import knows for them.
    fn lacks(&self, given: Given<'_>) -> String {
        let each = self.needed().into_iter().map(|name| {
            if let Some(other) = given.of_other_corner(name) {
                return format!("`{name}`{other}");
            }
            let others = given.names.of_point(name).skip(1);
            let others = listed(others, (FEW_NAMES, ", "), str::to_owned);
            let or = others.map(|others| format!(" (or {others})"));
            let of_axis = self.of_axis(name);
            format!(
                "`{name}`{}{}",
                or.unwrap_or_default(),
                of_axis.unwrap_or_default()
            )
        });
        each.collect::<Vec<_>>().join("; ")
    }

    /// Says that a missing point may be any one of an axis of which another point is found.
    fn of_axis(&self, name: &str) -> Option<String> {
        let axis = AXES.iter().find(|axis| axis.contains(&name))?;
        let found = axis.iter().find_map(|point| self.point(point))?;
        Some(format!(
            ": any second point of the axis through `{}` will do",
            found.name
        ))
    }

    /// Lists the unknown names of the file, each with the missing point that may have been meant.
    fn unknown(&self, given: Given<'_>) -> String {
        let Given { stated, names, .. } = given;
        let missing = self.missing.iter();
        let wanted: Vec<&str> = missing.flat_map(|name| names.of_point(name)).collect();
        let is_found = |key: &str| self.found.iter().any(|(_, found)| found.key == key);
        let unknown = given.points.iter();
        let unknown = unknown.filter(|point| !given.is_known(point) && !is_found(&point.key));
        let unknown = listed(unknown, (MOST_NAMES, "; "), |point| {
            stated.quoted(point) + &hint(names, point, wanted.clone())
        });
        unknown.map_or_else(String::new, |each| format!("; not known: {each}"))
    }

    /// Lists the points of the file that other layouts have.
    fn of_others(&self, given: Given<'_>) -> String {
        let others = self.unused(given);
        let mut each: Vec<String> = others.map(|point| given.stated.quoted(point)).collect();
        // A row with a point of each side.
        each.dedup();
        let others = listed(each.into_iter(), (FEW_NAMES, ", "), |point| point);
        others.map_or_else(String::new, |each| format!("; of other layouts: {each}"))
    }

    /// The points of the file that have a known name and are not among those of this layout.
    fn unused<'g>(&self, given: Given<'g>) -> impl Iterator<Item = &'g Hardpoint> {
        let points = given.points.iter().copied();
        points.filter(move |point| given.is_known(point) && !self.uses(point))
    }

    /// Names two points of the file that have names of one point of the listing and are in different places.
    fn named_twice(&self, given: Given<'_>) -> Option<String> {
        let unused: Vec<&Hardpoint> = self.unused(given).collect();
        self.found.iter().find_map(|(name, taken)| {
            let mut others = unused.iter().filter(|point| point.at != taken.at);
            let other = others.find(|other| given.names.is_of_point(name, &other.key))?;
            let [other, taken] = [*other, *taken].map(|point| given.stated.quoted(point));
            Some(format!(
                "{other} and {taken} are names of one point, {name}, in different places: leave one of them, or give the other a \
                 name that import does not know"
            ))
        })
    }

    /// Names a point of a rocker, if the listing has a damper but no rocker: the damper of such a file ends at the rocker.
    fn unused_rocker(&self, given: Given<'_>) -> Option<String> {
        let is_of_rocker = |point: &&&Hardpoint| {
            let form = given.names.normal(&point.key);
            form.split('_').any(|word| OF_ROCKER.contains(&word))
        };
        let rocker = given.points.iter().find(is_of_rocker)?;
        let ends_at_rocker = self.point(DAMPER).is_some() && self.point(ROCKER).is_none();
        ends_at_rocker.then(|| {
            format!(
                "the damper would end at a wishbone or knuckle, but {} is of a rocker: --linkage double_wishbone_rocker says \
                 which points are missing, for example the ends of the rocker's axis, `Rocker front` and `Rocker rear`; leave out \
                 all points of the rocker and its rod if the damper does not end at it",
                given.stated.quoted(rocker)
            )
        })
    }
}

/// Says what an unknown name may have been meant to be.
fn hint(names: &Names, point: &Hardpoint, wanted: Vec<&str>) -> String {
    if let Some([code, end]) = names.code_meant(&point.key) {
        let code = code.to_uppercase();
        return format!(
            ", where `{code}` is a corner's code: write `{end}` if the {end} of the part is meant"
        );
    }
    let meant = names.meant(&point.key, wanted);
    meant.map_or_else(String::new, |name| format!(", did you mean {name}?"))
}

//! What a file has of a corner.

use super::choice::Choice;
use super::corner::Corner;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use super::orientation::Orientation;
use super::stand_in::{Spin, stand_in};
use crate::load;
use crate::mechanism::Length;

/// What was found of a corner.
pub(super) struct Imported<'a> {
    pub(super) stated: &'a Hardpoints<'a>,
    pub(super) names: &'a Names,
    /// Those of the corner, and those of no side.
    pub(super) points: Vec<&'a Hardpoint>,
    pub(super) choice: Choice<'a>,
    pub(super) orientation: Orientation,
    pub(super) corner: Corner,
    /// The unit that the user states.
    pub(super) unit: Option<Length>,
    /// What is to be said beside what was assumed of the corner, a sentence each.
    pub(super) said: Vec<String>,
}

/// What a file has of the other side.
pub(super) enum Other {
    /// Not all of its points.
    Missing,
    /// The mirror image.
    Image,
    /// Another suspension, at this point for one.
    Unlike(String),
}

/// How far points may be off a mirror image, as a part of the suspension's size: as files are rounded.
const ROUNDING: f64 = 1e-6;

impl Other {
    /// What the user is to know of it.
    pub(super) fn said(&self, is_axle: bool) -> Option<String> {
        match self {
            Self::Image if !is_axle => Some(
                "the right corner is the mirror image of the left one; --axle makes an axle of both".to_owned(),
            ),
            Self::Unlike(point) if !is_axle => Some(format!(
                "left and right are no mirror images, at {point} for one: both are here, as an axle; --side takes one of them"
            )),
            _ => None,
        }
    }
}

impl Imported<'_> {
    /// What the file has of the other side, of the points that the layout takes.
    pub(super) fn other_side(&self) -> Other {
        let off = ROUNDING * self.corner.apart();
        let mut other = Other::Missing;
        for (_, point) in &self.choice.found {
            let Some(side) = point.side else { continue };
            let mut points = self.stated.points.iter();
            let is_its = |other: &&Hardpoint| {
                other.key == point.key && other.side.is_some_and(|of| of != side)
            };
            let Some(image) = points.find(is_its) else {
                return Other::Missing;
            };
            let [[x, y, z], [of_x, of_y, of_z]] = [point.at, image.at];
            let is_image = [x - of_x, y + of_y, z - of_z]
                .iter()
                .all(|by| by.abs() <= off);
            if !is_image && !matches!(other, Other::Unlike(_)) {
                let line = self.stated.line(&image.place);
                other = Other::Unlike(format!("`{}` ({line})", image.name));
            } else if matches!(other, Other::Missing) {
                other = Other::Image;
            }
        }
        other
    }

    /// Name, position and origin of each point, in the order of the listing, its names and those of the corner's points having
    /// `before` before them.
    pub(super) fn placed(&self, before: &str) -> Vec<[String; 3]> {
        let Self { choice, stated, .. } = self;
        let (unit, _) = self.unit();
        let spin = Spin::of(stated, self.names, self.corner.side);
        let names = load::points(&choice.listing).map(str::to_owned);
        let each = names.filter_map(|name| {
            let (position, origin) = match (self.at(&name), choice.point(&name)) {
                (Some(at), Some(point)) => {
                    let origin = format!("{}, {}", point.name, stated.line(&point.place));
                    let halved = self.halved(&name, at).filter(|_| !before.is_empty());
                    match halved {
                        Some(at) => (
                            format!("{at:?}"),
                            format!("halfway from bar_outer to {origin}"),
                        ),
                        None => (format!("{at:?}"), origin),
                    }
                }
                _ => stand_in(&name, |name| self.at(name), &spin, (unit.metre(), before))?,
            };
            Some([format!("{before}{name}"), position, origin])
        });
        each.collect()
    }

    /// The middle of a bar is a point of both corners, of which each needs its own on the line that the bar twists about.
    fn halved(&self, name: &str, at: [f64; 3]) -> Option<[f64; 3]> {
        if name != "bar_inner" || at[1] != 0.0 {
            return None;
        }
        let outer = self.at("bar_outer")?;
        Some([0, 1, 2].map(|axis| 0.5 * (at[axis] + outer[axis])))
    }

    /// Where a point of the listing is, where the file has it.
    pub(super) fn at(&self, name: &str) -> Option<[f64; 3]> {
        let place = self
            .choice
            .found
            .iter()
            .position(|(found, _)| found == name)?;
        Some(self.corner.at[place])
    }
}

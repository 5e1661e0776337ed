//! Whether left and right are mirror images.

use super::hardpoints::{Hardpoint, Number};
use super::imported_corner::ImportedCorner;
use crate::vehicle_corner::Side;

/// The data of a file on the other side of the vehicle.
pub(super) enum OtherSide {
    Nothing,
    /// The file lacks some of its points.
    Part,
    /// The other side is the mirror image.
    Image,
    /// The other side is another suspension: the named point or number differs from the mirror image.
    Unlike(String),
}

/// The largest deviation from a mirror image, as a part of the suspension's size: files round their numbers.
const ROUNDING: f64 = 1e-6;

impl OtherSide {
    /// Returns a sentence on the other side for the user.
    pub(super) fn side_note(&self, is_axle: bool) -> Option<String> {
        match self {
            Self::Image if !is_axle => Some(
                "the right corner is the mirror image of the left one; --axle makes an axle of both".to_owned(),
            ),
            Self::Unlike(what) if !is_axle => Some(format!(
                "{}: the motion file is an axle of both corners; --side takes one of them",
                unlike(what)
            )),
            Self::Part if !is_axle => Some(
                "the file has points of the other side too, but not all: they are not used".to_owned(),
            ),
            Self::Unlike(what) => Some(unlike(what)),
            _ => None,
        }
    }
}

impl ImportedCorner<'_> {
    /// Compares the points of the layout with those of the other side.
    pub(super) fn other_side(&self) -> OtherSide {
        let found = self.choice.found.iter().map(|(_, point)| *point);
        let sided = found.filter(|point| point.side.is_some());
        let images: Vec<_> = sided.map(|point| (point, self.image(point))).collect();
        let count = images.iter().filter(|(_, image)| image.is_some()).count();
        if count == 0 {
            return OtherSide::Nothing;
        }
        if count < images.len() {
            return OtherSide::Part;
        }
        let pairs = images
            .into_iter()
            .filter_map(|(point, image)| Some((point, image?)));
        let unlike = self.furthest(pairs).or_else(|| self.unlike_number());
        unlike.map_or(OtherSide::Image, OtherSide::Unlike)
    }

    /// Notes a point of a layout with both sides that is not the mirror image of its twin.
    pub(super) fn unlike_twins(&self) -> Option<String> {
        let found = self.choice.found.iter();
        // Without the ends of a Watt linkage, `watt_left` and `watt_right`, which are at different heights.
        let left = found.filter(|(name, _)| name.contains("left_"));
        let pairs = left.filter_map(|(name, point)| {
            let twin = self.choice.point(&name.replace("left_", "right_"))?;
            Some((*point, twin))
        });
        self.furthest(pairs).map(|what| unlike(&what))
    }

    /// Returns the point of the same name on the other side.
    fn image(&self, point: &Hardpoint) -> Option<&Hardpoint> {
        let mut points = self.stated.points.iter();
        points.find(|other| other.key == point.key && is_other_side(other.side, point.side))
    }

    /// Names the right point that is furthest from the mirror image of the left one, with the coordinate; `None` if all are
    /// mirror images.
    fn furthest<'b>(
        &self,
        pairs: impl Iterator<Item = (&'b Hardpoint, &'b Hardpoint)>,
    ) -> Option<String> {
        let each = pairs.flat_map(|(left, right)| {
            let [x, y, z] = left.at;
            [("x", x, 0), ("y", 0.0 - y, 1), ("z", z, 2)].map(|(axis, image, place)| {
                let is = right.at[place];
                ((is - image).abs(), right, axis, is, left.at[place])
            })
        });
        let rounding = ROUNDING * self.corner.apart();
        let unlike = each.filter(|(off, ..)| *off > rounding);
        let (_, point, axis, is, left) = unlike.max_by(|one, other| one.0.total_cmp(&other.0))?;
        let line = self.stated.line(&point.place);
        Some(format!(
            "`{}` ({line}; {axis} = {is}, but {left} on the left)",
            point.name
        ))
    }

    /// Returns a number, for example an angle, that differs between the sides.
    fn unlike_number(&self) -> Option<String> {
        let numbers = &self.stated.numbers;
        let is_unlike = |number: &&Number| {
            let mut others = numbers.iter();
            others.any(|other| {
                other.key == number.key
                    && is_other_side(other.side, number.side)
                    && other.value != number.value
            })
        };
        let unlike = numbers.iter().find(is_unlike);
        unlike.map(|number| format!("`{}` ({})", number.key, self.stated.line(&number.place)))
    }
}

/// Says that the sides are not mirror images.
fn unlike(what: &str) -> String {
    format!("left and right are not mirror images, for example at {what}")
}

fn is_other_side(other: Option<Side>, side: Option<Side>) -> bool {
    other.is_some() && side.is_some() && other != side
}

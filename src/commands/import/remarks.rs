//! Remarks on an import, one sentence each: assumptions, conversions, and what is not used.

use std::ops::RangeInclusive;

use super::hardpoints::{Hardpoint, UnknownNumber};
use super::imported_corner::ImportedCorner;
use super::listed::{MOST_NAMES, listed};
use super::orientation::Orientation;
use super::rack::RACK;
use super::spelling::key_of;
use crate::listing_description::first_sentence;
use crate::mechanism::{Axes, Length};
use crate::number::rounded;

/// The most items of a list, and what stands between them.
const MOST: (usize, &str) = (MOST_NAMES, ", ");

impl ImportedCorner<'_> {
    /// Returns the unit of lengths and the reason for it.
    pub(super) fn unit(&self) -> (Length, String) {
        match (self.unit, self.stated.unit) {
            (Some(unit), _) => (unit, "as --unit says".to_owned()),
            (None, Some(unit)) => (unit, "as the file says".to_owned()),
            (None, None) => {
                let apart = self.corner.apart();
                let why = format!("as the points are up to {} apart", rounded(apart, 4));
                (Length::guess_from_size(apart), why)
            }
        }
    }

    /// Says that a suspension is hardly of the size that it has in a unit.
    fn doubtful_size(&self, unit: Length) -> Option<String> {
        /// The sizes of suspensions, those of models among them, m.
        const SIZES: RangeInclusive<f64> = 0.03..=5.0;
        let size = self.corner.apart() / unit.metre();
        (!SIZES.contains(&size)).then(|| {
            let size = rounded(size, 4);
            format!("; that is doubtful, as the points are then up to {size} m apart")
        })
    }

    /// Returns the assumptions about the file.
    pub(super) fn file_remarks(&self) -> Vec<String> {
        let choice = &self.choice;
        let (unit, why_unit) = self.unit();
        let Orientation { axes, why, doubts } = &self.orientation;
        let axes = *axes;
        let mut remarks = vec![
            format!(
                "the layout is {}: {}",
                choice.linkage(),
                self.layout_in_words()
            ),
            format!(
                "the unit of lengths is {}, {why_unit}{}",
                unit.symbol(),
                self.doubtful_size(unit).unwrap_or_default()
            ),
            format!(
                "axes are {} ({}), {why}; {}",
                axes.name(),
                axes.meaning(),
                changed(axes)
            ),
        ];
        remarks.extend(doubts.iter().cloned());
        remarks.extend(self.unknown_numbers());
        remarks.extend(self.notes.iter().cloned());
        remarks
    }

    /// Returns the assumptions about the corner and the conversions; for the corners of an axle without their sides.
    pub(super) fn corner_remarks(&self, is_of_axle: bool) -> Vec<String> {
        let Self { choice, corner, .. } = self;
        let mut remarks = Vec::from_iter(self.on_upper_wishbone());
        let side = corner.side.name();
        if corner.mirrored {
            let was = corner.side.other().name();
            remarks.push(format!(
                "the coordinates are those of the {was} corner; the {side} corner is its mirror image, as the options ask"
            ));
        } else if choice.point("wheel_centre").is_some() && !is_of_axle {
            remarks.push(format!("the corner is the {side} one"));
        }
        remarks.extend(self.exchanged_ends());
        remarks.extend(self.unlike_twins());
        remarks.extend(self.toe_link());
        remarks.extend(self.semi_trailing_arm());
        remarks.extend(self.strut_from_ball_joint());
        let contact = self.contact();
        let is_contact = |point: &Hardpoint| {
            contact
                .as_ref()
                .is_some_and(|contact| std::ptr::eq(contact.point, point))
        };
        let unused = self.points.iter();
        let unused = unused.filter(|point| !choice.uses(point) && !is_contact(point));
        let unused = listed(unused, MOST, |point| self.unused(point));
        remarks.extend(unused.map(|unused| format!("not used: {unused}")));
        remarks.extend(contact.map(|contact| format!("the wheel radius is {}", contact.why)));
        remarks.extend(choice.larger.clone());
        remarks
    }

    /// Describes the layout as in the catalogue, without a side and, if it does not steer, without a rack.
    fn layout_in_words(&self) -> String {
        let sentence = remove_side(&first_sentence(&self.choice.text));
        match self.choice.fixed {
            Some(_) => sentence.replace("a steering rack", "a toe link"),
            None => sentence,
        }
    }

    /// Says why the inner end of a toe link is fixed in a layout that has the end of a rack there, and how to make it steer.
    fn toe_link(&self) -> Option<String> {
        let inner = &self.choice.point(RACK)?.name;
        let why = self.choice.fixed.as_ref()?;
        Some(format!(
            "`{inner}` does not steer, it is fixed on the chassis: {why}. To make it steer, call it `rack` in the hardpoint file and \
             import that again"
        ))
    }

    /// Says that an arm whose axis is oblique is a semi-trailing arm, where the file lacks the points of that layout.
    fn semi_trailing_arm(&self) -> Option<String> {
        /// The angle in plan view at which an axis counts as oblique, degrees.
        const OBLIQUE: f64 = 3.0;
        let is_arm = self.choice.linkage() == "trailing_arm";
        let [inner, outer] = ["pivot_inner", "pivot_outer"].map(|name| self.choice.point(name));
        let (inner, outer) = (inner?.at, outer?.at);
        let angle = (outer[0] - inner[0])
            .abs()
            .atan2((outer[1] - inner[1]).abs());
        let angle = angle.to_degrees();
        (is_arm && angle > OBLIQUE).then(|| {
            format!(
                "the axis of the arm is turned by {angle:.0} degrees in plan view, so it is a semi-trailing arm, which moves as in this \
                 layout. With the points shaft_inner and shaft_outer the layout is semi_trailing_arm, with the drive shaft"
            )
        })
    }

    /// Says how a strut whose line passes through the lower ball joint is stated.
    fn strut_from_ball_joint(&self) -> Option<String> {
        self.lifted()?;
        let [low, ball] = ["strut_low", "lower_ball"].map(|name| self.choice.point(name));
        Some(format!(
            "`{}` is in the same place as `{}`: strut_low is placed a quarter of the way from there to top. The suspension moves \
             the same; the measure damper, from strut_low to top, is a quarter of the strut shorter",
            low?.name, ball?.name
        ))
    }

    /// Notes inner ends of links and wishbones that are outboard of their outer ends.
    fn exchanged_ends(&self) -> impl Iterator<Item = String> {
        let pairs = self.names.arrangement.outboard.iter();
        pairs.filter_map(|[outer, inner]| {
            let ends = [self.choice.point(outer)?, self.choice.point(inner)?];
            let [out, inward] = ends.map(|end| end.at[1].abs());
            let [outer, inner] = ends.map(|end| self.stated.quoted(end));
            (out < inward).then(|| {
                format!(
                    "{inner} is further from the middle of the vehicle than {outer}: have they each other's names?"
                )
            })
        })
    }

    /// Names the rows of numbers that are not used, each with what to do about it if that is known.
    fn unknown_numbers(&self) -> Option<String> {
        let numbers = self.stated.unknown_numbers.iter();
        let unknown = listed(numbers, MOST, |number| {
            let UnknownNumber { name, place, .. } = number;
            let advice = self.names.number_advice(&key_of(name).0);
            let advice = advice.map(|advice| format!(", {advice}"));
            let line = self.stated.line(place);
            format!("`{name}` ({line}{})", advice.unwrap_or_default())
        })?;
        Some(format!("numbers that are not used: {unknown}"))
    }

    /// Names a point that is not used and, if its name is unknown, the point that may have been meant.
    fn unused(&self, point: &Hardpoint) -> String {
        let is_known = self.names.is_point(&point.key);
        let meant = self.names.point_meant(&point.key).filter(|_| !is_known);
        let hint = meant.map(|name| format!(" (did you mean {name}?)"));
        format!("{}{}", point.name, hint.unwrap_or_default())
    }

    /// Says why a point is on the upper wishbone, and how to put it on the lower one.
    fn on_upper_wishbone(&self) -> Option<String> {
        let moved = self.choice.upper?;
        let points = [moved, "upper_ball", "lower_ball"].map(|name| self.choice.point(name));
        let [Some(point), Some(upper), Some(lower)] = points else {
            return None;
        };
        let [point, upper, lower] = [point, upper, lower].map(|point| &point.name);
        Some(format!(
            "`{point}` is nearer to `{upper}` than to `{lower}`, so it is on the upper wishbone. To put it on the lower one, move \
             {moved} to lower_wishbone in the statements of the corner"
        ))
    }
}

/// Says how points that the file does not have are placed; points with the same reason share a sentence.
pub(super) fn placed<'a>(points: impl Iterator<Item = &'a [String; 3]>) -> Vec<String> {
    let mut whys: Vec<(&str, Vec<String>)> = Vec::new();
    for [name, _, why] in points {
        let name = format!("`{name}`");
        match whys.iter_mut().find(|(other, _)| other == why) {
            Some((_, names)) => names.push(name),
            None => whys.push((why, vec![name])),
        }
    }
    let each = whys.into_iter().map(|(why, names)| match names.as_slice() {
        [name] => format!("the file does not have the point {name}, which is placed {why}"),
        names => {
            let names = names.join(", ");
            format!("the file does not have the points {names}, each of which is placed {why}")
        }
    });
    each.collect()
}

/// Removes the side from the description of a layout: all corners of the catalogue are left ones.
fn remove_side(sentence: &str) -> String {
    let sides = [", front left", ", rear left", ", left"];
    let without = |sentence: String, side| sentence.replace(side, "");
    sides.into_iter().fold(sentence.to_owned(), without)
}

/// Says how the coordinates were converted.
fn changed(axes: Axes) -> &'static str {
    match axes {
        Axes::Iso => "coordinates are those of the file",
        Axes::Adams => "x and y have changed their signs",
        Axes::Sae => "y and z have changed their signs",
    }
}

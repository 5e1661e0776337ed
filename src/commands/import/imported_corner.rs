//! The data of a corner in a file.

use super::corner_points::CornerPoints;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::layout_choice::Choice;
use super::names::Names;
use super::orientation::Orientation;
use super::stand_in::{Spin, stand_in};
use crate::mechanism::Length;
use crate::number::rounded;

/// The data that the file has for a corner.
pub(super) struct ImportedCorner<'a> {
    pub(super) stated: &'a Hardpoints<'a>,
    pub(super) names: &'a Names,
    /// The points of the corner and those without a side.
    pub(super) points: Vec<&'a Hardpoint>,
    pub(super) choice: Choice<'a>,
    pub(super) orientation: Orientation,
    pub(super) corner: CornerPoints,
    /// The unit that the user states.
    pub(super) unit: Option<Length>,
    /// Sentences about the other corner of the file.
    pub(super) notes: Vec<String>,
}

/// The largest plausible distance of a wheel's centre from the middle of a vehicle, m: half the track of a wide lorry.
const WIDEST: f64 = 1.2;

impl ImportedCorner<'_> {
    /// Checks a unit that is deduced from the size of the suspension against the distance of the wheel from the middle of the
    /// vehicle.
    ///
    /// # Errors
    ///
    /// A sentence if the wheel is too far away, as where lengths in cm are taken for inches, or its y is mistyped.
    pub(super) fn check_unit(&self) -> Result<(), String> {
        /// How much further from the middle than all other points a wheel centre is if its own y alone is wrong.
        const ALONE: f64 = 3.0;
        let is_stated = self.unit.or(self.stated.unit).is_some();
        let centre = self.choice.point("wheel_centre").filter(|_| !is_stated);
        let Some(centre) = centre else {
            return Ok(());
        };
        let (unit, why) = self.unit();
        let off = |point: &Hardpoint| point.at[1].abs() / unit.metre();
        if off(centre) <= WIDEST {
            return Ok(());
        }
        let others = self.choice.off_axis();
        let next = others.map(|(_, point)| off(point)).fold(0.0, f64::max);
        let remedy = match off(centre) > ALONE * next {
            true => "correct its y",
            false => "state the unit with --unit; convert lengths in cm to mm",
        };
        Err(format!(
            "the unit of lengths would be {}, {why}, but then {} is {} m from the middle of the vehicle and no point off the spin \
             axis more than {} m: {remedy}",
            unit.symbol(),
            self.stated.quoted(centre),
            rounded(off(centre), 3),
            rounded(next, 3)
        ))
    }

    /// Checks that the corner is on the side that its names say.
    ///
    /// # Errors
    ///
    /// A sentence if it is on the other side, as in tables that count y outboard on both sides.
    pub(super) fn check_side(&self) -> Result<(), String> {
        let corner = &self.corner;
        let centre = self.choice.point("wheel_centre");
        let Some(centre) = centre.filter(|_| corner.is_elsewhere()) else {
            return Ok(());
        };
        let axes = self.orientation.axes;
        Err(format!(
            "`{}` is on the {side} by its name, and on the {} by y = {} in axes {} ({}); change the signs of y at the points of \
             the {side} corner",
            centre.name,
            corner.side.other().name(),
            centre.at[1],
            axes.name(),
            axes.meaning(),
            side = corner.side.name(),
        ))
    }

    /// Returns name, position and origin of each point, in the order of the listing; `before` is the prefix of the point
    /// names.
    pub(super) fn placed(&self, before: &str) -> Vec<[String; 3]> {
        let Self { choice, stated, .. } = self;
        let (unit, _) = self.unit();
        let (side, stated_side) = (self.corner.side, self.corner.stated_side);
        let spin = Spin::new(stated, self.names, side, stated_side);
        let each = choice.layout.points.iter().filter_map(|name| {
            let (position, origin) = match (self.position(name), choice.point(name)) {
                (Some(at), Some(point)) => {
                    let origin = format!("{}, {}", point.name, stated.line(&point.place));
                    let halved = self.halved(name, at).filter(|_| !before.is_empty());
                    match halved {
                        Some(at) => (
                            format!("{at:?}"),
                            format!("halfway from bar_outer to {origin}"),
                        ),
                        None if name == "strut_low" && self.lifted().is_some() => (
                            format!("{at:?}"),
                            format!("a quarter of the way to top from {origin}"),
                        ),
                        None => (format!("{at:?}"), origin),
                    }
                }
                _ => stand_in(
                    name,
                    |name| self.position(name),
                    &spin,
                    (unit.metre(), before),
                )?,
            };
            Some([format!("{before}{name}"), position, origin])
        });
        each.collect()
    }

    /// Moves the middle of a bar, which both corners would share, outboard along the axis of the bar's twist so that each
    /// corner has its own.
    fn halved(&self, name: &str, at: [f64; 3]) -> Option<[f64; 3]> {
        if name != "bar_inner" || at[1] != 0.0 {
            return None;
        }
        let outer = self.position("bar_outer")?;
        Some([0, 1, 2].map(|axis| 0.5 * (at[axis] + outer[axis])))
    }

    /// Returns the lower end of a strut that ends in the lower ball joint, moved up the strut's line: one body has no two
    /// points in one place.
    pub(super) fn lifted(&self) -> Option<[f64; 3]> {
        let low = self.stated("strut_low")?;
        let top = self.stated("top")?;
        let lifted = [0, 1, 2].map(|axis| 0.75 * low[axis] + 0.25 * top[axis]);
        (self.stated("lower_ball")? == low).then_some(lifted)
    }

    /// Returns the coordinates of a point of the listing, if the file has it.
    pub(super) fn position(&self, name: &str) -> Option<[f64; 3]> {
        match name {
            "strut_low" => self.lifted().or_else(|| self.stated(name)),
            _ => self.stated(name),
        }
    }

    fn stated(&self, name: &str) -> Option<[f64; 3]> {
        let place = self
            .choice
            .found
            .iter()
            .position(|(found, _)| found == name)?;
        Some(self.corner.at[place])
    }
}

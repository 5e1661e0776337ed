//! The motion file that comes of an import.

use std::fmt::Write;

use suspension_core::listing::{DriveKind, Kind, Part, Parts};
use suspension_runtime::Listing;

use super::choice::Choice;
use super::corner::Corner;
use super::hardpoints::{Hardpoint, Hardpoints};
use super::names::Names;
use super::orientation::Orientation;
use super::stand_in::{Spin, number, stand_in};
use crate::load;
use crate::mechanism::Length;

/// What was found in a file.
pub(super) struct Imported<'a> {
    pub(super) stated: &'a Hardpoints<'a>,
    pub(super) names: &'a Names,
    /// Those of the corner, and those of no side.
    pub(super) points: &'a [&'a Hardpoint],
    pub(super) choice: &'a Choice<'a>,
    pub(super) orientation: &'a Orientation,
    pub(super) corner: &'a Corner,
    /// The unit that the user states.
    pub(super) unit: Option<Length>,
}

/// What the motion file says, but for the drives' values.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    /// The file that it comes of.
    source: &'a str,
    listing: &'a Listing,
    linkage: &'a str,
    unit: Length,
    /// What was assumed and done, a sentence each.
    pub(super) remarks: Vec<String>,
    /// Name, position and origin of each point.
    points: Vec<[String; 3]>,
    /// With its origin.
    wheel_radius: Option<(f64, String)>,
}

/// How far the travel goes in the motion, m and rad.
const TRAVEL: f64 = 0.03;
const TURN: f64 = 0.1;

/// The drive of travel where no drive has another name.
const BUMP: &str = "bump";

impl Imported<'_> {
    /// Name, position and origin of each point, in the order of the listing.
    fn points(&self) -> Vec<[String; 3]> {
        let Self { choice, stated, .. } = self;
        let (unit, _) = self.unit();
        let spin = Spin::of(stated, self.names, self.corner.side);
        let at = |name: &str| {
            let place = choice.found.iter().position(|(found, _)| found == name)?;
            Some(self.corner.at[place])
        };
        let names = load::points(&choice.listing).map(str::to_owned);
        let each = names.filter_map(|name| {
            let (position, origin) = match (at(&name), choice.point(&name)) {
                (Some(at), Some(point)) => {
                    let origin = format!("{}, {}", point.name, stated.line(&point.place));
                    (format!("{at:?}"), origin)
                }
                _ => stand_in(&name, at, &spin, unit.metre())?,
            };
            Some([name, position, origin])
        });
        each.collect()
    }
}

impl<'a> Draft<'a> {
    /// Of what was found.
    pub(super) fn of(imported: &Imported<'a>) -> Self {
        let Imported {
            stated,
            names,
            choice,
            corner,
            ..
        } = imported;
        let (unit, _) = imported.unit();
        let mut remarks = imported.remarks();
        let points = imported.points();
        let placed = points
            .iter()
            .filter(|[name, ..]| choice.spare.contains(name));
        remarks.extend(placed.map(|[name, _, why]| format!("{name} is not in the file: {why}")));
        let radius = number(stated, names, "wheel_radius", corner.side);
        let radius = radius.map(|radius| (radius.value, stated.line(&radius.place)));
        if radius.is_none() {
            remarks.push("the file has no tire_radius; wheel_radius under [vehicle] gives what needs the ground".to_owned());
        }
        Self {
            source: stated.source.name(),
            listing: &choice.listing,
            linkage: choice.linkage,
            unit,
            remarks,
            points,
            wheel_radius: radius,
        }
    }

    /// The file, the drives starting where they are at the design position.
    pub(super) fn text(&self, design: &[f64]) -> String {
        let mut text = format!("# Of {}, by suspension import:\n", self.source);
        for remark in &self.remarks {
            line(&mut text, format_args!("# {remark}"));
        }
        line(&mut text, format_args!("linkage = \"{}\"", self.linkage));
        line(&mut text, format_args!("unit = \"{}\"", self.unit.symbol()));
        line(&mut text, format_args!("\n[points]"));
        for [name, position, remark] in &self.points {
            line(&mut text, format_args!("{name} = {position}  # {remark}"));
        }
        let travel = self.travel();
        line(&mut text, format_args!("\n[vehicle]"));
        match &self.wheel_radius {
            Some((radius, remark)) => {
                line(
                    &mut text,
                    format_args!("wheel_radius = {radius:?}  # {remark}"),
                );
            }
            None => line(&mut text, format_args!("# wheel_radius = ")),
        }
        // Drives that are found by their names need no word.
        if !self.drive(travel).starts_with(BUMP) {
            line(
                &mut text,
                format_args!("travel = \"{}\"", self.drive(travel)),
            );
        }
        text += "\n# In seconds.\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.02\n";
        text += "\n# From the design position; polynomials of time.\n[drives]\n";
        for (drive, start) in design.iter().enumerate() {
            let rate = match self.listing.drive_kind(drive) {
                DriveKind::Coordinate => TRAVEL * self.unit.metre(),
                DriveKind::Angle => TURN,
            };
            let name = self.drive(drive);
            if drive == travel {
                line(&mut text, format_args!("{name} = [{start:?}, {rate:?}]"));
            } else {
                line(&mut text, format_args!("{name} = {start:?}"));
            }
        }
        text
    }

    /// How many drives there are.
    pub(super) fn drives(&self) -> usize {
        self.listing.count(Kind::Drive)
    }

    fn drive(&self, drive: usize) -> &str {
        self.listing.name(Part::Drive(drive))
    }

    /// The drive that moves the wheel up and down.
    fn travel(&self) -> usize {
        let mut drives = 0..self.drives();
        let of_bump = drives.find(|drive| self.drive(*drive).starts_with(BUMP));
        of_bump.unwrap_or_default()
    }
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing into a string has no way to fail.
    let _ = writeln!(text, "{line}");
}

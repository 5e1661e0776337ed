//! The motion file that an import writes.

use std::fmt::Write;

use suspension_core::listing::{DriveKind, Kind, Part, Parts};
use suspension_runtime::Listing;

use super::axle::Axle;
use super::vehicle::Vehicle;
use crate::commands::import::imported_corner::ImportedCorner;
use crate::commands::import::{rack, remarks};
use crate::mechanism::Length;
use crate::number::rounded;

/// The contents of the motion file except for the drives' values.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    /// The name of the file of hardpoints.
    pub(super) source: &'a str,
    listing: &'a Listing,
    /// The statement of the listing in the motion file.
    stated: String,
    unit: Length,
    /// Assumptions and conversions, one sentence each.
    pub(super) remarks: Vec<String>,
    /// Name, position and origin of each point.
    points: Vec<[String; 3]>,
    vehicle: Vehicle,
}

/// The change of the drive of travel in the example motion, m or degrees.
const TRAVEL: f64 = 0.03;
const TURN: f64 = 5.0;

/// The default name of the drive of travel.
const BUMP: &str = "bump";

/// Returns name, position and origin of each point of a corner, and remarks on it; `before` is the prefix of its point
/// names.
fn corner(imported: &ImportedCorner<'_>, before: &str) -> (Vec<[String; 3]>, Vec<String>) {
    let points = imported.placed(before);
    let spare = &imported.choice.spare;
    let is_placed = |name: &str| spare.iter().any(|spare| name == format!("{before}{spare}"));
    let placed = points.iter().filter(|[name, ..]| is_placed(name));
    let placed = remarks::placed(placed);
    let remarks = imported.corner_remarks(!before.is_empty()).into_iter();
    let remarks = remarks.chain(placed).collect();
    (points, remarks)
}

/// Says which line replaces the spin axis if the spin axis is between two points of the hardpoint file.
fn spin_axis_between_hardpoints(listing: &Listing) -> Option<String> {
    let [inner, centre] = listing.wheel(0)?.axis;
    let moving = [Kind::ChassisPoint, Kind::FreePoint].map(|kind| listing.count(kind));
    let [inner, centre] = (inner < moving.iter().sum())
        .then_some([inner, centre])?
        .map(|point| listing.name(Part::Point(point)));
    let line = format!("the line from {inner} to {centre}");
    Some(format!("camber and toe are those of {line} in this layout"))
}

impl<'a> Draft<'a> {
    /// Drafts the motion file of one corner.
    pub(super) fn for_corner(imported: &'a ImportedCorner<'_>, listing: &'a Listing) -> Self {
        let choice = &imported.choice;
        let stated = if choice.is_changed {
            let statements = rack::without_places(&choice.text);
            format!("statements = '''\n{}'''", statements.trim_start())
        } else {
            format!("linkage = \"{}\"", choice.linkage())
        };
        let corner = corner(imported, "");
        let vehicle = Vehicle::of_corner(imported);
        Self::new(imported, listing, stated, corner, vehicle)
    }

    /// Drafts the motion file of an axle, the left corner first.
    pub(super) fn for_axle(
        sides: [&'a ImportedCorner<'_>; 2],
        axle: &Axle,
        listing: &'a Listing,
    ) -> Self {
        let mut points: Vec<[String; 3]> = axle.housing(sides[0]).into_iter().collect();
        let mut remarks = vec!["the motion file has an axle, both corners".to_owned()];
        for (side, before) in sides.into_iter().zip(["left_", "right_"]) {
            let corner = corner(side, before);
            points.extend(corner.0);
            let new = corner
                .1
                .into_iter()
                .filter(|remark| !remarks.contains(remark));
            remarks.extend(new.collect::<Vec<_>>());
        }
        let stated = format!("statements = '''\n{}'''", axle.statements);
        let vehicle = Vehicle::of_axle(sides);
        Self::new(sides[0], listing, stated, (points, remarks), vehicle)
    }

    fn new(
        imported: &'a ImportedCorner<'_>,
        listing: &'a Listing,
        stated: String,
        (points, of_corners): (Vec<[String; 3]>, Vec<String>),
        vehicle: Vehicle,
    ) -> Self {
        let (unit, _) = imported.unit();
        let mut remarks = imported.file_remarks();
        remarks.extend(of_corners);
        remarks.extend(spin_axis_between_hardpoints(listing));
        if vehicle.wheel_radius.is_none() {
            remarks.push("the file has no tire_radius; wheel_radius under [vehicle] gives what needs the ground".to_owned());
        }
        let mut draft = Self {
            source: imported.stated.source.name(),
            listing,
            stated,
            unit,
            remarks,
            points,
            vehicle,
        };
        draft.remarks.push(draft.motion_remark());
        draft
    }

    /// Says that the motion is an example.
    fn motion_remark(&self) -> String {
        let travel = (0..self.drives()).filter(|drive| self.is_travel(*drive));
        let travel = travel.map(|drive| {
            let rate = match self.listing.drive_kind(drive) {
                DriveKind::Coordinate => {
                    let rate = rounded(TRAVEL * self.unit.metre(), 3);
                    format!("{rate} {}", self.unit.symbol())
                }
                DriveKind::Angle | DriveKind::Turn => format!("{TURN} deg"),
            };
            format!("{} grows by {rate} a second", self.drive(drive))
        });
        let travel: Vec<String> = travel.collect();
        format!(
            "the motion is an example: for one second {}, other drives are held",
            travel.join(", ")
        )
    }

    /// Returns a note on the motion file with the origin of each point behind its name.
    pub(super) fn with_origins(&self, note: &str) -> String {
        let points = self.points.iter();
        points.fold(note.to_owned(), |note, [name, _, origin]| {
            let name = format!("`{name}`");
            note.replacen(&name, &format!("{name} ({origin})"), 1)
        })
    }

    /// Returns the motion file. The drives start at their values at the `design` position, angles in radians.
    pub(super) fn text(&self, design: &[f64]) -> String {
        let mut text = format!("# Of {}, by suspension import:\n", self.source);
        for remark in &self.remarks {
            line(&mut text, format_args!("# {remark}"));
        }
        line(&mut text, format_args!("{}", self.stated));
        line(&mut text, format_args!("unit = \"{}\"", self.unit.symbol()));
        text += "angle = \"deg\"\n";
        line(&mut text, format_args!("\n[points]"));
        for [name, position, remark] in &self.points {
            line(&mut text, format_args!("{name} = {position}  # {remark}"));
        }
        line(&mut text, format_args!("\n[vehicle]"));
        for stated in self.vehicle.lines(self.wheels()) {
            line(&mut text, format_args!("{stated}"));
        }
        if let Some(travel) = self.stated_travel() {
            line(&mut text, format_args!("{travel}"));
        }
        text += "\n# In seconds.\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.02\n";
        text += "\n# The drives' own values, which start at the design position; polynomials of time. suspension motion --help has sines and recordings.\n[drives]\n";
        for (drive, start) in design.iter().enumerate() {
            let (start, rate) = match self.listing.drive_kind(drive) {
                DriveKind::Coordinate => (*start, TRAVEL * self.unit.metre()),
                DriveKind::Angle | DriveKind::Turn => (start.to_degrees(), TURN),
            };
            let name = self.drive(drive);
            if self.is_travel(drive) {
                line(&mut text, format_args!("{name} = [{start:?}, {rate:?}]"));
            } else {
                line(&mut text, format_args!("{name} = {start:?}"));
            }
        }
        text
    }

    pub(super) fn drives(&self) -> usize {
        self.listing.count(Kind::Drive)
    }

    fn drive(&self, drive: usize) -> &str {
        self.listing.name(Part::Drive(drive))
    }

    /// Returns whether a drive moves a wheel up and down: the one called so, or else the first of each corner.
    fn is_travel(&self, drive: usize) -> bool {
        let of_bump = |drive: usize| self.drive(drive).split('_').any(|word| word == BUMP);
        of_bump(drive) || !(0..self.drives()).any(of_bump) && (drive == 0 || self.wheels() > 1)
    }

    /// Returns the lines of `[vehicle]` on travel; drives with the usual names need none.
    fn stated_travel(&self) -> Option<String> {
        let mut travel = (0..self.drives()).filter(|drive| self.is_travel(*drive));
        let first = self.drive(travel.next()?);
        if first.split('_').any(|word| word == BUMP) {
            return None;
        }
        Some(match travel.next() {
            None => format!("travel = \"{first}\""),
            Some(second) => {
                let second = self.drive(second);
                format!("travel = {{ left = \"{first}\", right = \"{second}\" }}")
            }
        })
    }

    fn wheels(&self) -> usize {
        (0..).map_while(|wheel| self.listing.wheel(wheel)).count()
    }
}

fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    // Writing into a string cannot fail.
    let _ = writeln!(text, "{line}");
}

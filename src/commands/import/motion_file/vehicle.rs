//! The section `[vehicle]` of the motion file that an import writes.

use crate::commands::import::contact::Contact;
use crate::commands::import::imported_corner::ImportedCorner;
use crate::commands::import::stand_in::number;
use crate::vehicle_corner::End;

/// What a file says about the vehicle.
#[derive(Debug)]
pub(super) struct Vehicle {
    /// The wheel radius as the motion file states it, with its origin.
    pub(super) wheel_radius: Option<[String; 2]>,
    /// The axle of the suspension, and the line that says so.
    axle: Option<(End, String)>,
}

impl Vehicle {
    pub(super) fn of_corner(imported: &ImportedCorner<'_>) -> Self {
        Self {
            wheel_radius: wheel_radius(imported),
            axle: imported.stated.end(),
        }
    }

    pub(super) fn of_axle(sides: [&ImportedCorner<'_>; 2]) -> Self {
        let wheel_radius = match sides.map(wheel_radius) {
            [Some([left, line]), Some([right, other])] if left != right => Some([
                format!("{{ left = {left}, right = {right} }}"),
                format!("{line}, {other}"),
            ]),
            [left, right] => left.or(right),
        };
        Self {
            wheel_radius,
            ..Self::of_corner(sides[0])
        }
    }

    /// Returns the lines below the heading; those that the file leaves open are comments.
    pub(super) fn lines(&self, wheels: usize) -> Vec<String> {
        let mut lines = vec![match &self.wheel_radius {
            Some([radius, origin]) => format!("wheel_radius = {radius}  # {origin}"),
            None => "# wheel_radius = ".to_owned(),
        }];
        if let Some((end, why)) = &self.axle {
            lines.push(format!("axle = \"{}\"  # {why}", end.name()));
        }
        let is_rear = matches!(self.axle, Some((End::Rear, _)));
        if wheels > 1 && !is_rear {
            lines.push("# wheelbase =   # gives Ackermann and the turning circle".to_owned());
        }
        lines
    }
}

/// Returns the wheel's radius and its origin.
fn wheel_radius(imported: &ImportedCorner<'_>) -> Option<[String; 2]> {
    let to_contact = |contact: Contact<'_>| [contact.radius, contact.why];
    stated_radius(imported).or_else(|| imported.contact().map(to_contact))
}

/// Returns the radius that the file states, with its line.
fn stated_radius(imported: &ImportedCorner<'_>) -> Option<[String; 2]> {
    let ImportedCorner {
        stated,
        names,
        corner,
        ..
    } = imported;
    let radius = number(stated, names, "wheel_radius", corner.stated_side)?;
    let (unit, _) = imported.unit();
    let value = match radius.unit.filter(|stated| *stated != unit) {
        Some(stated) => radius.value * (unit.metre() / stated.metre()),
        None => radius.value,
    };
    Some([format!("{value:?}"), stated.line(&radius.place)])
}

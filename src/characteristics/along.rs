//! The states along travel and along steering.

use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use suspension_core::DriveKind;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{From, Grid, Order, State, Unit, Visited, evenly_spaced};

/// From where to where, from the design position, as `-0.06:0.06`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span(pub [f64; 2]);

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let ends = text.split_once(':');
        let ends = ends.and_then(|(from, to)| Some([number(from)?, number(to)?]));
        match ends {
            Some([from, to]) if from < to => Ok(Self([from, to])),
            _ => Err("write FROM:TO, as -0.06:0.06".to_owned()),
        }
    }
}

/// The states along one drive.
pub struct Along {
    /// The drive's number.
    pub drive: usize,
    /// The drive's changes from the design position.
    pub changes: Vec<f64>,
    /// Each state, and the same with derivatives with respect to the drive.
    pub visited: Visited<(State, Option<State>)>,
}

/// Places of each curve.
const PLACES: usize = 61;

/// How far travel and steering go either way without a span, in metres, and as an angle.
const USUAL: [f64; 2] = [0.06, 0.03];
const USUAL_ANGLE: f64 = 0.2;

/// The states along travel, and along steering where a drive steers; spans are in `unit`.
///
/// # Errors
///
/// [`Failure::Input`] where no drive is known to move the wheel up and down.
pub fn ways(
    mechanism: &dyn Kinematics,
    file: &str,
    spans: [Option<Span>; 2],
    unit: Unit,
    interrupted: &AtomicBool,
) -> Result<Vec<Along>, Failure> {
    let names = &mechanism.names;
    if names.vehicle.travel.is_none() {
        let known = names.of_drives().join(", ");
        return Err(Failure::Input(format!(
            "{file}: which drive moves the wheel up and down? Write [vehicle] with travel = \"NAME\"; the drives are {known}"
        )));
    }
    let drives = [names.vehicle.travel, names.vehicle.steer];
    let each = drives.into_iter().zip(spans).zip(USUAL);
    let ways = each.filter_map(|((drive, span), metres)| {
        let drive = drive?;
        let metre = mechanism.unit.metre();
        let span = match (span, names.drives[drive].kind) {
            (Some(Span(ends)), DriveKind::Coordinate) => ends.map(|end| end / unit.metre() * metre),
            (Some(Span(ends)), DriveKind::Angle) => ends,
            (None, DriveKind::Coordinate) => [-metres, metres].map(|end| end * metre),
            (None, DriveKind::Angle) => [-USUAL_ANGLE, USUAL_ANGLE],
        };
        Some(along(mechanism, drive, span, interrupted))
    });
    Ok(ways.collect())
}

fn along(
    mechanism: &dyn Kinematics,
    drive: usize,
    span: [f64; 2],
    interrupted: &AtomicBool,
) -> Along {
    let changes = evenly_spaced(span, PLACES);
    let axes = vec![(drive, changes.clone())];
    // So few places are never too many.
    let grid = Grid::new(mechanism, axes, From::Start).unwrap_or_default();
    let mut read =
        |state: &State, per: &dyn Fn(usize) -> Option<State>| (state.clone(), per(drive));
    Along {
        drive,
        changes,
        visited: mechanism.visit(&grid, Order::First, interrupted, &mut read),
    }
}

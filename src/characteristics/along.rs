//! The states along travel and along steering.

use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use suspension_core::DriveKind;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{From, Grid, Names, Order, Place, State, Unit, Visited, evenly_spaced};

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

/// A drive of travel or of steering.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way {
    /// The drive's number.
    pub drive: usize,
    /// `travel` or `steer`; with several such drives the second is `travel 2`.
    pub name: String,
    is_travel: bool,
}

impl Way {
    /// Those of a mechanism, travel first.
    pub fn all(names: &Names) -> Vec<Self> {
        let vehicle = &names.vehicle;
        let kinds = [("travel", &vehicle.travel), ("steer", &vehicle.steer)];
        let each = kinds.into_iter().flat_map(|(kind, drives)| {
            let numbered = (1..).zip(drives);
            numbered.map(move |(number, drive)| Self {
                drive: *drive,
                name: match number {
                    1 => kind.to_owned(),
                    number => format!("{kind} {number}"),
                },
                is_travel: kind == "travel",
            })
        });
        each.collect()
    }
}

/// The states along one drive.
pub struct Along {
    /// The drive.
    pub way: Way,
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

/// The states along travel, of several wheels along each drive, and along steering where a drive steers; spans are in `unit`.
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
    if names.vehicle.travel.is_empty() {
        let known = names.of_drives().join(", ");
        return Err(Failure::Input(format!(
            "{file}: which drive moves the wheel up and down? Write [vehicle] with travel = \"NAME\"; the drives are {known}"
        )));
    }
    let along = |way: Way| {
        let of = usize::from(!way.is_travel);
        let (span, metres) = (spans[of], USUAL[of]);
        let metre = mechanism.unit.metre();
        let span = match (span, names.drives[way.drive].kind) {
            (Some(Span(ends)), DriveKind::Coordinate) => ends.map(|end| end / unit.metre() * metre),
            (Some(Span(ends)), DriveKind::Angle) => ends,
            (None, DriveKind::Coordinate) => [-metres, metres].map(|end| end * metre),
            (None, DriveKind::Angle) => [-USUAL_ANGLE, USUAL_ANGLE],
        };
        along(mechanism, way, span, interrupted)
    };
    Ok(Way::all(names).into_iter().map(along).collect())
}

fn along(mechanism: &dyn Kinematics, way: Way, span: [f64; 2], interrupted: &AtomicBool) -> Along {
    let changes = evenly_spaced(span, PLACES);
    let axes = vec![(way.drive, changes.clone())];
    // So few places are never too many.
    let grid = Grid::new(mechanism, axes, From::Start).unwrap_or_default();
    let mut read = |place: &dyn Place| (place.state(), place.per(way.drive));
    let visited = mechanism.visit(&grid, Order::First, interrupted, &mut read);
    Along {
        way,
        changes,
        visited,
    }
}

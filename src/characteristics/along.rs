//! The states along travel, in heave and in roll of an axle, and along steering.

use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use suspension_core::DriveKind;

use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{
    Axis, From, Grid, Names, Order, Pair, Place, State, Unit, Visited, Wheel, evenly_spaced,
};
use crate::number::number;

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
            Some(_) => Err("FROM is less than TO, as in -0.06:0.06".to_owned()),
            None => Err("write FROM:TO, as -0.06:0.06".to_owned()),
        }
    }
}

/// What drives do, in any listing.
const TRAVEL: &str = "travel";
const STEER: &str = "steer";

/// A drive of travel or of steering.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Way {
    /// The drive's number.
    pub drive: usize,
    /// `travel` or `steer`; with several such drives the second is `travel 2`.
    pub name: String,
}

impl Way {
    /// Those of a mechanism, travel first.
    pub fn all(names: &Names) -> Vec<Self> {
        let vehicle = &names.vehicle;
        let kinds = [(TRAVEL, &vehicle.travel), (STEER, &vehicle.steer)];
        let each = kinds.into_iter().flat_map(|(kind, drives)| {
            let of_one = move |(number, drive): (usize, &usize)| Self {
                drive: *drive,
                name: numbered(kind, number),
            };
            (1..).zip(drives).map(of_one)
        });
        each.collect()
    }
}

/// The states along a drive, or along several that move together.
pub struct Along {
    /// What it is called: the name of the drive, `heave`, `roll`.
    pub title: String,
    /// What it does, in any listing: `travel`, `steer`, `roll`; of a second axle or wheel `travel 2`.
    pub way: String,
    /// What moves, in words.
    pub moved: String,
    /// The drives, by number, each with the part of the change that it moves by.
    pub drives: Vec<(usize, f64)>,
    /// What the change is.
    pub kind: DriveKind,
    /// The changes from the design position.
    pub changes: Vec<f64>,
    /// Each state, and the same with derivatives with respect to each of the drives.
    pub visited: Visited<(State, Vec<Option<State>>)>,
}

/// What there is to move along.
struct Course {
    title: String,
    kind: &'static str,
    moved: String,
    drives: Vec<(usize, f64)>,
}

impl Course {
    fn of_drive(names: &Names, drive: usize, kind: &'static str) -> Self {
        let title = names.drives[drive].name.clone();
        Self {
            moved: format!("change of {title}"),
            title,
            kind,
            drives: vec![(drive, 1.0)],
        }
    }

    /// Heave and roll of each axle whose wheels have a drive of travel each, travel of all other wheels; steering.
    fn all(mechanism: &dyn Kinematics, interrupted: &AtomicBool) -> Vec<Self> {
        let names = &mechanism.names;
        let upwards = upwards(mechanism, interrupted);
        let mut of_axles = Vec::new();
        let mut courses = Vec::new();
        for pair in Pair::all(&names.wheels) {
            let [Some(a), Some(b)] = pair.wheels.map(|wheel| names.wheels[wheel].travel) else {
                continue;
            };
            if a == b || names.drives[a].kind != names.drives[b].kind {
                continue;
            }
            of_axles.extend([a, b]);
            let [first, second] = [a, b].map(|drive| names.drives[drive].name.as_str());
            let of_axle = |what: &str| format!("{} {what}", pair.name).trim_start().to_owned();
            let [up_a, up_b] = pair.wheels.map(|wheel| upwards[wheel]);
            courses.push(Self {
                title: of_axle("heave"),
                kind: TRAVEL,
                moved: format!("change of {first} and {second}"),
                drives: vec![(a, up_a), (b, up_b)],
            });
            courses.push(Self {
                title: of_axle("roll"),
                kind: "roll",
                moved: format!("{first} up, {second} down"),
                drives: vec![(a, up_a), (b, -up_b)],
            });
        }
        let vehicle = &names.vehicle;
        let others = vehicle
            .travel
            .iter()
            .filter(|drive| !of_axles.contains(drive));
        courses.extend(others.map(|drive| Self::of_drive(names, *drive, TRAVEL)));
        courses.extend(
            vehicle
                .steer
                .iter()
                .map(|drive| Self::of_drive(names, *drive, STEER)),
        );
        courses
    }
}

/// Of each wheel, which way its drive of travel must change to raise it.
fn upwards(mechanism: &dyn Kinematics, interrupted: &AtomicBool) -> Vec<f64> {
    let wheels = &mechanism.names.wheels;
    let mut read = |place: &dyn Place| -> Vec<f64> {
        let state = place.state();
        let rises = |wheel: &Wheel| {
            let velocities = state.moved_by(wheel.travel?)?;
            let [_, centre] = wheel.points.axis;
            Some(state.axes.turned(velocities.value[centre]).z)
        };
        let sign = |wheel| rises(wheel).map_or(1.0, f64::signum);
        wheels.iter().map(sign).collect()
    };
    let here = Grid::new(mechanism, Vec::new(), From::Start).unwrap_or_default();
    let visited = mechanism.visit(&here, Order::First, interrupted, &mut read);
    let mut places = visited.places.into_iter().flatten();
    places.next().unwrap_or_else(|| vec![1.0; wheels.len()])
}

/// Places of each curve.
const PLACES: usize = 61;

/// How far travel and steering go either way without a span, in metres, and as an angle.
const USUAL: [f64; 2] = [0.06, 0.03];
const USUAL_ANGLE: f64 = 0.2;

/// No drive of a wheel goes further from end to end, in metres.
const LONGEST: f64 = 1.0;

/// The states in heave and roll of axles, along travel of single wheels, and along steering where a drive steers; spans are in
/// `unit`, that of travel is also that of heave and roll.
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
    let mut ways: Vec<Along> = Vec::new();
    for course in Course::all(mechanism, interrupted) {
        let of = usize::from(course.kind == STEER);
        let kind = names.drives[course.drives[0].0].kind;
        let (span, metres) = (spans[of], USUAL[of]);
        let metre = mechanism.unit.metre();
        let span = match (span, kind) {
            (Some(span), DriveKind::Coordinate) => {
                note_length(file, &course.title, span, unit);
                span.0.map(|end| end / unit.metre() * metre)
            }
            (Some(Span(ends)), DriveKind::Angle) => ends,
            (None, DriveKind::Coordinate) => [-metres, metres].map(|end| end * metre),
            (None, DriveKind::Angle) => [-USUAL_ANGLE, USUAL_ANGLE],
        };
        let is_same = |way: &&Along| way.way.split(' ').next() == Some(course.kind);
        let number = 1 + ways.iter().filter(is_same).count();
        ways.push(along(mechanism, course, number, (kind, span), interrupted));
    }
    Ok(ways)
}

/// Says so where a span is in another unit, as it seems.
fn note_length(file: &str, way: &str, Span([from, to]): Span, unit: Unit) {
    if to - from > LONGEST * unit.metre() {
        let symbol = unit.symbol();
        let [from, to] = [from, to].map(number);
        eprintln!(
            "note: {file}: {way} is from {from} {symbol} to {to} {symbol}: is it in another unit?"
        );
    }
}

fn along(
    mechanism: &dyn Kinematics,
    course: Course,
    number: usize,
    (kind, span): (DriveKind, [f64; 2]),
    interrupted: &AtomicBool,
) -> Along {
    let Course {
        title,
        kind: way,
        moved,
        drives,
    } = course;
    let changes = evenly_spaced(span, PLACES);
    let axis = Axis {
        drives: drives.clone(),
        values: changes.clone(),
    };
    // So few places are never too many.
    let grid = Grid::new(mechanism, vec![axis], From::Start).unwrap_or_default();
    let mut read = |place: &dyn Place| {
        let per = drives.iter().map(|(drive, _)| place.per(*drive));
        (place.state(), per.collect())
    };
    let visited = mechanism.visit(&grid, Order::First, interrupted, &mut read);
    Along {
        title,
        way: numbered(way, number),
        moved,
        drives,
        kind,
        changes,
        visited,
    }
}

/// `travel`, `travel 2`.
fn numbered(kind: &str, number: usize) -> String {
    match number {
        1 => kind.to_owned(),
        number => format!("{kind} {number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_span_is_refused_with_what_is_wrong() {
        assert_eq!("-0.03 : 0.04".parse(), Ok(Span([-0.03, 0.04])));
        for (text, expected) in [
            ("0.03", "write FROM:TO, as -0.06:0.06"),
            ("a:1", "write FROM:TO, as -0.06:0.06"),
            ("0:inf", "write FROM:TO, as -0.06:0.06"),
            ("0.03:-0.03", "FROM is less than TO, as in -0.06:0.06"),
            ("0:0", "FROM is less than TO, as in -0.06:0.06"),
        ] {
            assert_eq!(text.parse::<Span>(), Err(expected.to_owned()));
        }
    }
}

//! What there is to move along: heave and roll of axles, travel of single wheels, steering.

use std::sync::atomic::AtomicBool;

use crate::characteristics::way::{ROLL, STEER, TRAVEL};
use crate::kinematics::Kinematics;
use crate::mechanism::{From, Grid, Names, Order, Pair, Place, Wheel};

/// What there is to move along.
pub(super) struct Course {
    /// What it is called.
    pub(super) title: String,
    /// What it does, in any listing.
    pub(super) kind: &'static str,
    /// What moves, in words.
    pub(super) moved: String,
    /// The drives, by number, each with its part.
    pub(super) drives: Vec<(usize, f64)>,
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
    pub(super) fn all(mechanism: &dyn Kinematics, interrupted: &AtomicBool) -> Vec<Self> {
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
                moved: format!("{first} and {second}, both upwards"),
                drives: vec![(a, up_a), (b, up_b)],
            });
            courses.push(Self {
                title: of_axle("roll"),
                kind: ROLL,
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

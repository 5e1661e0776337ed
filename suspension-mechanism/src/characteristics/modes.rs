//! The modes in which curves move wheels: heave and roll of axles, travel of single wheels, steering.

use std::collections::BTreeSet;

use nalgebra::{Matrix2, Vector2};
use suspension_core::listing::DriveKind;

use crate::characteristics::movement::Effect;
use crate::kinematics::Kinematics;
use crate::mechanism::{Description, Drive, Names, Pair, Place, Wheel, quoted};

/// A mode in which wheels move.
pub struct Mode {
    /// Its name: that of the drive, or `heave`, or `roll`.
    pub title: String,
    /// The effect of its drives.
    pub effect: Effect,
    /// A description of what moves.
    pub moved: String,
    /// The drives, by number, each with its fraction of the change.
    pub drives: Vec<(usize, f64)>,
    /// The kind of the change.
    pub kind: DriveKind,
    /// How far the wheels rise per change in travel; `None` in roll and steering, and where it is unknown.
    pub rise: Option<f64>,
}

impl Mode {
    /// `way` is the sign of the drive's fraction.
    fn for_drive(names: &Names, drive: usize, effect: Effect, way: f64) -> Self {
        let Drive { name, kind } = &names.drives[drive];
        let (title, moved) = if way < 0.0 {
            (
                format!("{name} upwards"),
                format!("change of {name}, upwards"),
            )
        } else {
            (name.clone(), format!("change of {name}"))
        };
        Self {
            title,
            effect,
            moved,
            drives: vec![(drive, way)],
            kind: *kind,
            rise: None,
        }
    }

    /// Heave and roll of an axle, by its name and its wheels, with the drives of travel of these.
    fn heave_and_roll(
        names: &Names,
        rises: &RisePerDrive,
        (axle, wheels): (&str, [usize; 2]),
        travel: [usize; 2],
    ) -> [Self; 2] {
        let [first, second] = travel.map(|drive| names.drives[drive].name.as_str());
        let kind = names.drives[travel[0]].kind;
        let of_axle = |what: &str| format!("{axle} {what}").trim_start().to_owned();
        let drives = |parts: [f64; 2]| travel.into_iter().zip(parts).collect();
        let both = rises.parts(wheels, [1.0, 1.0]);
        let heave = Self {
            title: of_axle("heave"),
            effect: Effect::Travel,
            moved: format!("change of {first} and {second}, both upwards"),
            drives: drives(both),
            kind,
            rise: rises.rise_of_first(wheels, both),
        };
        let roll = Self {
            title: of_axle("roll"),
            effect: Effect::Roll,
            moved: format!("change of {first} upwards and of {second} downwards"),
            drives: drives(rises.parts(wheels, [1.0, -1.0])),
            kind,
            rise: None,
        };
        [heave, roll]
    }

    /// Heave and roll of each axle whose wheels have a drive of travel each, travel of all other wheels, and
    /// steering.
    pub(super) fn all(mechanism: &dyn Kinematics) -> Vec<Self> {
        let names = &mechanism.names;
        let rises = RisePerDrive::compute(mechanism);
        let mut of_axles = Vec::new();
        let mut modes = Vec::new();
        for pair in Pair::all(&names.wheels) {
            let wheels = left_first(mechanism, pair.wheels);
            let [Some(a), Some(b)] = wheels.map(|wheel| names.wheels[wheel].travel) else {
                continue;
            };
            if a != b && names.drives[a].kind == names.drives[b].kind {
                of_axles.extend([a, b]);
                modes.extend(Self::heave_and_roll(
                    names,
                    &rises,
                    (&pair.name, wheels),
                    [a, b],
                ));
            }
        }
        let vehicle = &names.vehicle;
        let others = vehicle
            .travel
            .iter()
            .filter(|drive| !of_axles.contains(drive));
        modes.extend(others.map(|drive| {
            let mut wheels = names.wheels.iter();
            let wheel = wheels.position(|wheel| wheel.travel == Some(*drive));
            let way = wheel.map_or(1.0, |wheel| rises.upwards(wheel));
            Self {
                rise: wheel.and_then(|wheel| Some(way * rises.rise_per_drive(wheel, wheel)?)),
                ..Self::for_drive(names, *drive, Effect::Travel, way)
            }
        }));
        let steer = vehicle.steer.iter();
        modes.extend(steer.map(|drive| Self::for_drive(names, *drive, Effect::Steer, 1.0)));
        modes
    }
}

/// A sentence on drives of travel that become less as their wheels rise, as z of SAE axes and the length of a damper; `None`
/// if there are none.
pub fn counted_downwards(mechanism: &dyn Kinematics) -> Option<String> {
    let names = &mechanism.names;
    let rises = RisePerDrive::compute(mechanism);
    let wheels = names.wheels.iter().enumerate();
    let downwards = wheels.filter(|(wheel, _)| rises.upwards(*wheel) < 0.0);
    let drives: BTreeSet<usize> = downwards.filter_map(|(_, wheel)| wheel.travel).collect();
    let called = quoted(drives.iter().map(|drive| &names.drives[*drive].name));
    let verb = if drives.len() == 1 {
        "becomes"
    } else {
        "become"
    };
    (!drives.is_empty()).then(|| {
        format!(
            "As the wheel rises, {called} {verb} less: derivatives per {called} have the opposite sign of those per wheel travel."
        )
    })
}

/// Both wheels of an axle, the left one first, in whichever order a listing states them.
fn left_first(mechanism: &Description, [one, other]: [usize; 2]) -> [usize; 2] {
    let points_left = |wheel: usize| {
        let axis = mechanism.names.wheels[wheel].design;
        axis.is_none_or(|[inner, centre]| mechanism.axes.turned(centre - inner).y >= 0.0)
    };
    if points_left(one) {
        [one, other]
    } else {
        [other, one]
    }
}

/// The rise of each wheel per drive of travel of each wheel, at the design position.
struct RisePerDrive(Vec<Vec<Option<f64>>>);

impl RisePerDrive {
    fn compute(mechanism: &dyn Kinematics) -> Self {
        let wheels = &mechanism.names.wheels;
        let mut read = |place: &dyn Place| {
            let state = place.state();
            let rise = |wheel: &Wheel, of: &Wheel| {
                let velocities = state.moved_by(of.travel?)?;
                let [_, centre] = wheel.points.axis;
                Some(state.axes.turned(velocities.value[centre]).z)
            };
            let row = |wheel| wheels.iter().map(|of| rise(wheel, of)).collect();
            Self(wheels.iter().map(row).collect())
        };
        mechanism.at_start(&mut read).unwrap_or(Self(Vec::new()))
    }

    fn rise_per_drive(&self, wheel: usize, drive_of: usize) -> Option<f64> {
        *self.0.get(wheel)?.get(drive_of)?
    }

    /// The sign of the change of a wheel's drive of travel that raises it.
    fn upwards(&self, wheel: usize) -> f64 {
        self.rise_per_drive(wheel, wheel).map_or(1.0, f64::signum)
    }

    /// The rise of the first of two wheels per change of both their drives by these fractions.
    fn rise_of_first(&self, [first, second]: [usize; 2], parts: [f64; 2]) -> Option<f64> {
        let [own, other] = [first, second].map(|of| self.rise_per_drive(first, of));
        Some(own? * parts[0] + other? * parts[1])
    }

    /// The fractions of both wheels' drives that make the wheels rise as given; the larger is 1.
    fn parts(&self, [left, right]: [usize; 2], rise: [f64; 2]) -> [f64; 2] {
        let rises = |of: usize| {
            Some(Vector2::new(
                self.rise_per_drive(left, of)?,
                self.rise_per_drive(right, of)?,
            ))
        };
        let solved = || {
            let rises = Matrix2::from_columns(&[rises(left)?, rises(right)?]);
            let parts = rises.try_inverse()? * Vector2::from(rise);
            let scaled = parts / parts.amax();
            let finite = scaled.iter().all(|part| part.is_finite());
            finite.then(|| scaled.map(round_to_whole).into())
        };
        let [up_left, up_right] = [left, right].map(|wheel| self.upwards(wheel));
        solved().unwrap_or([up_left * rise[0], up_right * rise[1]])
    }
}

/// A fraction rounded to a whole number if it differs from it only by rounding, so that drives go to round values.
fn round_to_whole(part: f64) -> f64 {
    let whole = part.round();
    if (part - whole).abs() < 1e-9 {
        whole
    } else {
        part
    }
}

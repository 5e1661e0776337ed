//! The steering wheel: the ratio and the direction in which it moves the drive of steering.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use suspension_core::Values;
use toml::Spanned;

use crate::failure::Failure;
use crate::mechanism::{Names, SteeringWheel, Suspension, quoted};
use crate::prepare::design::Design;
use crate::prepare::task::Task;
use crate::prepare::vehicle::usual_drives::{turn_rate, turns};
use crate::prepare::vehicle::{checked, is_positive, length};

const RACK: &str = SteeringWheel::RACK;
const BOX: &str = SteeringWheel::BOX;

/// A file's statement about a steering wheel.
struct Gear<'a> {
    key: &'static str,
    /// Whether it belongs to a drive that is an angle.
    is_of_angle: bool,
    stated: &'a Spanned<f64>,
}

/// The steering wheel of a file that states how far it moves its drive; `names` are those in effect.
///
/// # Errors
///
/// [`Failure::Input`] if the statement is not positive and finite, and if the number of drives of its kind that steer
/// is not one.
pub(crate) fn steering_wheel<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    names: &Names,
    design: &Design<L, N>,
) -> Result<Option<SteeringWheel>, Failure> {
    let gears = gears(task);
    if gears.is_empty() || is_singular(names, design) {
        return Ok(None);
    }
    let turned = Turned::all(names, design);
    let about_z: f64 = turned.iter().map(|turned| turned.about_z).sum();
    // In SAE axes z points down, and a positive turn about it is to the right.
    let up = task.file.axes.turned(Vector3::<f64>::z()).z;
    let drives = design.drives_in_file(&design.drives);
    let wheels = gears.into_iter().map(|gear| {
        let drive = gear.drive(names, &turned);
        let drive = drive.map_err(|message| task.source.refuse(&gear.stated.span(), message))?;
        let per_turn = gear.per_turn(task)?;
        Ok(per_turn.map(|per_turn| SteeringWheel {
            drive,
            turned: turned.iter().map(|turned| turned.wheel).collect(),
            per_turn: per_turn.copysign(about_z * up),
            design: drives[drive],
        }))
    });
    // One of two gears is not of the drive's kind.
    Ok(wheels.collect::<Result<Vec<_>, Failure>>()?.pop().flatten())
}

/// Whether a drive of steering has no rates at the design position: this is reported elsewhere, and no other drive
/// would help.
fn is_singular<L: Suspension<N>, const N: usize>(names: &Names, design: &Design<L, N>) -> bool {
    let drives = names.wheels.iter().filter_map(|wheel| wheel.steer);
    drives
        .map(|drive| design.per(drive))
        .any(|rates| rates.is_none())
}

/// The statements of a file, by either key.
fn gears<'a>(task: &'a Task<'_>) -> Vec<Gear<'a>> {
    let vehicle = task.file.vehicle.get_ref();
    let keys = [
        (RACK, false, &vehicle.rack_per_turn),
        (BOX, true, &vehicle.steering_box_ratio),
    ];
    let gear = |(key, is_of_angle, stated): (_, _, &'a Option<_>)| {
        stated.as_ref().map(|stated| Gear {
            key,
            is_of_angle,
            stated,
        })
    };
    keys.into_iter().filter_map(gear).collect()
}

impl Gear<'_> {
    /// The change of the drive per turn, in the unit of lengths or in radians.
    fn per_turn(&self, task: &Task<'_>) -> Result<Option<f64>, Failure> {
        if !self.is_of_angle {
            return length(task, self.key, Some(self.stated));
        }
        let ratio = checked(task, Some(self.stated), is_positive, || {
            format!(
                "{BOX} is not a positive finite number; write the steering wheel's angle per angle of the pitman arm, for example 16.0"
            )
        })?;
        Ok(ratio.map(|ratio| TAU / ratio))
    }

    /// The drive that the steering wheel moves, or a sentence that says why there is none.
    fn drive(&self, names: &Names, turned: &[Turned]) -> Result<usize, String> {
        let mut drives: Vec<usize> = turned.iter().map(|turned| turned.drive).collect();
        drives.sort_unstable();
        drives.dedup();
        let name = |drive: usize| &names.drives[drive].name;
        let key = self.key;
        match *drives {
            [] => Err(format!(
                "{key} needs a drive that steers a wheel, and no known drive of steering does; write steer = \"NAME\" under \
                 [vehicle] with the name of one that does, or leave {key} out"
            )),
            [drive] if names.drives[drive].kind.is_angle() != self.is_of_angle => {
                Err(self.describe_wrong_kind(name(drive)))
            }
            [drive] => Ok(drive),
            _ => {
                let names = quoted(drives.into_iter().map(name));
                Err(format!(
                    "{key} needs one drive of steering, but {names} steer the wheels; leave {key} out"
                ))
            }
        }
    }

    fn describe_wrong_kind(&self, drive: &str) -> String {
        if self.is_of_angle {
            format!(
                "{BOX} is for a drive that is an angle, but the drive that steers, `{drive}`, is not; leave {BOX} out and write {RACK}, the \
                 drive's travel per turn of the steering wheel"
            )
        } else {
            format!(
                "{RACK} is the travel of a rack, but the drive that steers, `{drive}`, is an angle; leave {RACK} out and write {BOX}, the \
                 steering wheel's angle per angle of the drive, for example 16.0"
            )
        }
    }
}

/// A wheel that its drive of steering turns at the design position.
struct Turned {
    wheel: usize,
    drive: usize,
    /// The rate of turning about the file's z axis.
    about_z: f64,
}

impl Turned {
    fn all<L: Suspension<N>, const N: usize>(names: &Names, design: &Design<L, N>) -> Vec<Self> {
        let points: Vec<_> = design.points.values().collect();
        let size = design.model.size();
        let wheels = names.wheels.iter().enumerate();
        let turned = wheels.filter_map(|(number, wheel)| {
            let drive = wheel.steer?;
            let rates = design.per(drive)?;
            turns(wheel, (&points, &rates), size).then(|| Self {
                wheel: number,
                drive,
                about_z: turn_rate(wheel, &points, &rates),
            })
        });
        turned.collect()
    }
}

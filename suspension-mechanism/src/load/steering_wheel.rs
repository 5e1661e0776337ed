//! The steering wheel: how far it moves the drive of steering, and which way.

use nalgebra::Vector3;
use suspension_core::Values;
use toml::Spanned;

use crate::failure::Failure;
use crate::load::design::Design;
use crate::load::task::Task;
use crate::load::usual_drives::{turn_rate, turns};
use crate::load::vehicle::length;
use crate::mechanism::{Names, SteeringWheel, Suspension};

/// The steering wheel of a file that states the travel of its drive per turn; `names` are those in effect.
///
/// # Errors
///
/// [`Failure::Input`] where that travel is not positive and finite, and where not one drive that is a coordinate steers.
pub(super) fn steering_wheel<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    names: &Names,
    design: &Design<L, N>,
) -> Result<Option<SteeringWheel>, Failure> {
    let vehicle = task.file.vehicle.as_ref().map(Spanned::get_ref);
    let Some(stated) = vehicle.and_then(|vehicle| vehicle.rack_per_turn.as_ref()) else {
        return Ok(None);
    };
    let Some(travel) = length(task, "rack_per_turn", Some(stated))? else {
        return Ok(None);
    };
    let turned = Turned::all(names, design);
    let drive = drive(names, &turned);
    let drive = drive.map_err(|message| task.source.refuse(&stated.span(), message))?;
    let about_z: f64 = turned.iter().map(|turned| turned.about_z).sum();
    // In SAE axes z points down, and a turn about it is one to the right.
    let up = task.file.axes.turned(Vector3::<f64>::z()).z;
    Ok(Some(SteeringWheel {
        drive,
        turned: turned.into_iter().map(|turned| turned.wheel).collect(),
        per_turn: travel.copysign(about_z * up),
        design: design.given(&design.drives)[drive],
    }))
}

/// The drive that the steering wheel moves, or why there is none, in words.
fn drive(names: &Names, turned: &[Turned]) -> Result<usize, String> {
    let mut drives: Vec<usize> = turned.iter().map(|turned| turned.drive).collect();
    drives.sort_unstable();
    drives.dedup();
    let name = |drive: usize| format!("`{}`", names.drives[drive].name);
    match *drives {
        [] => Err(
            "rack_per_turn needs a drive that steers a wheel, and no known drive of steering does; write steer = \"NAME\" under \
             [vehicle] with the name of one that does, or leave rack_per_turn out"
                .to_owned(),
        ),
        [drive] if names.drives[drive].kind.is_angle() => Err(format!(
            "rack_per_turn is the travel of a rack, and the drive that steers, {}, is an angle; leave rack_per_turn out",
            name(drive)
        )),
        [drive] => Ok(drive),
        _ => {
            let names: Vec<String> = drives.into_iter().map(name).collect();
            Err(format!(
                "rack_per_turn is the travel of one rack, and several drives steer the wheels, {}; leave rack_per_turn out",
                names.join(" and ")
            ))
        }
    }
}

/// A wheel that its drive of steering turns at the design position.
struct Turned {
    wheel: usize,
    drive: usize,
    /// How fast, about the file's z axis.
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

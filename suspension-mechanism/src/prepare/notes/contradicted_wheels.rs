//! Statements of a file about wheels that the mechanism at its design contradicts.

use nalgebra::Vector3;
use suspension_core::Values;

use crate::file::Torque;
use crate::mechanism::{Axle, Names, Suspension, Wheel};
use crate::number::{number, rounded};
use crate::prepare::design::Design;
use crate::prepare::task::Task;
use crate::prepare::vehicle::is_stated;
use crate::prepare::vehicle::usual_drives::{rises, turns};

/// The permitted difference between the wheelbase and the distance between the axles, as a fraction of it.
const OFF: f64 = 0.05;

/// How many times as far as its own wheel a crossed drive must move another.
const FAR: f64 = 10.0;

/// Notes on wheels, at the design; `names` has what the design says of each.
pub(in crate::prepare) fn notes<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    names: &Names,
) -> Vec<String> {
    let points: Vec<_> = design.points.values().collect();
    let of_car = wheelbase(task, &points).into_iter();
    let mut notes: Vec<String> = of_car.chain(drive_torque(task, &names.wheels)).collect();
    let vehicle = task.file.vehicle.get_ref();
    let of_wheel = |wheel: &Wheel| {
        let travel = wheel.travel.filter(|_| is_stated(&vehicle.travel, wheel));
        let steer = wheel.steer.filter(|_| is_stated(&vehicle.steer, wheel));
        [
            travel.and_then(|drive| unlifted(task, (wheel, drive), &design.per(drive)?)),
            steer.and_then(|drive| {
                let size = design.model.size();
                unsteered(task, (wheel, drive), (&points, &design.per(drive)?), size)
            }),
        ]
    };
    notes.extend(task.names.wheels.iter().flat_map(of_wheel).flatten());
    if vehicle.steer.is_none() {
        notes.extend(steered_alone(task, design, &points));
    }
    notes
}

/// A note that the wheelbase differs from that of the points.
fn wheelbase(task: &Task<'_>, points: &[Vector3<f64>]) -> Option<String> {
    let stated = task.names.vehicle.wheelbase?;
    let middle = |axle| {
        let wheels = task.names.wheels.iter();
        let of_axle = wheels.filter(|wheel| Axle::from_wheel_name(&wheel.name) == Some(axle));
        let along: Vec<f64> = of_axle
            .map(|wheel| points[wheel.points.axis[1]].x)
            .collect();
        (!along.is_empty()).then(|| along.iter().sum::<f64>() / along.len() as f64)
    };
    let apart = (middle(Axle::Front)? - middle(Axle::Rear)?).abs();
    let (unit, stated_in_words) = (task.file.unit().symbol(), number(stated));
    ((stated - apart).abs() > OFF * apart).then(|| {
        let apart = rounded(apart, 4);
        format!("wheelbase is {stated_in_words} {unit}, but the wheel centres of the axles are {apart} {unit} apart")
    })
}

/// A note that a drive moves up and down another wheel than the stated one, or none.
fn unlifted(
    task: &Task<'_>,
    (wheel, drive): (&Wheel, usize),
    rates: &[Vector3<f64>],
) -> Option<String> {
    let names = &task.names;
    let lift = |wheel: &Wheel| rates[wheel.points.axis[1]].z.abs();
    let others = names.wheels.iter();
    let most = others.max_by(|a, b| lift(a).total_cmp(&lift(b)))?;
    (lift(most) > FAR * lift(wheel)).then(|| {
        let drive = &names.drives[drive].name;
        format!(
            "travel of the {} is `{drive}`, which moves the {}: are the drives of travel crossed?",
            wheel.title("wheel"),
            most.title("wheel")
        )
    })
    .or_else(|| {
        (!rises(wheel, rates)).then(|| {
            let (wheel, drive) = (wheel.title("wheel"), &names.drives[drive].name);
            format!("travel of the {wheel} is `{drive}`, which does not move it up or down: is it another drive?")
        })
    })
}

/// A note that a drive does not turn the wheel that it is said to steer.
fn unsteered(
    task: &Task<'_>,
    (wheel, drive): (&Wheel, usize),
    (points, rates): (&[Vector3<f64>], &[Vector3<f64>]),
    size: f64,
) -> Option<String> {
    (!turns(wheel, (points, rates), size)).then(|| {
        let drive = &task.names.drives[drive].name;
        let wheel = wheel.title("wheel");
        format!("steer of the {wheel} is `{drive}`, which does not turn it: is it another drive?")
    })
}

/// A note that the usual drive of steering turns one wheel of an axle and not the other, for example if nothing moves
/// the image of a rack.
fn steered_alone<L: Suspension<N>, const N: usize>(
    task: &Task<'_>,
    design: &Design<L, N>,
    points: &[Vector3<f64>],
) -> Option<String> {
    let size = design.model.size();
    let wheels = &task.names.wheels;
    let is_turned = |wheel: &Wheel| {
        let rates = design.per(wheel.steer?)?;
        Some(turns(wheel, (points, &rates), size))
    };
    let centre = |wheel: &Wheel| points[wheel.points.axis[1]];
    let is_beside = |one: &Wheel, other: &Wheel| {
        Axle::from_wheel_name(&one.name) == Axle::from_wheel_name(&other.name)
            && one.steer == other.steer
            && centre(one).y * centre(other).y < 0.0
    };
    let pairs = wheels
        .iter()
        .flat_map(|one| wheels.iter().map(move |other| (one, other)));
    let mut pairs = pairs.filter(|(one, other)| is_beside(one, other));
    let (turned, still) = pairs
        .find(|(one, other)| is_turned(one) == Some(true) && is_turned(other) == Some(false))?;
    let drive = &task.names.drives[turned.steer?].name;
    let [turned, still] = [turned, still].map(|wheel| wheel.title("wheel"));
    Some(format!(
        "the drive `{drive}` turns the {turned} and not the {still}: to steer both it moves one end of a rack, whose other end a link \
         joins to it; `suspension list steered_axle` shows how"
    ))
}

/// A note on what bears the torque of a driven axle whose wheels move each other, or of a driven wheel in the middle, if the
/// file leaves that open.
fn drive_torque(task: &Task<'_>, wheels: &[Wheel]) -> Option<String> {
    let vehicle = task.file.vehicle.get_ref();
    if vehicle.drive_share.is_none() || vehicle.drive_torque.is_some() {
        return None;
    }
    let note = |wheel: &Wheel| {
        wheel.drive_share?;
        if wheel.drive_torque == Torque::Carrier {
            Some(ON_ONE_BODY)
        } else if wheel.coupling.is_coupled() {
            Some(COUPLED)
        } else {
            wheel.is_in_middle.then_some(IN_THE_MIDDLE)
        }
    };
    wheels.iter().find_map(note).map(str::to_owned)
}

const ON_ONE_BODY: &str = "one body carries both driven wheels, so it is assumed to contain the differential and to bear the torque of \
     the drive; to confirm this write drive_torque = \"carrier\" under [vehicle]; for a de Dion axle write \"chassis\"";

const COUPLED: &str = "the driven wheels move each other, and the chassis is assumed to bear the torque of the drive, through shafts; to \
     confirm this write drive_torque = \"chassis\" under [vehicle]; for a live axle with wheels on knuckles write \"carrier\"";

const IN_THE_MIDDLE: &str = "the driven wheel is in the middle, as of a motorcycle, and the chassis is assumed to bear the torque of the \
     drive; to confirm this write drive_torque = \"chassis\" under [vehicle]; for a motor in the wheel, or a shaft with its gears on the swing \
     arm, write \"carrier\"; a chain also pulls at the wheel: anti-squat with a chain follows from a load case, see docs/limits.md";

//! The motion itself: time, drives, points, and the rotation of the carrier.

use nalgebra::Vector3;
use suspension_core::body::{angular_acceleration, angular_velocity};

use crate::file::Dimension;
use crate::mechanism::{Names, State};
use crate::quantities::formulas::Reading;
use crate::quantities::number::Number;
use crate::quantities::quantity::{Quantity, Shown};
use crate::quantities::readings::{each, number, of_each_wheel, point, vector};

catalogue! {
    TIME: "time" {
        name: "t",
        sign: "",
        definition: "the instant",
        source: "the motion file",
        shown: Shown::InBoth,
        read: |_| number(Dimension::Time, |state| state.t),
    }
    DRIVES: "drives" {
        name: "",
        sign: "",
        definition: "the value that each prescribes; where a measure stands in for a drive, the value that the drive has there",
        source: "`drive` of the listing",
        shown: Shown::InBoth,
        read: |names| {
            let drives = names.drives.iter();
            let drives = drives.map(|drive| (drive.name.as_str(), drive.kind.into()));
            each(drives, false, |state, drive| Number::alone(state.drives[drive]))
        },
    }
    POSITIONS: "free points" {
        name: "",
        sign: "in the axes of the file",
        definition: "the unknowns of the equations",
        source: "`free` of the listing",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Dimension::Length),
    }
    VELOCITIES: "velocities of free points" {
        name: "",
        sign: "",
        definition: "J qdot = -dF/du udot",
        source: "Attia 2003, eq. (3)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Dimension::Velocity),
    }
    ACCELERATIONS: "accelerations of free points" {
        name: "",
        sign: "",
        definition: "J qddot = -C(qdot, qdot) - dF/du uddot",
        source: "Attia 2003, eq. (7) and (8)",
        shown: Shown::InTables,
        read: |names| of_free_points(names, Dimension::Acceleration),
    }
    OMEGA: "angular velocity of the wheel's carrier" {
        name: "omega",
        sign: "right-handed",
        definition: "the least-squares fit of v = v0 + omega x r over three points",
        source: "Attia 2003, eq. (9), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Dimension::AngularVelocity, |[omega, _]| omega),
    }
    ALPHA: "angular acceleration of the wheel's carrier" {
        name: "alpha",
        sign: "right-handed",
        definition: "the least-squares fit of a = a0 + alpha x r + omega x (omega x r) over three points",
        source: "Attia 2003, eq. (10), without its 0/0",
        shown: Shown::InTables,
        read: |names| of_carrier(names, Dimension::AngularAcceleration, |[_, alpha]| alpha),
    }
    MARKERS: "markers, with velocities and accelerations" {
        name: "",
        sign: "in the axes of the file",
        definition: "points carried by bodies",
        source: "`point` of the listing",
        shown: Shown::InTables,
        read: |names| {
            let markers = names.chassis + names.free..names.points.len();
            let of_one = |marker| RATES.map(|dimension| point(names, marker, dimension)).into_iter();
            markers.flat_map(of_one).flatten().collect()
        },
    }
}

/// The values read of each marker.
const RATES: [Dimension; 3] = [
    Dimension::Length,
    Dimension::Velocity,
    Dimension::Acceleration,
];

fn of_free_points<N: Number>(names: &Names, dimension: Dimension) -> Vec<Reading<N>> {
    let free = names.chassis..names.chassis + names.free;
    free.flat_map(|index| point(names, index, dimension))
        .collect()
}

/// A rate of the body that carries the wheel: its angular velocity or acceleration.
fn of_carrier<N: Number>(
    names: &Names,
    dimension: Dimension,
    which: fn([Vector3<f64>; 2]) -> Vector3<f64>,
) -> Vec<Reading<N>> {
    of_each_wheel(names, &|rolling| {
        let carrier = rolling.points.carrier;
        vector(None, dimension, move |state| {
            which(rotation(state, carrier))
        })
    })
}

/// Angular velocity and acceleration of the body of three points; not finite if they are collinear.
fn rotation(state: &State, body: [usize; 3]) -> [Vector3<f64>; 2] {
    let points = &state.points;
    let [at, rates, seconds] =
        [&points.value, &points.rate, &points.second_rate].map(|all| body.map(|point| all[point]));
    let omega = angular_velocity(&at, &rates);
    let alpha = omega.and_then(|omega| angular_acceleration(&at, &omega, &seconds));
    [omega, alpha].map(|found| found.unwrap_or_else(|| Vector3::repeat(f64::NAN)))
}

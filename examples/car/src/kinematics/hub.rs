//! The data of a corner that the equations of motion use.

use nalgebra::Vector3;
use suspension_core::{Linkage, Real, Signal, Values};

/// The wheel carrier's motion on the chassis, in chassis axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hub {
    /// Wheel centre, m.
    pub centre: Signal<Vector3<f64>>,
    /// Spin axis, of unit length, to the left: a wheel that rolls ahead spins positively about it.
    pub axis: Vector3<f64>,
    /// Angular velocity of the carrier, rad/s.
    pub turning: Vector3<f64>,
    /// Length of the strut, m, and its rate.
    pub strut: [f64; 2],
    /// The partial velocities of Kane's method.
    pub per_travel: PerTravel,
}

/// What one unit of travel changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerTravel {
    /// The wheel centre, m/m.
    pub centre: Vector3<f64>,
    /// The turn of the carrier, rad/m.
    pub turn: Vector3<f64>,
    /// The length of the strut, m/m: the motion ratio.
    pub strut: f64,
}

/// Points of a left wheel carrier: the wheel centre, one inboard of it on the spin axis, one beside that axis; positions, or rates.
pub type Marks = [Vector3<f64>; 3];

impl Hub {
    /// From the motion of the marks and the strut's length and rate; then from the rates of both per travel.
    pub fn new(
        marks: &Signal<Marks>,
        strut: [f64; 2],
        marks_per_travel: &Marks,
        strut_per_travel: f64,
    ) -> Self {
        let [centre, inner, _] = marks.value;
        Self {
            centre: marks.map(|[centre, ..]| *centre),
            axis: (centre - inner).normalize(),
            turning: angular_velocity(&marks.value, &marks.rate),
            strut,
            per_travel: PerTravel {
                centre: marks_per_travel[0],
                turn: angular_velocity(&marks.value, marks_per_travel),
                strut: strut_per_travel,
            },
        }
    }

    /// From all points of a linkage with their rates, and their derivatives per travel; `None` where the listing has no wheel or
    /// measures nothing.
    pub fn of<T, L, const N: usize>(
        model: &L,
        points: &Signal<L::Points>,
        per_travel: &Signal<L::Points>,
    ) -> Option<Self>
    where
        T: Real + Into<f64>,
        L: Linkage<N, Scalar = T>,
    {
        let marks = |of: &L::Points| -> Option<Marks> {
            let [inner, centre] = model.wheel_axis(of)?;
            let [beside, ..] = model.wheel_carrier(of)?;
            Some([centre, inner, beside].map(|mark| mark.map(Into::into)))
        };
        let motion = Signal {
            value: marks(&points.value)?,
            rate: marks(&points.rate)?,
            second_rate: marks(&points.second_rate)?,
        };
        let first = |measures: L::Measures| Some(measures.values().next()?.into());
        let [strut, by_travel] = [points, per_travel].map(|points| model.measures(points));
        Some(Self::new(
            &motion,
            [first(strut.value)?, first(strut.rate)?],
            &marks(&per_travel.rate)?,
            first(by_travel.rate)?,
        ))
    }

    /// The same corner on the right: its image in the plane y = 0. The travel is the left one's, the rack's is the opposite.
    pub fn mirrored(&self) -> Self {
        let polar = |v: &Vector3<f64>| Vector3::new(v.x, -v.y, v.z);
        // What turns is an axial vector.
        let axial = |v: &Vector3<f64>| Vector3::new(-v.x, v.y, -v.z);
        Self {
            centre: self.centre.map(polar),
            axis: axial(&self.axis),
            turning: axial(&self.turning),
            strut: self.strut,
            per_travel: PerTravel {
                centre: polar(&self.per_travel.centre),
                turn: axial(&self.per_travel.turn),
                strut: self.per_travel.strut,
            },
        }
    }
}

/// `a x a'` of the axis, and about it what the mark beside it adds.
fn angular_velocity(marks: &Marks, rates: &Marks) -> Vector3<f64> {
    let edges = |[centre, inner, beside]: &Marks| [centre - inner, beside - centre];
    let ([along, beside], [along_rate, beside_rate]) = (edges(marks), edges(rates));
    let across = along.cross(&along_rate) / along.norm_squared();
    let about = along.cross(&beside);
    let rest = about.dot(&(beside_rate - across.cross(&beside)));
    across + along * (rest / about.norm_squared())
}

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

/// The rates of the hub per unit of travel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PerTravel {
    /// The wheel centre, m/m.
    pub centre: Vector3<f64>,
    /// The turn of the carrier, rad/m.
    pub turn: Vector3<f64>,
    /// The length of the strut, m/m: the motion ratio.
    pub strut: f64,
}

/// Positions or rates of three points of a left wheel carrier: the wheel centre, a point inboard of it on the spin axis, and
/// a point off that axis.
pub type Marks = [Vector3<f64>; 3];

impl Hub {
    /// Computes the hub from the motion of the marks, the strut's length and rate, and the rates of both per travel.
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

    /// Computes the hub from all points of a linkage with their rates and their derivatives per travel; `None` if the
    /// listing has no wheel or no measure.
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

    /// Returns the hub of the right corner: the image in the plane y = 0. The travel is the same, the rack's position is the
    /// opposite.
    pub fn mirrored(&self) -> Self {
        let polar = |v: &Vector3<f64>| Vector3::new(v.x, -v.y, v.z);
        // Rotation vectors are axial.
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

/// Computes `a x a'` of the axis, and the rotation about the axis from the mark off it.
fn angular_velocity(marks: &Marks, rates: &Marks) -> Vector3<f64> {
    let edges = |[centre, inner, beside]: &Marks| [centre - inner, beside - centre];
    let ([along, beside], [along_rate, beside_rate]) = (edges(marks), edges(rates));
    let across = along.cross(&along_rate) / along.norm_squared();
    let about = along.cross(&beside);
    let rest = about.dot(&(beside_rate - across.cross(&beside)));
    across + along * (rest / about.norm_squared())
}

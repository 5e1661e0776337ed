//! What the equations of motion take of a corner.

use nalgebra::Vector3;
use suspension_core::body::angular_velocity;
use suspension_core::{Linkage, Real, Signal, Values};

/// The wheel carrier's motion on the chassis, in chassis axes from the corner's origin, as it is with the rates of the drives.
/// Second rates leave out what a second rate of travel adds: that is `per_travel` times it.
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

impl Hub {
    /// From the points of a left corner with their rates, and their derivatives per travel; `None` where the listing has no
    /// wheel or measures nothing.
    pub fn of<T, L, const N: usize>(
        model: &L,
        points: &Signal<L::Points>,
        per_travel: &Signal<L::Points>,
    ) -> Option<Self>
    where
        T: Real + Into<f64>,
        L: Linkage<N, Scalar = T>,
    {
        let wide = |vector: Vector3<T>| vector.map(Into::into);
        let end = |of: &L::Points| Some(wide(model.wheel_axis(of)?[1]));
        let [inner, centre] = model.wheel_axis(&points.value)?.map(wide);
        let carrier = model.wheel_carrier(&points.value)?.map(wide);
        let turning =
            |rates: &L::Points| angular_velocity(&carrier, &model.wheel_carrier(rates)?.map(wide));
        let strut = |motion: &Signal<L::Points>| {
            let length = model.measures(motion);
            let first = |of: &L::Measures| of.values().next().map(Into::into);
            Some([first(&length.value)?, first(&length.rate)?])
        };
        Some(Self {
            centre: Signal {
                value: centre,
                rate: end(&points.rate)?,
                second_rate: end(&points.second_rate)?,
            },
            axis: (centre - inner).normalize(),
            turning: turning(&points.rate)?,
            strut: strut(points)?,
            per_travel: PerTravel {
                centre: end(&per_travel.rate)?,
                turn: turning(&per_travel.rate)?,
                strut: strut(per_travel)?[1],
            },
        })
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

//! The car's numbers: a saloon of 1,400 kg. Geometry is in the listings.

use nalgebra::{Matrix3, Vector3};

use crate::strut::Strut;
use crate::tyre::Tyre;

/// m/s^2.
pub const GRAVITY: f64 = 9.81;

/// A car whose sides are alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// The mass of the chassis with everything that it carries, kg.
    pub sprung_mass: f64,
    /// About the axes through the centre of mass of the sprung mass, kg m^2.
    pub inertia: [f64; 3],
    /// The height of that centre above the ground in the design, m.
    pub height: f64,
    /// Front and rear.
    pub axles: [Axle; 2],
    /// All four.
    pub tyre: Tyre,
}

/// An axle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axle {
    /// Distance ahead of the centre of mass of the sprung mass, m.
    pub ahead: f64,
    /// One wheel, with its part of the links, in the wheel centre, kg.
    pub unsprung_mass: f64,
    /// The inertia of a wheel about its spin axis, kg m^2.
    pub spin_inertia: f64,
    /// N/m along the strut.
    pub stiffness: f64,
    /// N s/m along the strut.
    pub damping: f64,
    /// The stiffness of the anti-roll bar: N at each wheel per m of difference in travel.
    pub bar: f64,
}

/// The saloon: ride at 1.2 Hz in front and 1.4 Hz behind, a third of critical damping.
pub const SALOON: Parameters = Parameters {
    sprung_mass: 1236.0,
    inertia: [480.0, 1900.0, 2100.0],
    height: 0.55,
    axles: [
        Axle {
            ahead: 1.28,
            unsprung_mass: 42.0,
            spin_inertia: 1.0,
            stiffness: 45_000.0,
            damping: 3_600.0,
            bar: 9_000.0,
        },
        Axle {
            ahead: -1.42,
            unsprung_mass: 40.0,
            spin_inertia: 1.0,
            stiffness: 25_000.0,
            damping: 1_800.0,
            bar: 3_000.0,
        },
    ],
    tyre: Tyre {
        radius: 0.317,
        stiffness: 210_000.0,
        damping: 150.0,
        slip_stiffness: 18.0,
        friction: 1.0,
        friction_loss: 0.1,
        nominal_load: 3_500.0,
        relaxation: 0.35,
    },
};

impl Parameters {
    /// The loads of a front and of a rear wheel at rest, from the moments about the other axle, N.
    pub fn static_loads(&self) -> [f64; 2] {
        let [front, rear] = self.axles;
        let wheelbase = front.ahead - rear.ahead;
        [
            -rear.ahead / wheelbase * self.sprung_mass / 2.0 + front.unsprung_mass,
            front.ahead / wheelbase * self.sprung_mass / 2.0 + rear.unsprung_mass,
        ]
        .map(|mass| mass * GRAVITY)
    }

    /// The chassis' inertia about its centre of mass.
    pub fn inertia_matrix(&self) -> Matrix3<f64> {
        Matrix3::from_diagonal(&Vector3::from(self.inertia))
    }
}

impl Axle {
    /// Returns its struts, with a spring that exerts a force at a length.
    pub fn strut(&self, force: f64, length: f64) -> Strut {
        Strut {
            stiffness: self.stiffness,
            damping: self.damping,
            free_length: length + force / self.stiffness,
            clearance: 0.06,
            stop: 80_000.0,
        }
    }
}

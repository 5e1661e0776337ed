//! A motion led by a quantity in place of a drive.

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Linkage;
use crate::path::configuration::Configuration;
use crate::path::curve::Curve;
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::solve::motion::Motion;

/// A motion that another quantity leads instead of one drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Led<T, const N: usize> {
    /// The unknowns and the coordinate of the drive that is set free, with their rates.
    pub configuration: Signal<Configuration<T, N>>,
    /// The index of the drive that is set free.
    pub(super) drive: usize,
    /// The local parameter: the entry of the configuration that is held in corrections. `N` is the drive. The
    /// [`Leader`](super::Leader) exchanges it if it determines the other entries poorly.
    pub parameter: usize,
    /// Whether the quantity increases along the curve in the direction in which `det [J, dF/dh; t^T]` is positive, if
    /// known. It changes only where the quantity turns or another curve crosses.
    pub increases: Option<bool>,
}

impl<T: Real, const N: usize> Led<T, N> {
    /// A motion at rest on a curve, with the unknowns `q`. Its free drive is the one that the curve sets free.
    ///
    /// # Errors
    ///
    /// [`SolveError::Singular`] at a bifurcation.
    pub fn at_rest<L>(curve: &Curve<'_, L, N>, q: &SVector<T, N>) -> Result<Self, SolveError<T>>
    where
        L: Linkage<N, Scalar = T>,
    {
        let value = curve.configuration(q);
        Ok(Self {
            configuration: Signal {
                value,
                rate: Configuration::zero(),
                second_rate: Configuration::zero(),
            },
            drive: curve.drive,
            parameter: curve.steepest(&value)?,
            increases: None,
        })
    }

    /// The free drive's value with its rates: an angle in radians, or the coordinate itself.
    pub fn drive<L, C>(&self, linkage: &L, inputs: &Inputs<C, L::Drives>) -> Signal<T>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let Signal {
            value,
            rate,
            second_rate,
        } = self.configuration;
        Curve::with_free_drive(linkage, inputs, self.drive).value(&Signal {
            value: value.drive,
            rate: rate.drive,
            second_rate: second_rate.drive,
        })
    }

    /// All points with their rates; `inputs` are those of the last step.
    pub fn points<L, C>(&self, linkage: &L, inputs: &Inputs<C, L::Drives>) -> Signal<L::Points>
    where
        L: Linkage<N, Scalar = T>,
        C: ChassisMotion<L::Fixed>,
    {
        let curve = Curve::with_free_drive(linkage, inputs, self.drive);
        curve.points_with(&self.configuration, &curve.prescribed.fixed)
    }

    /// The unknowns' motion, from which a [`Tracker`](crate::Tracker) can go on.
    pub fn motion(&self) -> Motion<T, N> {
        let Signal {
            value,
            rate,
            second_rate,
        } = self.configuration;
        Motion {
            position: value.unknowns,
            velocity: rate.unknowns,
            acceleration: second_rate.unknowns,
            positive_determinant: None,
        }
    }
}

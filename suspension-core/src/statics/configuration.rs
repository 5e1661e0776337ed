//! The configuration in which loads act.

use nalgebra::{SVector, Vector3};

use crate::arithmetic::scalar::Real;
use crate::linkage::Linkage;
use crate::listing::Kind;
use crate::signal::{Inputs, Signal};
use crate::solve::motion::Prescribed;
use crate::values::Values;

/// A linkage in one configuration.
pub(super) struct Configuration<'a, L: Linkage<N>, const N: usize> {
    pub(super) linkage: &'a L,
    /// Chassis points, with the driven coordinates inserted.
    pub(super) fixed: L::Fixed,
    /// The rates of the coordinates that drives prescribe, per unit of each drive.
    rates: L::Drives,
    pub(super) position: SVector<L::Scalar, N>,
}

// Derived implementations would require a linkage that can be copied.
impl<L: Linkage<N>, const N: usize> Clone for Configuration<'_, L, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<L: Linkage<N>, const N: usize> Copy for Configuration<'_, L, N> {}

impl<'a, T: Real, L: Linkage<N, Scalar = T>, const N: usize> Configuration<'a, L, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(linkage: &'a L, drives: L::Drives, position: &SVector<T, N>) -> Self {
        let rate = L::Drives::from_values(drives.values().map(|_| T::one()));
        let drives = Signal {
            rate,
            ..Signal::still(drives)
        };
        let Prescribed { fixed, drives } = Prescribed::new(linkage, &Inputs::still(drives));
        Self {
            linkage,
            fixed: fixed.value,
            rates: drives.rate,
            position: *position,
        }
    }

    /// Forces at chassis points and free points that do the same work as forces at all points.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn carried(&self, forces: &L::Points) -> L::Points {
        let linkage = self.linkage;
        let before = linkage.count(Kind::ChassisPoint) + linkage.count(Kind::FreePoint);
        let mut at_markers = forces.values().skip(before);
        let mut carried = *forces;
        if at_markers.any(|force| force != Vector3::zeros()) {
            linkage.carry_forces(&self.position, &self.fixed, &mut carried);
        }
        carried
    }

    /// The work of forces per unit of each drive: through the equations, and at the chassis points that the drive
    /// moves.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn on_drives(&self, multipliers: &SVector<T, N>, forces: &L::Points) -> L::Drives {
        let Self {
            linkage,
            fixed,
            rates,
            position,
        } = self;
        let rates = rates.values().enumerate();
        L::Drives::from_values(rates.map(|(drive, rate)| {
            let rate = L::Drives::default().with(drive, rate);
            let anchors = linkage.drive_anchors(L::Fixed::default(), &rate);
            let terms = linkage.drive_rate(position, fixed, &anchors, &rate);
            let moved = anchors.values().zip(forces.values());
            // Which points a drive moves is known when a linkage is compiled, so the rest of this sum is then left
            // out.
            let moved = moved.filter(|(rate, _)| *rate != Vector3::zeros());
            moved.fold(multipliers.dot(&terms), |work, (rate, force)| {
                work + rate.dot(&force)
            })
        }))
    }
}

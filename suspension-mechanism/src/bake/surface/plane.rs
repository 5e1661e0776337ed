//! The exact motion as a function of two drives.

use std::sync::atomic::AtomicBool;

use nalgebra::Vector3;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Linkage, Motion, Values};

use crate::bake::driven::Driven;
use crate::bake::surface::wanted::{UnmetSurface, WantedSurface};
use crate::mechanism::Suspension;

/// The mechanism moved by two drives, with the others held.
pub(super) struct Plane<'a, L: Linkage<N>, const N: usize> {
    pub(super) driven: Driven<'a, L>,
    pub(super) start: &'a Motion<f64, N>,
    pub(super) held: L::Drives,
    pub(super) wanted: &'a WantedSurface,
    pub(super) interrupted: &'a AtomicBool,
}

/// An output with its derivatives with respect to the first drive, the second, and both.
#[derive(Clone, Copy)]
pub(super) struct Mixed {
    pub(super) value: Vector3<f64>,
    pub(super) by_first: Vector3<f64>,
    pub(super) by_second: Vector3<f64>,
    pub(super) by_both: Vector3<f64>,
}

impl<L: Suspension<N>, const N: usize> Plane<'_, L, N> {
    /// The outputs at places, 0 to 1 in each direction, ordered by place along the first drive.
    pub(super) fn grid(
        &self,
        corner: [f64; 2],
        lengths: [f64; 2],
        places: &[f64],
    ) -> Result<Vec<Vec<Vec<Mixed>>>, UnmetSurface> {
        let mut motion = *self.start;
        let mut last = self.held;
        let mut grid = Vec::new();
        for u in places {
            let mut row = Vec::new();
            let mut turned = (motion, last);
            for v in places {
                let at = [corner[0] + lengths[0] * u, corner[1] + lengths[1] * v];
                let drives = self.drives(self.held, at);
                let followed = self.driven.follow([&last, &drives], &mut motion);
                followed.map_err(|Stopped { refused, .. }| UnmetSurface::OutOfReach {
                    drives: at,
                    cause: refused.map(|(_, cause)| cause),
                })?;
                last = drives;
                if row.is_empty() {
                    turned = (motion, last);
                }
                row.push(self.mixed(&motion, at)?);
            }
            // Each row begins where the last one began.
            (motion, last) = turned;
            grid.push(row);
        }
        Ok(grid)
    }

    fn drives(&self, others: L::Drives, [first, second]: [f64; 2]) -> L::Drives {
        let [first_drive, second_drive] = self.wanted.drives;
        others.with(first_drive, first).with(second_drive, second)
    }

    /// The outputs with the mixed derivative, which is half of the difference between the second derivative along the
    /// diagonal and the sum of those along both drives.
    fn mixed(&self, motion: &Motion<f64, N>, at: [f64; 2]) -> Result<Vec<Mixed>, UnmetSurface> {
        let lost = |cause| UnmetSurface::OutOfReach {
            drives: at,
            cause: Some(cause),
        };
        let rates = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]
            .map(|direction| self.drives(L::Drives::default(), direction));
        let drives = self.drives(self.held, at);
        let [first, second, both] = self
            .driven
            .derivatives(motion, drives, rates)
            .map_err(lost)?;
        let each = first.iter().zip(&second).zip(&both);
        Ok(each
            .map(|((first, second), both)| Mixed {
                value: first[0],
                by_first: first[1],
                by_second: second[1],
                by_both: (both[2] - first[2] - second[2]) / 2.0,
            })
            .collect())
    }
}

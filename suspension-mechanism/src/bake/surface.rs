//! Baking the motion of two drives, for example travel and steer, into a
//! [`suspension_core::baked::Surface`].

mod baked_surface;
mod plane;
mod wanted;

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::Vector3;
use suspension_core::Motion;
use suspension_core::baked::Patch;

use crate::bake::certify;
use crate::bake::driven::{Driven, Output};
use crate::bake::scheme::{Continuity, TERMS};
use crate::mechanism::Suspension;
use plane::{Mixed, Plane};

pub use baked_surface::{BakedSurface, SurfaceReached};
pub use wanted::{MOST_PATCHES, UnmetSurface, WantedSurface};

/// Bakes the motion of two drives, with the others held at `held`, from the configuration `start`.
///
/// The number of patches is the smallest with which the tolerance is met, however they are arranged. The work ends
/// when `interrupted` is set; this is checked at each patch.
///
/// # Errors
///
/// See [`UnmetSurface`].
pub fn bake_surface<L: Suspension<N>, const N: usize>(
    model: &L,
    start: &Motion<f64, N>,
    held: L::Drives,
    wanted: &WantedSurface,
    interrupted: &AtomicBool,
) -> Result<BakedSurface, UnmetSurface> {
    let plane = Plane {
        driven: Driven::new(model, wanted.points),
        start,
        held,
        wanted,
        interrupted,
    };
    for counts in layouts() {
        if let Some((patches, reached)) = plane.patches(counts)? {
            return Ok(BakedSurface {
                wanted: *wanted,
                outputs: plane.driven.outputs(),
                reached,
                counts,
                patches,
            });
        }
    }
    Err(UnmetSurface::TooManyPatches)
}

/// The numbers of patches along each drive, the fewest first.
fn layouts() -> Vec<[usize; 2]> {
    let mut layouts: Vec<[usize; 2]> = (1..=MOST_PATCHES)
        .flat_map(|along| (1..=MOST_PATCHES / along).map(move |across| [along, across]))
        .collect();
    layouts.sort_by_key(|[along, across]| (along * across, along.abs_diff(*across)));
    layouts
}

type Patches = Vec<Vec<Patch<f64, 3, TERMS>>>;

impl<L: Suspension<N>, const N: usize> Plane<'_, L, N> {
    /// All patches and their largest errors; `None` if the tolerance is not met.
    fn patches(
        &self,
        counts: [usize; 2],
    ) -> Result<Option<(Patches, SurfaceReached)>, UnmetSurface> {
        let all = 0..counts[0] * counts[1];
        for index in all.clone() {
            let (corner, lengths) = self.place(counts, index)?;
            if !self.may_meet(corner, lengths)? {
                return Ok(None);
            }
        }
        let mut patches = Vec::new();
        let mut reached = SurfaceReached::default();
        for index in all {
            let (corner, lengths) = self.place(counts, index)?;
            let (patch, off) = self.patch(corner, lengths)?;
            if off.position > self.wanted.tolerance {
                return Ok(None);
            }
            reached = reached.larger(off);
            patches.push(patch);
        }
        Ok(Some((patches, reached)))
    }

    /// The corner and the lengths of a patch.
    fn place(
        &self,
        counts: [usize; 2],
        index: usize,
    ) -> Result<([f64; 2], [f64; 2]), UnmetSurface> {
        if self.interrupted.load(Ordering::Relaxed) {
            return Err(UnmetSurface::Interrupted);
        }
        let place = [index / counts[1], index % counts[1]];
        let corner = [0, 1].map(|way| self.edge(way, counts, place[way]));
        let lengths = [0, 1].map(|way| self.edge(way, counts, place[way] + 1) - corner[way]);
        Ok((corner, lengths))
    }

    fn edge(&self, way: usize, counts: [usize; 2], number: usize) -> f64 {
        let [from, to] = self.wanted.ranges[way];
        from + (to - from) * number as f64 / counts[way] as f64
    }

    /// Whether a few of the samples that [`Self::patch`] takes are within the tolerance. They refuse most patches that
    /// are too large, in a fraction of the time.
    fn may_meet(&self, corner: [f64; 2], lengths: [f64; 2]) -> Result<bool, UnmetSurface> {
        /// Places along each drive for one that is looked at.
        const EACH: usize = 4;
        let places: Vec<f64> = certify::places().into_iter().step_by(EACH).collect();
        let fitted = self.fitted(corner, lengths)?;
        let seen = self.grid(corner, lengths, &places)?;
        let is_within = |u: usize, v: usize| {
            let mut outputs = fitted.iter().zip(&seen[u][v]);
            outputs.all(|((output, patch), exact)| {
                let [value, ..] = evaluate(patch, places[u], places[v]);
                let off = value - exact.value;
                output.lever(self.wanted.metre) * off.norm() <= self.wanted.tolerance
            })
        };
        let all = 0..places.len();
        Ok(all.clone().all(|u| all.clone().all(|v| is_within(u, v))))
    }

    /// A patch of each output, and bounds of the largest errors.
    fn patch(
        &self,
        corner: [f64; 2],
        lengths: [f64; 2],
    ) -> Result<(Vec<Patch<f64, 3, TERMS>>, SurfaceReached), UnmetSurface> {
        let fitted = self.fitted(corner, lengths)?;
        let seen = self.grid(corner, lengths, &certify::places())?;
        let mut reached = SurfaceReached::default();
        for (number, (output, patch)) in fitted.iter().enumerate() {
            let lever = output.lever(self.wanted.metre);
            let bound = |of: fn(&Mixed) -> Vector3<f64>, order: usize, length: f64| {
                let off = |u: f64, v: f64, exact: &Vec<Mixed>| {
                    evaluate(patch, u, v)[order] / length - of(&exact[number])
                };
                lever * certify::bound_over_square(&seen, off)
            };
            reached = reached.larger(SurfaceReached {
                position: bound(|exact| exact.value, 0, 1.0),
                first: [
                    bound(|exact| exact.by_first, 1, lengths[0]),
                    bound(|exact| exact.by_second, 2, lengths[1]),
                ],
            });
        }
        let patches = fitted.into_iter().map(|(_, patch)| patch).collect();
        Ok((patches, reached))
    }

    /// The polynomials of a patch.
    fn fitted(
        &self,
        corner: [f64; 2],
        lengths: [f64; 2],
    ) -> Result<Vec<(Output, Patch<f64, 3, TERMS>)>, UnmetSurface> {
        let continuity = if self.wanted.smooth {
            Continuity::Velocity
        } else {
            Continuity::Position
        };
        let met = self.grid(corner, lengths, &continuity.places())?;
        let outputs = self.driven.outputs().into_iter().enumerate();
        let fitted =
            outputs.map(|(number, output)| (output, fit(continuity, lengths, &met, number)));
        Ok(fitted.collect())
    }
}

/// The polynomial of an output: it is fitted along the second drive, then its coefficients are fitted along the
/// first.
fn fit(
    continuity: Continuity,
    [along, across]: [f64; 2],
    met: &[Vec<Vec<Mixed>>],
    output: usize,
) -> Patch<f64, 3, TERMS> {
    let none = Vector3::zeros();
    let rows: Vec<_> = met
        .iter()
        .map(|row| {
            let each = row.iter().map(|outputs| outputs[output]);
            let values: Vec<_> = each
                .clone()
                .map(|at| [at.value, at.by_second, none])
                .collect();
            let slopes: Vec<_> = each.map(|at| [at.by_first, at.by_both, none]).collect();
            [values, slopes].map(|values| continuity.fit(across, &values))
        })
        .collect();
    let mut patch = [[[0.0; 3]; TERMS]; TERMS];
    for second in 0..TERMS {
        let values: Vec<_> = rows
            .iter()
            .map(|[value, slope]| [value[second].into(), slope[second].into(), none])
            .collect();
        for (first, coefficient) in continuity.fit(along, &values).into_iter().enumerate() {
            patch[first][second] = coefficient;
        }
    }
    patch
}

/// The value of a patch, and its derivatives with respect to both variables.
fn evaluate(patch: &Patch<f64, 3, TERMS>, u: f64, v: f64) -> [Vector3<f64>; 3] {
    use suspension_core::baked::polynomial;
    let rows: [[[f64; 3]; 2]; TERMS] = patch.map(|row| polynomial(&row, v));
    let [value, by_first] = polynomial(&rows.map(|[value, _]| value), u);
    let [by_second] = polynomial(&rows.map(|[_, slope]| slope), u);
    [value, by_first, by_second].map(Vector3::from)
}

//! A motion as polynomials over patches of the ranges of two drives.

use suspension_core::baked::Patch;

use crate::bake::driven::Output;
use crate::bake::scheme::TERMS;
use crate::bake::surface::wanted::WantedSurface;

/// The largest differences between a surface and the motion: bounds from samples as for a curve, in each direction.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SurfaceReached {
    /// The difference of a position, in the unit of the hardpoints.
    pub position: f64,
    /// The differences of its first derivatives with respect to each drive, in that unit per unit of the drive.
    pub first: [f64; 2],
}

impl SurfaceReached {
    /// The larger of the two, for each difference.
    pub(super) fn larger(self, other: Self) -> Self {
        Self {
            position: self.position.max(other.position),
            first: [0, 1].map(|way| self.first[way].max(other.first[way])),
        }
    }
}

/// A baked motion of two drives.
#[derive(Clone, Debug, PartialEq)]
pub struct BakedSurface {
    /// The request.
    pub wanted: WantedSurface,
    /// The outputs, of three numbers each.
    pub outputs: Vec<Output>,
    /// Its errors.
    pub reached: SurfaceReached,
    /// The numbers of patches along each drive.
    pub counts: [usize; 2],
    /// The polynomials indexed by patch, output and powers of both drives.
    pub patches: Vec<Vec<Patch<f64, 3, TERMS>>>,
}

impl BakedSurface {
    /// The patches of a [`suspension_core::baked::Surface`]; `None` if `OUT` is not the number of outputs.
    pub fn table<const OUT: usize>(&self) -> Option<Vec<Patch<f64, OUT, TERMS>>> {
        let fixed = |outputs: &Vec<Patch<f64, 3, TERMS>>| {
            let mut patch = [[[0.0; OUT]; TERMS]; TERMS];
            for (first, row) in patch.iter_mut().enumerate() {
                for (second, numbers) in row.iter_mut().enumerate() {
                    let all = outputs.iter().flat_map(|output| output[first][second]);
                    *numbers = all.collect::<Vec<_>>().try_into().ok()?;
                }
            }
            Some(patch)
        };
        self.patches.iter().map(fixed).collect()
    }

    /// The same surface with positions in coordinates in which the present origin is at `origin`, and with the
    /// drives' `ranges` in them.
    pub fn moved(mut self, origin: [f64; 3], ranges: [[f64; 2]; 2]) -> Self {
        self.wanted.ranges = ranges;
        for patch in &mut self.patches {
            for (output, coefficients) in self.outputs.iter().zip(patch) {
                if *output != Output::SpinAxis {
                    for (constant, origin) in coefficients[0][0].iter_mut().zip(origin) {
                        *constant += origin;
                    }
                }
            }
        }
        self
    }

    /// The numbers of patches in each direction, divided by the lengths of the ranges.
    pub fn patches_per_unit(&self) -> [f64; 2] {
        [0, 1].map(|way| {
            let [from, to] = self.wanted.ranges[way];
            self.counts[way] as f64 / (to - from)
        })
    }
}

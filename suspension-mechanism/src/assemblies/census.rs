//! The roots of the mechanism itself.

use nalgebra::{Complex, SVector};
use suspension_core::{Inputs, Newton, Still};

use crate::assemblies::factors::Vector;
use crate::assemblies::family::{Enumerable, Member, complex};
use crate::assemblies::generic::{Evidence, Generic, add_distinct};
use crate::assemblies::path::End;

/// Ways on which the roots are followed at most: a straight one, and detours where paths of that
/// are lost.
const WAYS: usize = 8;

/// The largest imaginary part of a real root, and how far it may lie from where Newton's method
/// confirms it, as a multiple of the linkage's size.
const REAL: f64 = 1e-6;

/// All assemblies of a mechanism at given values of its drives.
#[derive(Clone, Debug, PartialEq)]
pub struct Census<const N: usize> {
    /// The real ones, residuals tested.
    pub real: Vec<SVector<f64, N>>,
    /// What became of all.
    pub tally: Tally,
}

/// What became of the assemblies of a general mechanism, by number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// How many are real.
    pub real: usize,
    /// How many more are real, with another angle where a drive is one about an axis: the equations have the sine of its
    /// quarter, which other angles have too.
    pub turned: usize,
    /// How many are complex.
    pub complex: usize,
    /// How many have imaginary parts that may be rounding, and no iteration confirms a real one:
    /// beside a fold two real ones or two complex ones, which are not told apart.
    pub unconfirmed: usize,
    /// How many a mechanism with general lengths has.
    pub generic: usize,
    /// How many of those go to infinity as the lengths become the mechanism's.
    pub infinite: usize,
    /// Why the generic ones are believed to be all.
    pub evidence: Evidence,
}

impl Tally {
    /// How many assemblies of a general mechanism were followed neither to one of this mechanism
    /// nor to infinity: several that coincide, paths lost near a singularity, or the unconfirmed ones.
    pub fn unaccounted(&self) -> usize {
        let accounted = self.real + self.turned + self.complex + self.infinite;
        self.generic.saturating_sub(accounted)
    }

    /// Whether there is good reason to believe that the list is complete.
    pub fn is_complete(&self) -> bool {
        self.doubts().is_empty()
    }

    /// Why the list may not be complete: unless all assemblies of a general mechanism are known, and where each of
    /// them leads.
    pub fn doubts(&self) -> Vec<String> {
        let general =
            || "not all assemblies of such a mechanism with general lengths were found".to_owned();
        let lost = |count| match count {
            1 => "one of them was lost on its way to this one".to_owned(),
            _ => format!("{count} of them were lost on their way to this one"),
        };
        let unpaired = || {
            format!(
                "complex assemblies come in pairs and {} is odd",
                self.complex
            )
        };
        let unaccounted = self.unaccounted();
        [
            (!self.evidence.is_convincing()).then(general),
            (unaccounted > 0).then(|| lost(unaccounted)),
            (!self.complex.is_multiple_of(2)).then(unpaired),
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// Follows the generic roots to the mechanism; `None` where the search is given up.
pub(crate) fn census<L: Enumerable<N>, const N: usize>(
    generic: &mut Generic<'_, L::Listing, N>,
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
) -> Option<Census<N>> {
    let size = model.size();
    let target = Member {
        drives: complex::<L, N>(model, inputs),
        right: Vector::zeros(),
        tilted: 0.0,
    };
    let mut roots = Vec::new();
    let mut infinite = 0;
    for way in 0..WAYS {
        let detour = (way > 0).then(|| generic.waypoint());
        let lines = generic.lines(detour.into_iter().chain([target]));
        let ends = generic.follow_all(&lines)?;
        // Another way loses other paths: as many go to infinity on each.
        let far = ends.iter().filter(|end| **end == End::Infinite).count();
        infinite = far.max(infinite);
        for end in ends {
            if let End::Root(root) = end {
                add_distinct(&mut roots, root, size);
            }
        }
        if roots.len() + infinite >= generic.roots.len() {
            break;
        }
    }
    let bound = REAL * size;
    let (nearly_real, complex): (Vec<_>, Vec<_>) = roots
        .iter()
        .partition(|root| root.iter().all(|entry| entry.im.abs() <= bound));
    let real: Vec<_> = nearly_real
        .iter()
        .filter_map(|root| confirmed::<L, N>(model, inputs, root, bound))
        .collect();
    let tally = Tally {
        real: real.len(),
        turned: 0,
        complex: complex.len(),
        unconfirmed: nearly_real.len() - real.len(),
        generic: generic.roots.len(),
        infinite: infinite.min(generic.roots.len().saturating_sub(roots.len())),
        evidence: generic.evidence,
    };
    Some(Census { real, tally })
}

/// The real root within `bound` of a nearly real one.
fn confirmed<L: Enumerable<N>, const N: usize>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
    root: &Vector<N>,
    bound: f64,
) -> Option<SVector<f64, N>> {
    let found = root.map(|entry: Complex<f64>| entry.re);
    let mut q = found;
    Newton::near_by().solve(model, inputs, &mut q).ok()?;
    ((q - found).amax() <= bound).then_some(q)
}

//! The roots of a part of the mechanism itself.

use nalgebra::Complex;
use suspension_core::Listing;

use crate::assemblies::factors::Vector;
use crate::assemblies::family::{Line, MemberOf};
use crate::assemblies::generic::{Evidence, Generic, add_distinct};
use crate::assemblies::limits::{MOST, Stage};
use crate::assemblies::path::{End, FAR};

/// The largest number of ways on which the roots are followed: a straight one, and detours if paths on it are lost.
const WAYS: usize = 8;

/// The largest imaginary part of a real root, and the largest distance from it to the root that Newton's method
/// confirms, as multiples of the linkage's size.
const REAL: f64 = 1e-6;

/// The largest residual due to rounding.
const ROUNDINGS: f64 = 64.0;

/// The outcome for the assemblies of a general mechanism, by number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tally {
    /// The number of real assemblies.
    pub real: usize,
    /// The number of further real solutions, with another quarter of a driven angle about an axis: the equations have
    /// the sine and cosine of the quarter, which other angles share, and which an angle of zero or half a turn has in
    /// two ways.
    pub turned: usize,
    /// The number of solutions that were put together and are not confirmed as a whole.
    pub unconfirmed: usize,
    /// Whether there are more assemblies than are listed.
    pub is_cut: bool,
    /// The outcome for each part, in the order in which they are put together.
    pub parts: Vec<PartTally>,
}

/// The outcome for the assemblies of a part of a general mechanism, with each assembly of the parts that it needs.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartTally {
    /// Its points and other unknowns.
    pub unknowns: Vec<String>,
    /// The number of ways in which the parts that it needs are put together.
    pub times: usize,
    /// The number of real assemblies.
    pub real: usize,
    /// The number of complex assemblies.
    pub complex: usize,
    /// The number of assemblies whose imaginary parts may be rounding, although no iteration confirms a real one:
    /// near a fold, two real ones or two complex ones, which cannot be told apart.
    pub unconfirmed: usize,
    /// The number of assemblies of such a part with general dimensions, each time.
    pub generic: usize,
    /// The number of those that go to infinity as the lengths become those of the mechanism.
    pub infinite: usize,
    /// The evidence that the generic assemblies are complete.
    pub evidence: Evidence,
}

impl PartTally {
    /// The number of assemblies of a general part that were followed neither to an assembly of this mechanism nor to
    /// infinity: several that coincide, paths lost near a singularity, or the unconfirmed ones.
    pub fn unaccounted(&self) -> usize {
        let accounted = self.real + self.complex + self.infinite;
        (self.times * self.generic).saturating_sub(accounted)
    }

    fn doubts(&self) -> impl Iterator<Item = String> {
        let general = || match self.evidence.ended_after {
            Some(paths) => {
                format!(
                    "the search for those with general dimensions was ended after {paths} paths"
                )
            }
            None => "not all assemblies of such a mechanism with general dimensions were found"
                .to_owned(),
        };
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
        let doubts = [
            (!self.evidence.is_convincing()).then(general),
            (unaccounted > 0).then(|| lost(unaccounted)),
            (!self.complex.is_multiple_of(2)).then(unpaired),
        ];
        doubts.into_iter().flatten()
    }
}

impl Tally {
    /// The reasons why the list may not be complete. There are none only if all assemblies of a general mechanism are
    /// known, and where each of them leads.
    pub fn doubts(&self) -> Vec<String> {
        let several = self.parts.len() > 1;
        let of_part = |part: &PartTally| {
            let name = several.then(|| format!("{}: ", part.unknowns.join(", ")));
            let name = name.unwrap_or_default();
            part.doubts()
                .map(|doubt| format!("{name}{doubt}"))
                .collect::<Vec<_>>()
        };
        let unconfirmed = (self.unconfirmed > 0).then(|| {
            let count = self.unconfirmed;
            format!("{count} that were combined from the parts are not confirmed for the whole mechanism")
        });
        let cut = self
            .is_cut
            .then(|| format!("only the first {MOST} are listed"));
        let of_parts = self.parts.iter().flat_map(of_part);
        of_parts.chain(unconfirmed).chain(cut).collect()
    }
}

/// Follows the generic roots to a member with real numbers; returns the real roots, and adds the outcome to those with
/// other assemblies of the parts that this one needs. `None` if the search is given up.
pub(crate) fn census<G: Listing<N>, const N: usize>(
    generic: &mut Generic<'_, G, N>,
    target: MemberOf<G, N>,
    tally: &mut PartTally,
) -> Option<Vec<Vector<N>>> {
    let size = generic.family.size;
    let mut roots = Vec::new();
    let mut infinite = 0;
    for way in 0..WAYS {
        let detour = (way > 0).then(|| generic.detour());
        let lines = generic.lines(detour.into_iter().chain([target]));
        let ends = generic.follow_all(Stage::Follow, &lines);
        let ends: Option<Vec<_>> = ends.into_iter().collect();
        // Another way loses other paths, while the same number goes to infinity on each.
        let mut far = 0;
        for end in ends? {
            match end {
                End::Root(root) if root.camax() < 0.1 * FAR * size => {
                    add_distinct(&mut roots, root, size);
                }
                End::Root(_) | End::Infinite => far += 1,
                End::Lost => {}
            }
        }
        infinite = far.max(infinite);
        if roots.len() + infinite >= generic.roots.len() {
            break;
        }
    }
    let bound = REAL * size;
    let (nearly_real, complex): (Vec<_>, Vec<_>) = roots
        .iter()
        .partition(|root| root.iter().all(|entry| entry.im.abs() <= bound));
    let at = generic.family.line(target, target);
    let confirmed = |root: &&Vector<N>| confirmed(&at, root, bound);
    let real: Vec<_> = nearly_real.iter().filter_map(confirmed).collect();
    tally.times += 1;
    tally.real += real.len();
    tally.complex += complex.len();
    tally.unconfirmed += nearly_real.len() - real.len();
    tally.infinite += infinite.min(generic.roots.len().saturating_sub(roots.len()));
    Some(real)
}

/// The real root within `bound` of a nearly real one, by its residual.
fn confirmed<G: Listing<N>, const N: usize>(
    at: &Line<'_, G, N>,
    root: &Vector<N>,
    bound: f64,
) -> Option<Vector<N>> {
    /// The largest ratio of a correction to the one before, and the number of corrections.
    const CONTRACTION: f64 = 0.5;
    const CORRECTIONS: usize = 10;
    let found = root.map(|entry| Complex::from(entry.re));
    let mut q = found;
    let mut last = f64::INFINITY;
    for _ in 0..CORRECTIONS {
        let residual = at.residual(&q, 1.0);
        let rounding = f64::EPSILON * at.size().max(q.camax());
        if residual.norm() <= ROUNDINGS * rounding {
            return ((q - found).camax() <= bound).then_some(q);
        }
        let correction = at.factors(&q, 1.0).solve(&residual)?;
        let size = correction.camax();
        if size > CONTRACTION * last {
            return None;
        }
        q -= correction;
        last = size;
    }
    None
}

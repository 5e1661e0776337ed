//! All complex roots of one generic member of a family.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use nalgebra::{Complex, SVector};
use suspension_core::Listing;

use crate::assemblies::factors::Vector;
use crate::assemblies::family::{Drives, Family, Line, Member, MemberOf};
use crate::assemblies::limits::{MOST_PATHS, Stage, Watch};
use crate::assemblies::parallel;
use crate::assemblies::path::{End, follow};
use crate::assemblies::random::Random;
use crate::assemblies::tilt::Plane;

/// The number of random starts before the first loop.
const STARTS: usize = 200;

/// The number of loops without a new root after which the search may end. One is not enough: for a double wishbone
/// with skew axes 24 of 32 roots were closed under a loop.
const QUIET: usize = 4;

/// The largest number of loops.
const MOST_LOOPS: usize = 80;

/// The size of loops, as a multiple of the linkage's size: small ones leave the roots where they were, above all
/// those far away; large ones take more steps.
const LOOP: f64 = 10.0;

/// The size of detours, as the same multiple. For a live axle on a Watt linkage, detours of this size recognised all
/// 80 assemblies at infinity; those of 10 and 30 lost some.
const DETOUR: f64 = 100.0;

/// The largest deviation from linearity of the sum over all roots, relative to its change. Rounding leaves up to
/// 4e-10. Missing roots left 2e-4 and more for double wishbones with skew axes, and 4e-7 for an H-arm with a camber
/// link.
const LINEAR: f64 = 1e-8;

/// The evidence that all roots were found.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Evidence {
    /// The number of random starts, each followed from the system of which it is a root.
    pub starts: usize,
    /// The number of loops through other systems, along which all roots were followed.
    pub loops: usize,
    /// The number of the last loops that brought no new root.
    pub quiet: usize,
    /// The trace test (Sommese, Verschelde and Wampler 2002): the deviation of the sum of the roots from linearity
    /// while a plane in place of a coordinate turns, relative to its change. If a root is missing, the sum is not
    /// linear. `None` if neither a drive nor another part gives a coordinate of a free point.
    pub trace: Option<f64>,
    /// The number of paths after which the search was ended, before the other criteria were met.
    pub ended_after: Option<usize>,
}

impl Evidence {
    /// Whether the last loops were quiet and the trace test, where it applies, confirms the roots.
    pub(crate) fn is_convincing(&self) -> bool {
        self.quiet >= QUIET && self.trace.is_none_or(|bend| bend < LINEAR)
    }
}

/// A member of a family with its roots.
pub(crate) struct Generic<'a, G: Listing<N>, const N: usize> {
    pub(crate) family: Family<G, N>,
    member: MemberOf<G, N>,
    pub(crate) roots: Vec<Vector<N>>,
    pub(crate) evidence: Evidence,
    random: Random,
    watch: &'a Watch<'a>,
    /// The number of paths followed in the search.
    paths: AtomicUsize,
    is_ended: AtomicBool,
}

impl<'a, G: Listing<N>, const N: usize> Generic<'a, G, N> {
    /// Finds the roots of a random member near the one of which `q` is a root, until all are found, or `watch` or the
    /// limit ends the search.
    ///
    /// Duff, Hill, Jensen, Lee, Leykin and Sommars 2019, Solving polynomial systems via homotopy
    /// continuation and monodromy.
    pub(crate) fn new(
        family: Family<G, N>,
        q: &SVector<f64, N>,
        drives: Drives<G, N>,
        mut random: Random,
        watch: &'a Watch<'a>,
    ) -> Self {
        let tilted = Plane {
            tilted: 1.0,
            turned: Complex::ZERO,
        };
        let root = q.map(Complex::from) + random.vector::<N>(family.size);
        let member = Member {
            fixed: family.general_fixed(&mut random),
            drives,
            right: Vector::zeros(),
            plane: tilted,
        };
        let mut generic = Self {
            member: family.with_root(&root, member),
            family,
            roots: vec![root],
            evidence: Evidence::default(),
            random,
            watch,
            paths: AtomicUsize::new(0),
            is_ended: AtomicBool::new(false),
        };
        generic.start(q);
        generic.go_round();
        if *generic.is_ended.get_mut() {
            generic.evidence.ended_after = Some(*generic.paths.get_mut());
        }
        generic
    }

    /// Follows random points to this member, from the members of which they are roots.
    fn start(&mut self, q: &SVector<f64, N>) {
        let starts: Vec<Vector<N>> = (0..STARTS)
            .map(|index| {
                // From a third of the linkage's size to thirty times that.
                let size = 10_f64.powf(-0.5 + 2.0 * (index as f64) / (STARTS as f64));
                q.map(Complex::from) + self.random.vector::<N>(self.family.size * size)
            })
            .collect();
        self.evidence.starts = starts.len();
        let ends = self.each(Stage::Search, &starts, |start| {
            let from = self.family.with_root(start, self.member);
            follow(&[self.family.line(from, self.member)], start)
        });
        self.add(ends);
    }

    /// Follows the roots along loops until there is good reason to believe that they are complete. A root that the
    /// trace test misses may need more loops than those that were quiet.
    fn go_round(&mut self) {
        while self.evidence.loops < MOST_LOOPS {
            if self.evidence.quiet >= QUIET {
                self.evidence.trace = self.bend();
                if self.evidence.is_convincing() {
                    break;
                }
            }
            let round = [self.waypoint(LOOP), self.waypoint(LOOP), self.member];
            let ends = self.follow_all(Stage::Search, &self.lines(round));
            let known = self.roots.len();
            self.add(ends);
            if *self.is_ended.get_mut() {
                break;
            }
            self.evidence.loops += 1;
            self.evidence.quiet += 1;
            if self.roots.len() > known {
                self.evidence.quiet = 0;
            }
        }
    }

    /// The end of a way from each root; `None` for roots that are no longer followed.
    pub(crate) fn follow_all(&self, stage: Stage, way: &[Line<'_, G, N>]) -> Vec<Option<End<N>>> {
        self.each(stage, &self.roots, |root| follow(way, root))
    }

    fn each(
        &self,
        stage: Stage,
        roots: &[Vector<N>],
        end: impl Fn(&Vector<N>) -> End<N> + Sync,
    ) -> Vec<Option<End<N>>> {
        parallel::map(roots, |root| self.goes_on(stage).then(|| end(root)))
    }

    /// Whether one more root is followed.
    fn goes_on(&self, stage: Stage) -> bool {
        let watched = || (self.watch)(stage, self.roots.len());
        if stage == Stage::Follow {
            return watched();
        }
        let is_within = || self.paths.load(Ordering::Relaxed) < MOST_PATHS;
        let goes_on = !self.is_ended.load(Ordering::Relaxed) && is_within() && watched();
        if goes_on {
            self.paths.fetch_add(1, Ordering::Relaxed);
        } else {
            self.is_ended.store(true, Ordering::Relaxed);
        }
        goes_on
    }

    /// A random member for a detour.
    pub(crate) fn detour(&mut self) -> MemberOf<G, N> {
        self.waypoint(DETOUR)
    }

    /// A random member at this distance. It has other chassis points too: those of a mechanism are special, for
    /// example if axes of wishbones are nearly parallel, and each way approaches them from another side.
    fn waypoint(&mut self, away: f64) -> MemberOf<G, N> {
        let mut member = self.member;
        member.fixed = self.family.general_fixed(&mut self.random);
        member.right += self.random.vector::<N>(away * self.family.size);
        member
    }

    /// The way from here to a member.
    pub(crate) fn lines(
        &self,
        way: impl IntoIterator<Item = MemberOf<G, N>>,
    ) -> Vec<Line<'_, G, N>> {
        let mut from = self.member;
        way.into_iter()
            .map(|to| {
                let line = self.family.line(from, to);
                from = to;
                line
            })
            .collect()
    }

    /// The trace test; `None` if there is no plane to turn.
    fn bend(&mut self) -> Option<f64> {
        let turned = self.random.vector::<1>(1.0).x;
        let tilt = self.family.tilt.as_ref()?;
        let sum = |times: f64| {
            let mut member = self.member;
            member.plane.turned = turned * times;
            member.right[tilt.row] += tilt.away * turned * Complex::from(times);
            let ends = self.follow_all(Stage::Search, &self.lines([member]));
            sum_of(ends, |root| tilt.seen(root))
        };
        let (Some(one), Some(two)) = (sum(1.0), sum(2.0)) else {
            return Some(f64::INFINITY);
        };
        let none: Vector<N> = self.roots.iter().map(|root| tilt.seen(root)).sum();
        let bend = (two - one * Complex::from(2.0) + none).camax();
        Some(bend / (two - none).camax())
    }

    fn add(&mut self, ends: Vec<Option<End<N>>>) {
        for end in ends {
            if let Some(End::Root(root)) = end {
                add_distinct(&mut self.roots, root, self.family.size);
            }
        }
    }
}

/// A sum over the roots, if all ends are roots.
fn sum_of<const N: usize>(
    ends: Vec<Option<End<N>>>,
    of: impl Fn(&Vector<N>) -> Vector<N>,
) -> Option<Vector<N>> {
    ends.into_iter()
        .try_fold(Vector::zeros(), |sum, end| match end {
            Some(End::Root(root)) => Some(sum + of(&root)),
            Some(End::Infinite | End::Lost) | None => None,
        })
}

/// Adds a root that is not yet among the others.
pub(crate) fn add_distinct<const N: usize>(roots: &mut Vec<Vector<N>>, root: Vector<N>, size: f64) {
    const SAME: f64 = 1e-6;
    let apart = SAME * (size + root.camax());
    if roots.iter().all(|other| (other - root).camax() > apart) {
        roots.push(root);
    }
}

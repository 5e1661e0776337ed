//! The ways to assemble a mechanism.

use nalgebra::SVector;
use suspension_core::listing::{DriveKind, Kind, Parts};
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Inputs, Motion, Still, Values};

use crate::assemblies::{Assemblies, Tally, Watch};
use crate::kinematics::equations::jacobian;
use crate::mechanism::{Mechanism, State, Suspension, inputs_at_rest};

/// A real assembly.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// The distance from the configuration of the file's first instant: the norm over all coordinates, in the file's
    /// unit.
    pub distance: f64,
    /// The largest distance that a point has moved.
    pub farthest: f64,
    /// Its number in the list, from 1.
    pub number: usize,
    /// The smallest singular value of the Jacobian; zero if it is singular.
    pub smallest_singular_value: f64,
    /// The points that are on the wrong side of the points that links join them to: a mirror image that has all
    /// lengths and cannot be built.
    pub mirrored: Vec<String>,
    /// The mechanism at rest.
    pub state: State,
}

/// The search for all assemblies of a mechanism.
pub trait Assembled {
    /// The real assemblies at values of the drives, in local coordinates, in order of their distance from the
    /// configuration of the first instant, and the outcome for all solutions; `None` if the search is given up.
    fn at(&mut self, drives: &[f64]) -> Option<(Vec<Assembly>, Tally)>;
}

/// The search over the equations of a mechanism.
pub(super) struct Enumerated<'a, L: Suspension<N>, const N: usize> {
    mechanism: &'a Mechanism<L, N>,
    search: Assemblies<'a, L, N>,
}

impl<'a, L: Suspension<N>, const N: usize> Enumerated<'a, L, N> {
    pub(super) fn new(mechanism: &'a Mechanism<L, N>, watch: &'a Watch<'a>) -> Self {
        let inputs = inputs_at_rest(mechanism.start_drives());
        let Mechanism { model, start, .. } = mechanism;
        let search = Assemblies::new(model, &start.position, &inputs, watch);
        Self { mechanism, search }
    }

    /// Whether all points are at the same positions: if an angle about an axis is zero or half a turn, its quarter
    /// has two values.
    fn is_same(&self, a: &SVector<f64, N>, b: &SVector<f64, N>) -> bool {
        const APART: f64 = 1e-6;
        let model = &self.mechanism.model;
        let [a, b] = [a, b].map(|q| coordinates(model, q));
        let mut pairs = a.iter().zip(b);
        pairs.all(|(a, b)| (a - b).abs() < APART * model.size())
    }
}

impl<L: Suspension<N>, const N: usize> Assembled for Enumerated<'_, L, N> {
    fn at(&mut self, drives: &[f64]) -> Option<(Vec<Assembly>, Tally)> {
        let inputs = inputs_at_rest(L::Drives::from_values(drives.iter().copied()));
        let census = self.search.at(&inputs)?;
        let each = census.real.iter();
        let at_drives = each.filter(|q| is_at_angles(self.mechanism, &inputs, q));
        let mut drives = self.mechanism.names.drives.iter();
        let has_turns = drives.any(|drive| drive.kind == DriveKind::Turn);
        let mut distinct: Vec<&SVector<f64, N>> = Vec::new();
        for q in at_drives {
            if !(has_turns && distinct.iter().any(|other| self.is_same(q, other))) {
                distinct.push(q);
            }
        }
        let assemblies = distinct
            .iter()
            .map(|q| assembly(self.mechanism, &inputs, q));
        let assemblies = numbered(assemblies.collect());
        let tally = Tally {
            real: assemblies.len(),
            turned: census.real.len() - assemblies.len(),
            ..census.tally
        };
        Some((assemblies, tally))
    }
}

/// The assemblies in the order of their distances, with their numbers.
fn numbered(mut assemblies: Vec<Assembly>) -> Vec<Assembly> {
    assemblies.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    for (number, assembly) in (1..).zip(&mut assemblies) {
        assembly.number = number;
    }
    assemblies
}

/// Whether the driven angles about axes have the values to which they are driven.
fn is_at_angles<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    q: &SVector<f64, N>,
) -> bool {
    /// The largest error of angles, in radians: near a singularity positions have half their digits.
    const NEAR: f64 = 1e-4;
    let (model, names) = (&mechanism.model, &mechanism.names);
    let points = Motion::at_rest(*q).points(model, inputs).value;
    let (found, driven) = (model.drives_at(&points), inputs.drives.value);
    let mut pairs = found.values().zip(driven.values()).zip(&names.drives);
    pairs.all(|((found, driven), drive)| {
        let off = (0.5 * (found - driven)).sin().abs();
        drive.kind != DriveKind::Turn || off < NEAR
    })
}

/// The coordinates of the free points: the first of the unknowns.
fn coordinates<'q, const N: usize>(parts: &impl Parts, q: &'q SVector<f64, N>) -> &'q [f64] {
    let free = 3 * parts.count(Kind::FreePoint);
    &q.as_slice()[..free]
}

fn assembly<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    inputs: &Inputs<Still, L::Drives>,
    q: &SVector<f64, N>,
) -> Assembly {
    let Mechanism { model, start, .. } = mechanism;
    let moved = q - start.position;
    let moved = coordinates(model, &moved);
    let length = |along: &[f64]| along.iter().map(|x| x * x).sum::<f64>().sqrt();
    let farthest = moved.chunks(3).map(length).fold(0.0, f64::max);
    let points = Motion::at_rest(*q).points(model, inputs).value;
    let fixed = Prescribed::new(model, inputs).fixed.value;
    let sides = model.linked().zip(model.mirrored(q, &fixed));
    let mirrored = sides.filter(|(_, mirrored)| *mirrored > 0.5);
    let [first, _] = mechanism.instants.ends();
    Assembly {
        distance: length(moved),
        farthest,
        number: 0,
        smallest_singular_value: jacobian(mechanism, q, &fixed).singular_values().min(),
        mirrored: mirrored
            .map(|(point, _)| mechanism.names.points[point].clone())
            .collect(),
        state: mechanism.state_at_rest(first, &inputs.drives.value, points),
    }
}

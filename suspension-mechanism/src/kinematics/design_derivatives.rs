//! The derivatives of a mechanism with respect to its hardpoints and lengths.

use nalgebra::{SVector, Vector3};
use suspension_core::directions::Directions;
use suspension_core::solve::factored::Factored;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Build, Inputs, Linkage, Motion, Signal, SolveError, Still, Values};
use suspension_runtime::{AlongDrive, DesignChange, Factors, Model, Room, Size, Start, Unknowns};

use crate::mechanism::{DesignDerivatives, Expansion, Mechanism, inputs_at_rest, unit_change};

/// The fraction of the suspension's size by which a change of lengths must also be possible: close to an impossible
/// change, as for a body that hardly closes, derivatives mean little.
const FARTHEST: f64 = 6.4e-3;

/// The mechanism at its start, with the derivatives of its unknowns there.
struct AtStart<'a, 'l, const N: usize>
where
    Room<N>: Size,
{
    mechanism: &'a Mechanism<Model<'l, f64, N>, N>,
    start: Start<'a, 'l, f64, N>,
    factored: Factored<Factors<'l, f64, N>, f64, N>,
    /// The derivatives of the unknowns with respect to each drive.
    drives: Vec<Unknowns<f64, N>>,
    /// The second derivatives of the unknowns with respect to two drives: a row for each drive, up to itself.
    seconds: Vec<Unknowns<f64, N>>,
    expansion: Expansion,
}

/// `None` if the mechanism locks at its start.
pub(crate) fn design_derivatives<'a, const N: usize>(
    mechanism: &'a Mechanism<Model<'_, f64, N>, N>,
) -> Option<Box<dyn DesignDerivatives + 'a>>
where
    Room<N>: Size,
{
    let model = &mechanism.model;
    let drives = mechanism.start_drives();
    let inputs = inputs_at_rest(drives);
    let chassis = Prescribed::new(model, &inputs).fixed.value;
    let free = mechanism.start.position;
    let points = Motion::at_rest(free).points(model, &inputs).value;
    let start = Start {
        model,
        unknowns: Unknowns { free, chassis },
        points,
        drives,
    };
    let mut at_start = AtStart {
        mechanism,
        factored: Factored::new(model, &free, &chassis).ok()?,
        drives: Vec::new(),
        seconds: Vec::new(),
        expansion: expansion(mechanism, &start)?,
        start,
    };
    for drive in 0..mechanism.names.drives.len() {
        at_start.add(drive);
    }
    Some(Box::new(at_start))
}

/// The points and measures at the start.
fn expansion<const N: usize>(
    mechanism: &Mechanism<Model<'_, f64, N>, N>,
    start: &Start<'_, '_, f64, N>,
) -> Option<Expansion>
where
    Room<N>: Size,
{
    let names = &mechanism.names;
    let count = names.points.len();
    let (model, position) = (start.model, &start.unknowns.free);
    let points = Directions::at(model, start.drives, position, |directions| {
        let mut all: Vec<_> = start.points.values().take(count).collect();
        let drives = 0..names.drives.len();
        let along = drives.map(|drive| directions.first(unit_change(drive)));
        let along: Vec<_> = along.collect::<Result<_, _>>()?;
        for direction in &along {
            all.extend(direction.points.values().take(count));
        }
        for (index, other) in along.iter().enumerate() {
            for one in along.iter().take(index) {
                all.extend(directions.mixed([one, other])?.values().take(count));
            }
            all.extend(directions.second(other)?.values().take(count));
        }
        Ok::<_, SolveError<f64>>(all)
    });
    let points = points.ok()?;
    let still = |_: usize| Vector3::zeros();
    let at_rest = measures(model, &points, still, still);
    let mut all: Vec<f64> = at_rest.iter().map(|measure| measure.value).collect();
    for drive in 1..=names.drives.len() {
        let along = measures(model, &points, |place| points[drive * count + place], still);
        all.extend(along.iter().map(|measure| measure.rate));
    }
    Some(Expansion {
        points,
        measures: all,
    })
}

/// A model's measures for points with these changes.
fn measures<const N: usize>(
    model: &Model<'_, f64, N>,
    points: &[Vector3<f64>],
    rate: impl Fn(usize) -> Vector3<f64>,
    second_rate: impl Fn(usize) -> Vector3<f64>,
) -> Vec<Signal<f64>>
where
    Room<N>: Size,
{
    let point = |place: usize| Signal {
        value: points[place],
        rate: rate(place),
        second_rate: second_rate(place),
    };
    model.measures_of(point).collect()
}

impl<const N: usize> AtStart<'_, '_, N>
where
    Room<N>: Size,
{
    /// Adds the derivatives with respect to the next drive.
    fn add(&mut self, drive: usize) {
        let Start {
            model,
            unknowns,
            drives,
            ..
        } = &self.start;
        let inputs: Inputs<Still, _> = Inputs::still(Signal {
            rate: unit_change(drive),
            ..Signal::still(*drives)
        });
        let Prescribed { fixed, drives } = Prescribed::new(*model, &inputs);
        let terms =
            |chassis, drives| model.drive_rate(&unknowns.free, &fixed.value, chassis, drives);
        let first = Unknowns {
            free: self.solved(&terms(&fixed.rate, &drives.rate)),
            chassis: fixed.rate,
        };
        let bent = |other: &Unknowns<f64, N>| {
            model.curvature(&first.free, &first.chassis, &other.free, &other.chassis)
        };
        let others = self.drives.iter();
        let mixed = others.map(|other| -self.solved(&bent(other)));
        let mut seconds: Vec<_> = mixed.map(Unknowns::from_free).collect();
        let terms = terms(&fixed.second_rate, &drives.second_rate) - bent(&first);
        seconds.push(Unknowns {
            free: self.solved(&terms),
            chassis: fixed.second_rate,
        });
        self.seconds.extend(seconds);
        self.drives.push(first);
    }

    fn solved(&self, right: &SVector<f64, N>) -> SVector<f64, N> {
        self.factored.factors().solve(right)
    }

    /// The change of the measures, and of their derivatives with respect to each drive, for points with these changes.
    /// Mixed derivatives are half of the difference between the second derivative along both and the sum of those along
    /// each.
    fn changed_measures(&self, changed: &[Vector3<f64>]) -> Vec<f64> {
        let (model, start) = (self.start.model, &self.expansion.points);
        let count = self.mechanism.names.points.len();
        let still = |_: usize| Vector3::zeros();
        let alone = measures(model, start, |place| changed[place], still);
        let mut all: Vec<f64> = alone.iter().map(|measure| measure.rate).collect();
        for first in (1..=self.drives.len()).map(|drive| drive * count) {
            let of_drive = measures(model, start, |place| start[first + place], still);
            let together = measures(
                model,
                start,
                |place| changed[place] + start[first + place],
                |place| changed[first + place] * 2.0,
            );
            let apart = alone.iter().zip(&of_drive);
            let mixed = together
                .iter()
                .zip(apart)
                .map(|(together, (change, drive))| {
                    (together.second_rate - change.second_rate - drive.second_rate) / 2.0
                });
            all.extend(mixed);
        }
        all
    }

    /// Whether lengths can change by much more.
    fn is_far_from_unbuildable(&self, lengths: &[(usize, f64)]) -> bool {
        let model = self.start.model;
        let by = FARTHEST * model.size();
        let is_buildable = |by: f64| {
            let longer = lengths.iter().fold(model.lengths(), |all, (length, unit)| {
                let [now] = all.at([*length]);
                all.with(*length, now + unit * by)
            });
            model.with_lengths(&longer).is_ok()
        };
        lengths.is_empty() || (is_buildable(by) && is_buildable(-by))
    }
}

impl<const N: usize> DesignDerivatives for AtStart<'_, '_, N>
where
    Room<N>: Size,
{
    fn start(&self) -> &Expansion {
        &self.expansion
    }

    fn along(
        &self,
        points: &[(usize, Vector3<f64>)],
        lengths: &[(usize, f64)],
    ) -> Option<Expansion> {
        if !self.is_far_from_unbuildable(lengths) {
            return None;
        }
        let change = DesignChange::new(&self.start, points, lengths)?;
        let mut moved = *change.moved();
        let residual = change.residual();
        if residual.iter().any(|row| *row != 0.0) {
            moved.free -= self.solved(&residual);
        }
        let firsts: Vec<Unknowns<f64, N>> = (0..)
            .zip(&self.drives)
            .map(|(drive, unknowns)| {
                self.solved(&change.first_right_hand_side(&moved, drive, unknowns))
            })
            .map(Unknowns::from_free)
            .collect();
        let per_drive = (0..).zip(self.drives.iter().zip(&firsts));
        let along: Vec<AlongDrive<'_, f64, N>> = per_drive
            .map(|(drive, (unknowns, changed))| AlongDrive {
                drive,
                unknowns,
                changed,
            })
            .collect();
        let terms = 1 + self.drives.len() + self.seconds.len();
        let count = self.mechanism.names.points.len();
        let mut points = Vec::with_capacity(terms * count);
        points.extend(change.points(&moved));
        for along in &along {
            points.extend(change.first(&moved, along));
        }
        let mut seconds = self.seconds.iter();
        for (index, other) in along.iter().enumerate() {
            for (one, both) in along.iter().take(index + 1).zip(&mut seconds) {
                let pair = [one, other];
                let changed = self.solved(&change.second_right_hand_side(&moved, pair, both));
                let changed = Unknowns::from_free(changed);
                points.extend(change.second(&moved, pair, [both, &changed]));
            }
        }
        let measures = self.changed_measures(&points);
        Some(Expansion { points, measures })
    }
}

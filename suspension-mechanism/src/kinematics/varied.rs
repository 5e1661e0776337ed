//! A mechanism whose numbers have derivatives along a change of its hardpoints and lengths.
//!
//! Each has an infinitesimal imaginary part, its derivative (Squire and Trapp 1998, SIAM Review 40, 110): the equations, their
//! solution and its derivatives with respect to the drives are computed as ever, and have theirs. Only those of the
//! model's constants, lengths and frames that are smooth in the hardpoints, are differences.

use nalgebra::{Complex, SMatrix, SVector, Vector3};
use suspension_core::factored::Factored;
use suspension_core::linkage::Listing;
use suspension_core::motion::Prescribed;
use suspension_core::{Inputs, Linkage, Signal, Still, Values};

use crate::kinematics::changed::{Built, Changes, build};
use crate::mechanism::{Mechanism, Suspension};

/// What stands for an infinitesimal: its square is nothing beside 1, and it scales without rounding.
const INFINITESIMAL: f64 = 1.0 / (1_u128 << 100) as f64;

/// How far neighbours are from each other, as a part of the suspension's size.
const STEP: f64 = 1e-4;

/// A change of lengths by so many steps must be possible too: close to one that is not, as of a body that hardly closes,
/// differences say little.
const FARTHEST: f64 = 64.0;

/// The difference of sixth order: neighbours on either side by so many steps, and their weight over 60 steps.
const WEIGHTS: [(f64, f64); 3] = [(1.0, 45.0), (2.0, -9.0), (3.0, 1.0)];

pub(super) type Number = Complex<f64>;
type Model<L, const N: usize> = <<L as Linkage<N>>::Listing as Listing<N>>::Model<Number>;

/// The number with a derivative.
pub(super) fn varied(value: f64, derivative: f64) -> Number {
    Complex::new(value, derivative * INFINITESIMAL)
}

/// The derivative of a number.
pub(super) fn derivative(number: Number) -> f64 {
    number.im / INFINITESIMAL
}

/// The mechanism at its start.
pub(super) struct Varied<'a, L: Suspension<N>, const N: usize> {
    factored: &'a Factored<L::Factors, f64, N>,
    model: Model<L, N>,
    drives: <Model<L, N> as Linkage<N>>::Drives,
    position: SVector<Number, N>,
    jacobian: SMatrix<Number, N, N>,
}

/// All points, with the first two derivatives along a direction of the drives.
pub(super) type Along = Signal<Vec<Vector3<Number>>>;

impl<'a, L: Suspension<N>, const N: usize> Varied<'a, L, N> {
    /// `None` where no such suspensions can be built.
    pub(super) fn of(
        mechanism: &Mechanism<L, N>,
        changes: &Changes,
        factored: &'a Factored<L::Factors, f64, N>,
    ) -> Option<Self> {
        let step = STEP * mechanism.model.size();
        let beside = |steps: f64| build(mechanism, &changes.times(steps * step));
        if !changes.lengths.is_empty() {
            beside(FARTHEST).and(beside(-FARTHEST))?;
        }
        let pairs = WEIGHTS.map(|(steps, _)| Some([beside(steps)?, beside(-steps)?]));
        let pairs: Option<Vec<[Built<L, N>; 2]>> = pairs.into_iter().collect();
        let pairs = pairs?;
        let along_change = |value: f64, of: &dyn Fn(&Built<L, N>) -> f64| {
            let terms = pairs.iter().zip(WEIGHTS);
            let sum: f64 = terms
                .map(|([above, below], (_, weight))| weight * (of(above) - of(below)))
                .sum();
            varied(value, sum / (60.0 * step))
        };
        let model = <L::Listing as Listing<N>>::gather(&mechanism.model, |read| {
            along_change(read(&mechanism.model), &|each| read(&each.model))
        });
        let drives = mechanism.first_drives().into_iter().enumerate();
        let drives = drives.map(|(drive, value)| {
            along_change(value, &|each| {
                each.drives.values().nth(drive).unwrap_or(value)
            })
        });
        Some(Self::solved(
            model,
            Values::from_values(drives),
            &mechanism.start.position,
            factored,
        ))
    }

    /// The position follows from one iteration: what is left of it is real.
    fn solved(
        model: Model<L, N>,
        drives: <Model<L, N> as Linkage<N>>::Drives,
        position: &SVector<f64, N>,
        factored: &'a Factored<L::Factors, f64, N>,
    ) -> Self {
        let inputs: Inputs<Still, _> = Inputs::still(Signal::still(drives));
        let Prescribed {
            fixed,
            drives: coordinates,
        } = Prescribed::new(&model, &inputs);
        let start = position.map(Complex::from);
        let residual = model.residual(&start, &fixed.value, &coordinates.value);
        let correction = factored.factors().solve(&residual.map(|entry| entry.im));
        let position = start - correction.map(|entry| Complex::new(0.0, entry));
        Self {
            jacobian: model.jacobian(&position, &fixed.value),
            factored,
            model,
            drives,
            position,
        }
    }

    /// Solves `J x = right`: with the real Jacobian, then for what its derivative has left.
    fn solve(&self, right: &SVector<Number, N>) -> SVector<Number, N> {
        let factors = self.factored.factors();
        let by_parts = |right: &SVector<Number, N>| {
            let [re, im] = [right.map(|entry| entry.re), right.map(|entry| entry.im)];
            factors
                .solve(&re)
                .zip_map(&factors.solve(&im), Complex::new)
        };
        let first = by_parts(right);
        first - by_parts(&(self.jacobian * first - right))
    }

    /// Where these drives change by one, and nothing else does.
    pub(super) fn along(&self, drives: &[usize]) -> Along {
        let none = Values::from_values([]);
        let one = Complex::from(1.0);
        let change = drives.iter().fold(
            none,
            |change: <Model<L, N> as Linkage<N>>::Drives, drive| change.with(*drive, one),
        );
        let inputs: Inputs<Still, _> = Inputs::still(Signal {
            rate: change,
            ..Signal::still(self.drives)
        });
        let Prescribed { fixed, drives } = Prescribed::new(&self.model, &inputs);
        let terms = |fixed_rate, rate| {
            self.model
                .drive_rate(&self.position, &fixed.value, fixed_rate, rate)
        };
        let velocity = self.solve(&terms(&fixed.rate, &drives.rate));
        let curvature = self
            .model
            .curvature(&velocity, &fixed.rate, &velocity, &fixed.rate);
        let acceleration =
            self.solve(&(terms(&fixed.second_rate, &drives.second_rate) - curvature));
        let value = self.model.points(&self.position, &fixed.value);
        let rate = self.model.velocities(&value, &velocity, &fixed.rate);
        let second_rate =
            self.model
                .accelerations(&value, &rate, &acceleration, &fixed.second_rate);
        Signal {
            value,
            rate,
            second_rate,
        }
        .map(|points| points.values().collect())
    }
}

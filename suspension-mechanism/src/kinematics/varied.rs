//! A mechanism whose numbers have derivatives along a change of its hardpoints and lengths.
//!
//! Each has an infinitesimal imaginary part, its derivative (Squire and Trapp 1998, SIAM Review 40, 110): the equations, their
//! solution and its derivatives with respect to the drives are computed as ever, and have theirs. Only those of the
//! model's constants, lengths and frames that are smooth in the hardpoints, are differences.

use nalgebra::{Complex, SVector, Vector3};
use suspension_core::linkage::{Factors, Listing};
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
type FixedOf<L, const N: usize> = <Model<L, N> as Linkage<N>>::Fixed;

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
    factors: &'a dyn Factors<f64, N>,
    model: Model<L, N>,
    drives: <Model<L, N> as Linkage<N>>::Drives,
    position: SVector<Number, N>,
    /// How many points the listing has; a model has room for more.
    points: usize,
}

/// All points, with the first two derivatives along a direction of the drives.
pub(super) type Along = Signal<Vec<Vector3<Number>>>;

impl<'a, L: Suspension<N>, const N: usize> Varied<'a, L, N> {
    /// The mechanism with points where it starts; `None` where no such suspensions can be built.
    pub(super) fn of(
        mechanism: &Mechanism<L, N>,
        points: &L::Points,
        changes: &Changes,
        factors: &'a dyn Factors<f64, N>,
    ) -> Option<Self> {
        let step = STEP * mechanism.model.size();
        let beside = |steps: f64| build(mechanism, *points, &changes.times(steps * step));
        if !changes.lengths.is_empty() {
            beside(FARTHEST).and(beside(-FARTHEST))?;
        }
        let mut neighbours: Vec<(Built<L, N>, f64)> = Vec::with_capacity(2 * WEIGHTS.len());
        for (steps, weight) in WEIGHTS {
            neighbours.push((beside(steps)?, weight));
            neighbours.push((beside(-steps)?, -weight));
        }
        let along_change = |value: f64, of: &dyn Fn(&Built<L, N>) -> f64| {
            let terms = neighbours.iter().map(|(built, weight)| weight * of(built));
            varied(value, terms.sum::<f64>() / (60.0 * step))
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
            mechanism,
            factors,
        ))
    }

    /// The position follows from one iteration: what is left of it is real.
    fn solved(
        model: Model<L, N>,
        drives: <Model<L, N> as Linkage<N>>::Drives,
        mechanism: &Mechanism<L, N>,
        factors: &'a dyn Factors<f64, N>,
    ) -> Self {
        let inputs: Inputs<Still, _> = Inputs::still(Signal::still(drives));
        let Prescribed {
            fixed,
            drives: coordinates,
        } = Prescribed::new(&model, &inputs);
        let start = mechanism.start.position.map(Complex::from);
        let residual = model.residual(&start, &fixed.value, &coordinates.value);
        let correction = factors.solve(&residual.map(|entry| entry.im));
        Self {
            position: start - correction.map(|entry| Complex::new(0.0, entry)),
            factors,
            model,
            drives,
            points: mechanism.names.points.len(),
        }
    }

    /// Solves `J x = right`: with the real Jacobian, then for what its derivative has left.
    fn solve(&self, fixed: &FixedOf<L, N>, right: &SVector<Number, N>) -> SVector<Number, N> {
        let x = self.factors.solve(&right.map(|entry| entry.re));
        let product = self.times_jacobian(fixed, &x.map(Complex::from));
        let rest = self.factors.solve(&(right - product).map(|entry| entry.im));
        x.zip_map(&rest, Complex::new)
    }

    /// `J x`, without a matrix: half of what quadratic equations differ by from `q - x` to `q + x`.
    fn times_jacobian(&self, fixed: &FixedOf<L, N>, x: &SVector<Number, N>) -> SVector<Number, N> {
        let beside = |position| {
            self.model
                .residual(&position, fixed, &Values::from_values([]))
        };
        (beside(self.position + x) - beside(self.position - x)) * Complex::from(0.5)
    }

    /// Where these drives change by one, and nothing else does; twice the same is one drive.
    pub(super) fn along(&self, drives: [usize; 2]) -> Along {
        let one = Complex::from(1.0);
        let change = drives.into_iter().fold(
            Values::from_values([]),
            |change: <Model<L, N> as Linkage<N>>::Drives, drive| change.with(drive, one),
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
        let velocity = self.solve(&fixed.value, &terms(&fixed.rate, &drives.rate));
        let curvature = self
            .model
            .curvature(&velocity, &fixed.rate, &velocity, &fixed.rate);
        let acceleration = terms(&fixed.second_rate, &drives.second_rate) - curvature;
        let acceleration = self.solve(&fixed.value, &acceleration);
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
        .map(|points| points.values().take(self.points).collect())
    }
}

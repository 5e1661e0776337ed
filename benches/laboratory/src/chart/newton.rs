//! Newton's method with a dense factorisation, to the same tolerance as the core's.

use nalgebra::{Const, DimMin, SMatrix, SVector};
use suspension_core::solve::lu::Lu;
use suspension_core::{Newton as Settings, Real};

use super::course::Given;
use super::formulation::{Formulation, State};
use super::method::{Coordinates, Method, Outputs};

/// A dense factorisation.
pub trait Dense<T, const M: usize>: Copy {
    /// The factors.
    type Factors;

    /// Factors a Jacobian; `None` where it is singular.
    fn factor(&self, jacobian: SMatrix<T, M, M>) -> Option<Self::Factors>;

    /// Solves with the factors; `None` where they are singular.
    fn solve(&self, factors: &Self::Factors, right: &SVector<T, M>) -> Option<SVector<T, M>>;
}

/// `lu()` of nalgebra.
#[derive(Clone, Copy, Debug)]
pub struct Nalgebra;

impl<T: Real, const M: usize> Dense<T, M> for Nalgebra
where
    Const<M>: DimMin<Const<M>, Output = Const<M>>,
{
    type Factors = nalgebra::LU<T, Const<M>, Const<M>>;

    fn factor(&self, jacobian: SMatrix<T, M, M>) -> Option<Self::Factors> {
        Some(jacobian.lu())
    }

    fn solve(&self, factors: &Self::Factors, right: &SVector<T, M>) -> Option<SVector<T, M>> {
        let mut x = *right;
        factors.solve_mut(&mut x).then_some(x)
    }
}

/// The dense LU of the core.
#[derive(Clone, Copy, Debug)]
pub struct Own;

impl<T: Real, const M: usize> Dense<T, M> for Own {
    type Factors = Lu<T, M>;

    fn factor(&self, jacobian: SMatrix<T, M, M>) -> Option<Self::Factors> {
        Lu::factor(&jacobian).ok()
    }

    fn solve(&self, factors: &Self::Factors, right: &SVector<T, M>) -> Option<SVector<T, M>> {
        Some(factors.solve(right))
    }
}

/// Newton's method on a formulation: it predicts to second order, iterates until the residual is at rounding level, then
/// corrects once more with the same factors; velocity and acceleration follow from one factorisation at the root.
#[derive(Clone, Copy, Debug)]
pub struct Newton<T, F, S, const M: usize> {
    formulation: F,
    dense: S,
    settings: Settings<T>,
}

impl<T: Real, F, S, const M: usize> Newton<T, F, S, M> {
    /// The equations of `formulation`, factored by `dense`.
    pub fn new(formulation: F, dense: S) -> Self {
        let settings = Settings::near_by();
        Self {
            formulation,
            dense,
            settings,
        }
    }

    fn root<D, const N: usize>(
        &self,
        input: &F::Input,
        start: SVector<T, M>,
    ) -> Option<SVector<T, M>>
    where
        F: Formulation<T, D, M, N>,
        S: Dense<T, M>,
    {
        let mut x = start;
        let mut residual = self.formulation.residual(&x, input);
        for _ in 0..self.settings.max_iterations {
            let factors = self.dense.factor(self.formulation.jacobian(&x, input))?;
            x -= self.dense.solve(&factors, &residual)?;
            residual = self.formulation.residual(&x, input);
            let size = self.formulation.size().max(x.amax());
            if residual.amax() <= self.settings.tolerance.length(T::EPSILON * size) {
                let better = x - self.dense.solve(&factors, &residual)?;
                let left = self.formulation.residual(&better, input);
                return Some(if left.amax() < residual.amax() {
                    better
                } else {
                    x
                });
            }
        }
        None
    }
}

impl<T, D, F, S, const M: usize, const N: usize> Method<D, N> for Newton<T, F, S, M>
where
    T: Real,
    F: Formulation<T, D, M, N>,
    S: Dense<T, M>,
{
    type Input = F::Input;
    type State = State<T, M>;

    fn input(&self, _: &Given<D>, to: &Given<D>) -> F::Input {
        self.formulation.input(&to.signal)
    }

    fn rest(&self, position: &SVector<f64, N>) -> State<T, M> {
        let x = self.formulation.near_points(position);
        [x, SVector::zeros(), SVector::zeros()]
    }

    fn step(
        &self,
        outputs: Outputs,
        input: &F::Input,
        dt: f64,
        [x, dx, ddx]: &State<T, M>,
    ) -> Option<State<T, M>> {
        let dt = T::constant(dt);
        let predicted = x + (dx + ddx * (dt * T::constant(0.5))) * dt;
        let mut next = [self.root(input, predicted)?, *dx, *ddx];
        if outputs == Outputs::Position {
            return Some(next);
        }
        let factors = self
            .dense
            .factor(self.formulation.jacobian(&next[0], input))?;
        next[1] = self
            .dense
            .solve(&factors, &self.formulation.rate(&next[0], input))?;
        if outputs == Outputs::Acceleration {
            let right = self.formulation.second_rate(&next[0], &next[1], input);
            next[2] = self.dense.solve(&factors, &right)?;
        }
        Some(next)
    }

    fn coordinates(&self, state: &State<T, M>) -> Coordinates<N> {
        self.formulation.points(state)
    }
}

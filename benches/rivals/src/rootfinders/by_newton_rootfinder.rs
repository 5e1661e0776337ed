use std::convert::Infallible;

use newton_rootfinder::iteratives::{IterativeParams, Iteratives};
use newton_rootfinder::model::{Model, ModelError};
use newton_rootfinder::residuals::{
    JacobianValues, NormalizationMethod, ResidualsConfig, ResidualsValues,
};
use newton_rootfinder::solver::{ResolutionMethod, RootFinder, SolverParameters};
use suspension_core::nalgebra::Const;

use crate::mechanism::Matrix;
use crate::{Inputs, Mechanism, Method, STEP, Stopwatch, Vector};

/// The tolerance of the largest residual, m.
const TOLERANCE: f64 = 1e-13;
const MOST_ITERATIONS: usize = 50;

struct Equations<'a> {
    mechanism: &'a Mechanism,
    inputs: &'a Inputs,
    q: Vector,
    residual: Vector,
}

impl Model<Const<15>> for Equations<'_> {
    type InaccurateValuesError = Infallible;
    type UnusableValuesError = Infallible;
    type Memory = ();

    fn set_iteratives(&mut self, q: &Vector) {
        self.q = *q;
    }

    fn get_iteratives(&self) -> Vector {
        self.q
    }

    fn evaluate(&mut self) -> Result<(), ModelError<Self, Const<15>>> {
        self.residual = self.mechanism.residual(&self.q, self.inputs);
        Ok(())
    }

    fn get_residuals(&self) -> ResidualsValues<Const<15>> {
        ResidualsValues::new(self.residual, Vector::zeros())
    }

    fn jacobian_provided(&self) -> bool {
        true
    }

    fn get_jacobian(&mut self) -> Result<JacobianValues<Const<15>>, ModelError<Self, Const<15>>> {
        let jacobian = self.mechanism.jacobian(&self.q);
        Ok(JacobianValues::new(jacobian, Matrix::zeros()))
    }
}

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let method = Method {
        name: "newton_rootfinder NewtonRaphson",
        version: "0.12.0",
        note: "analytic Jacobian (ours), static size, residual tolerance 1e-13",
    };
    let parameters = std::array::from_fn::<_, 15, _>(|_| IterativeParams::default());
    let iteratives = Iteratives::new(&parameters);
    let absolute = [NormalizationMethod::Abs; 15];
    let residuals = ResidualsConfig::new(&absolute, &absolute);
    watch.part(&method, "position", |start| {
        let newton = ResolutionMethod::NewtonRaphson;
        let settings = SolverParameters::new(TOLERANCE, MOST_ITERATIONS, newton, false);
        let mut solver = RootFinder::new(settings, &iteratives, &residuals);
        let mut equations = Equations {
            mechanism,
            inputs: &start.inputs,
            q: start.motion.predict(STEP),
            residual: Vector::zeros(),
        };
        solver.solve(&mut equations).expect("a regular motion");
        equations.q
    });
}

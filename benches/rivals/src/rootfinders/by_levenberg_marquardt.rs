use levenberg_marquardt::{LeastSquaresProblem, LevenbergMarquardt};
use nalgebra_034::{Const, Owned, SMatrix, SVector};

use crate::{Inputs, Mechanism, Method, STEP, Stopwatch, Vector};

type Size = Const<15>;

struct Problem<'a> {
    mechanism: &'a Mechanism,
    inputs: &'a Inputs,
    q: Vector,
}

impl LeastSquaresProblem<f64, Size, Size> for Problem<'_> {
    type ParameterStorage = Owned<f64, Size>;
    type ResidualStorage = Owned<f64, Size>;
    type JacobianStorage = Owned<f64, Size, Size>;

    fn set_params(&mut self, q: &SVector<f64, 15>) {
        self.q = Vector::from(q.data.0[0]);
    }

    fn params(&self) -> SVector<f64, 15> {
        SVector::from(self.q.data.0[0])
    }

    fn residuals(&self) -> Option<SVector<f64, 15>> {
        let residual = self.mechanism.residual(&self.q, self.inputs);
        Some(SVector::from(residual.data.0[0]))
    }

    fn jacobian(&self) -> Option<SMatrix<f64, 15, 15>> {
        Some(SMatrix::from(self.mechanism.jacobian(&self.q).data.0))
    }
}

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let method = Method {
        name: "levenberg-marquardt",
        version: "0.15.0",
        note: "analytic Jacobian (ours), static size, tolerances 1e-8, no scaling",
    };
    let solver = LevenbergMarquardt::new()
        .with_tol(1e-8)
        .with_scale_diag(false);
    watch.part(&method, "position", |start| {
        let problem = Problem {
            mechanism,
            inputs: &start.inputs,
            q: start.motion.predict(STEP),
        };
        let (solved, _) = solver.minimize(problem);
        solved.q
    });
}

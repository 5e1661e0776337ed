use eqsolver::multivariable::MultiVarNewton;

use crate::{Mechanism, Method, STEP, Stopwatch, Vector};

/// The iteration ends with a step smaller than this, m.
const TOLERANCE: f64 = 1e-6;

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let method = Method {
        name: "eqsolver MultiVarNewton",
        version: "0.4.2",
        note: "analytic Jacobian (ours), static size, step tolerance 1e-6 (its default)",
    };
    watch.part(&method, "position", |start| {
        MultiVarNewton::new(
            |q: Vector| mechanism.residual(&q, &start.inputs),
            |q: Vector| mechanism.jacobian(&q),
        )
        .with_tol(TOLERANCE)
        .solve(start.motion.predict(STEP))
        .expect("a regular motion")
    });
}

use gomez::nalgebra::storage::{Storage, StorageMut};
use gomez::nalgebra::{Dyn, IsContiguous, Vector as DynVector};
use gomez::{Domain, Problem, SolverDriver, System};

use crate::{Inputs, Mechanism, Method, STEP, Stopwatch, Vector};

/// The tolerance of the norm of the residual, m; 1e-14 leaves position errors of 1e-13.
const TOLERANCE: f64 = 5e-16;
const MOST_ITERATIONS: usize = 50;

struct Equations<'a> {
    mechanism: &'a Mechanism,
    inputs: &'a Inputs,
}

impl Problem for Equations<'_> {
    type Field = f64;

    fn domain(&self) -> Domain<f64> {
        Domain::unconstrained(15)
    }
}

impl System for Equations<'_> {
    fn eval<Sx, Srx>(&self, x: &DynVector<f64, Dyn, Sx>, rx: &mut DynVector<f64, Dyn, Srx>)
    where
        Sx: Storage<f64, Dyn> + IsContiguous,
        Srx: StorageMut<f64, Dyn>,
    {
        let q = Vector::from_column_slice(x.as_slice());
        let residual = self.mechanism.residual(&q, self.inputs);
        rx.copy_from_slice(residual.as_slice());
    }
}

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let method = Method {
        name: "gomez TrustRegion",
        version: "0.5.1",
        note: "derivatives by differences, its only way; residual tolerance 5e-16",
    };
    watch.part(&method, "position", |start| {
        let equations = Equations {
            mechanism,
            inputs: &start.inputs,
        };
        let guess = start.motion.predict(STEP);
        let mut solver = SolverDriver::builder(&equations)
            .with_initial(guess.as_slice().to_vec())
            .build();
        let found =
            solver.find(|state| state.norm() <= TOLERANCE || state.iter() >= MOST_ITERATIONS);
        Vector::from_column_slice(found.expect("a regular motion").0)
    });
}

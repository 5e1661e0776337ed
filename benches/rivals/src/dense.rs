//! Dense LU with partial pivoting of the linear algebra crates, in Newton's method as ours has it.

use faer::linalg::solvers::{PartialPivLu, Solve};
use la_stack::{DEFAULT_PIVOT_TOL, Lu};
use suspension_core::nalgebra;

use crate::mechanism::Matrix;
use crate::{Inputs, Mechanism, Method, Motion, STEP, Stopwatch, Vector};

/// Iterations from the prediction to 1e-14 m.
const ITERATIONS: usize = 1;
const NOTE: &str = "1 iteration; our residual and Jacobian; a second factorisation for the rates";

trait Factors {
    fn factor(matrix: &Matrix) -> Self;
    fn solve(&self, right: &Vector) -> Vector;
}

pub(crate) fn time_all(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    faer::set_global_parallelism(faer::Par::Seq);
    time::<Nalgebra>(mechanism, watch, "nalgebra LU", "0.35.0");
    time::<PartialPivLu<f64>>(mechanism, watch, "faer partial_piv_lu", "0.24.4");
    time::<Lu<15>>(mechanism, watch, "la-stack Lu", "0.4.0");
}

fn time<F: Factors>(
    mechanism: &Mechanism,
    watch: &mut impl Stopwatch,
    name: &'static str,
    version: &'static str,
) {
    let method = Method {
        name,
        version,
        note: NOTE,
    };
    watch.part(&method, "newton", |start| {
        corrected::<F>(mechanism, start.motion.predict(STEP), &start.inputs)
    });
    watch.part(&method, "position", |start| {
        position::<F>(mechanism, &start.motion, &start.inputs)
    });
    watch.step(&method, |motion, inputs| {
        let q = position::<F>(mechanism, motion, inputs);
        let factors = F::factor(&mechanism.jacobian(&q));
        let velocity = factors.solve(&mechanism.speed(&q, inputs));
        Motion {
            position: q,
            velocity,
            acceleration: factors.solve(&mechanism.change(&q, &velocity, inputs)),
            positive_determinant: None,
        }
    });
}

fn position<F: Factors>(mechanism: &Mechanism, motion: &Motion, inputs: &Inputs) -> Vector {
    (0..ITERATIONS).fold(motion.predict(STEP), |q, _| {
        corrected::<F>(mechanism, q, inputs)
    })
}

fn corrected<F: Factors>(mechanism: &Mechanism, q: Vector, inputs: &Inputs) -> Vector {
    q - F::factor(&mechanism.jacobian(&q)).solve(&mechanism.residual(&q, inputs))
}

type Nalgebra = nalgebra::LU<f64, nalgebra::Const<15>, nalgebra::Const<15>>;

impl Factors for Nalgebra {
    fn factor(matrix: &Matrix) -> Self {
        matrix.lu()
    }

    fn solve(&self, right: &Vector) -> Vector {
        nalgebra::LU::solve(self, right).expect("regular")
    }
}

impl Factors for PartialPivLu<f64> {
    fn factor(matrix: &Matrix) -> Self {
        faer::MatRef::from_column_major_slice(matrix.as_slice(), 15, 15).partial_piv_lu()
    }

    fn solve(&self, right: &Vector) -> Vector {
        let mut solution = *right;
        let column = faer::MatMut::from_column_major_slice_mut(solution.as_mut_slice(), 15, 1);
        self.solve_in_place(column);
        solution
    }
}

impl Factors for Lu<15> {
    fn factor(matrix: &Matrix) -> Self {
        let rows = std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]));
        let matrix = la_stack::Matrix::from_rows(rows);
        matrix.lu(DEFAULT_PIVOT_TOL).expect("regular")
    }

    fn solve(&self, right: &Vector) -> Vector {
        let [right] = right.data.0;
        let solution = self.solve_vec(la_stack::Vector::new(right));
        Vector::from(solution.expect("regular").into_array())
    }
}

//! Crates for systems of nonlinear equations: only the position, from the same prediction.

mod by_eqsolver;
mod by_gomez;
mod by_levenberg_marquardt;
mod by_newton_rootfinder;

use crate::{Mechanism, Stopwatch};

pub(crate) fn time_all(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    by_newton_rootfinder::time(mechanism, watch);
    by_eqsolver::time(mechanism, watch);
    by_levenberg_marquardt::time(mechanism, watch);
    by_gomez::time(mechanism, watch);
}

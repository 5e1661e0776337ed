//! From a rough guess to a configuration.

mod assembly;
mod fit;
mod neighbour;
mod search;

use nalgebra::SVector;

use crate::arithmetic::scalar::Real;
use crate::error::SolveError;
use crate::linkage::Build;
use crate::listing::Kind;
use crate::model::handedness;
use crate::signal::{ChassisMotion, Inputs};
use crate::solve::motion::Prescribed;
use crate::solve::newton::Newton;

pub use assembly::Assembly;
pub use fit::{best_rigid_fit, best_rigid_motion};
use neighbour::beyond_singularity;
use search::{AROUND, Found, nearer, starts_around};

/// The number of starts of a search: the guess itself, others around it, and one beyond the singularity that is
/// nearest to the root found.
pub const STARTS: usize = AROUND + 2;

/// Finds the configuration nearest to the guess `q`, in the norm over all coordinates.
///
/// The search starts from the guess, and from others around it that are off by as much as the guess is. At each
/// start, each body, and each cluster of links that is as rigid as a body, is replaced by the rigid body that fits it
/// best, and the equations are solved. One more search starts where the root would lie that meets the root found at
/// the nearest singularity. The nearest root is kept; a root with a wrong-handed cluster never is.
///
/// The result is probably, but not certainly, the nearest root of all. The cost is bounded: [`STARTS`] times the
/// iterations that `newton` allows.
///
/// # Errors
///
/// The error of the start from the guess itself, if no start leads to a root; see [`SolveError`]. `q` is then
/// unchanged.
pub fn assemble<T, L, C, const N: usize>(
    newton: &Newton<T>,
    linkage: &L,
    inputs: &Inputs<C, L::Drives>,
    q: &mut SVector<T, N>,
) -> Result<Assembly<T>, SolveError<T>>
where
    T: Real,
    L: Build<N, Scalar = T>,
    C: ChassisMotion<L::Fixed>,
{
    let prescribed = Prescribed::new(linkage, inputs);
    let fixed = &prescribed.fixed.value;
    let off = linkage.residual(q, fixed, &prescribed.drives.value);
    let solve = |start: &SVector<T, N>| {
        let mut root = linkage.fit(start, fixed);
        let converged = newton.solve_prescribed(linkage, &prescribed, &mut root, None)?;
        handedness::check(linkage, &root, fixed)?;
        Ok(Found::new(root, q, converged))
    };
    let mut nearest = solve(q);
    for start in starts_around(q, linkage.count(Kind::Unknown), &off) {
        nearest = nearer(nearest, solve(&start), linkage.size());
    }
    if let Ok(found) = &nearest
        && let Ok(start) = beyond_singularity(linkage, fixed, &found.root)
    {
        nearest = nearer(nearest, solve(&start), linkage.size());
    }
    let Found { root, assembly } = nearest?;
    *q = root;
    Ok(assembly)
}

//! The linkages that the program can run.

use suspension_core::{Build, Linkage, Listing};

/// A linkage that this program can run.
pub trait Suspension<const N: usize>:
    Build<N, Scalar = f64>
    + Linkage<
        N,
        Listing: Listing<N, Model<f64> = Self> + Listing<N, Model<f32>: Build<N, Scalar = f32>>,
    >
{
}

impl<L, const N: usize> Suspension<N> for L where
    L: Build<N, Scalar = f64>
        + Linkage<
            N,
            Listing: Listing<N, Model<f64> = L> + Listing<N, Model<f32>: Build<N, Scalar = f32>>,
        >
{
}

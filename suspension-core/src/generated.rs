//! Items that generated code names; not for direct use.

mod stand_in;

pub use nalgebra::{SMatrix, SVector, Vector3};
#[cfg(feature = "macros")]
pub use suspension_macros::{Named, linkage as expand};

pub use crate::arithmetic::magnitude::sum_of_squares;
pub use crate::arithmetic::scalar::{Real, Scalar};
pub use crate::arithmetic::vector::{difference, dot, gather_vector, moved_along, opposite, xyz};
pub use crate::corner;
pub use crate::error::GeometryError;
pub use crate::linkage::{
    Build, Designed, Factors as JacobianFactors, HasKingpin, HasWheel, Linkage,
    Listing as AnyNumber, Named, Values,
};
pub use crate::listing::{DriveKind, MeasureKind, Names, Parts, WheelPlaces};
pub use crate::model::constraint::{
    Bilinear, Carried, Distance, Frame, Held, InPlane, OnLine, Product, Stretch, Turn,
    angle_to_coordinate, turn_to_coordinate,
};
pub use crate::model::handedness::Linked;
pub use crate::model::measure;
pub use crate::model::parts;
pub use crate::model::rows::Rows;
pub use crate::signal::Signal;
pub use crate::solve::assemble::best_rigid_fit;
pub use crate::solve::pivots::check as check_pivots;
pub use crate::values::gather_vectors;

/// A vector of its entries.
#[doc(hidden)]
#[macro_export]
macro_rules! vector_of {
    ($($entry:expr),*) => { $crate::nalgebra::SVector::from([$($entry),*]) };
}

/// The names of unknowns: each point's three coordinates, and scalars.
#[doc(hidden)]
#[macro_export]
macro_rules! unknown_names {
    ($($point:literal),*; $($scalar:literal),*) => {
        &[
            $(concat!($point, ".x"), concat!($point, ".y"), concat!($point, ".z"),)*
            $($scalar,)*
        ]
    };
}
pub use crate::{unknown_names, vector_of};
pub use stand_in::stand_in;

/// The product, computed in four chains side by side.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn product<T: Scalar, const K: usize>(numbers: [T; K]) -> T {
    let mut products = [T::one(); 4];
    for (index, number) in numbers.into_iter().enumerate() {
        if let Some(chain) = products.get_mut(index % 4) {
            *chain *= number;
        }
    }
    let [a, b, c, d] = products;
    (a * b) * (c * d)
}

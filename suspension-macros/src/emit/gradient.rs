//! The entries of an equation in the Jacobian, as data.

use proc_macro2::TokenStream;

use suspension_listing::name::Name;
use suspension_listing::system::Site;

/// The derivatives of an equation's rows with respect to its points and scalars, after the statements that compute
/// them.
pub(super) struct Gradient<'a> {
    pub(super) statements: TokenStream,
    pub(super) by: Vec<By<'a>>,
}

/// An expression of a derivative, and the variable.
pub(super) enum By<'a> {
    /// One row with respect to a point: a vector.
    Point(&'a Site, TokenStream),
    /// One row with respect to a coordinate of a point.
    Coordinate(&'a Site, usize, TokenStream),
    /// One row with respect to a scalar.
    Scalar(&'a Name, TokenStream),
    /// Three rows with respect to a point: a matrix.
    PointOfThree(&'a Site, TokenStream),
    /// Three rows with respect to a point: a multiple of the identity.
    Diagonal(&'a Site, TokenStream),
    /// Three rows with respect to a scalar: a vector.
    ScalarOfThree(&'a Name, TokenStream),
}

impl By<'_> {
    /// Whether the derivative is with respect to unknowns.
    pub(super) fn is_free(&self) -> bool {
        match self {
            Self::Point(site, _)
            | Self::Coordinate(site, ..)
            | Self::PointOfThree(site, _)
            | Self::Diagonal(site, _) => site.is_free(),
            Self::Scalar(..) | Self::ScalarOfThree(..) => true,
        }
    }
}

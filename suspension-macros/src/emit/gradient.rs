//! The entries of an equation in the Jacobian, as data.

use proc_macro2::TokenStream;

use suspension_listing::name::Name;
use suspension_listing::system::Site;

/// What an equation's rows are by its points and scalars, behind the statements that compute it.
pub(super) struct Gradient<'a> {
    pub(super) statements: TokenStream,
    pub(super) by: Vec<By<'a>>,
}

/// An expression and what the rows are by.
pub(super) enum By<'a> {
    /// One row by a point: a vector.
    Point(&'a Site, TokenStream),
    /// One row by a coordinate of a point.
    Coordinate(&'a Site, usize, TokenStream),
    /// One row by a scalar.
    Scalar(&'a Name, TokenStream),
    /// Three rows by a point: a matrix.
    PointOfThree(&'a Site, TokenStream),
    /// Three rows by a point: a multiple of the identity.
    Diagonal(&'a Site, TokenStream),
    /// Three rows by a scalar: a vector.
    ScalarOfThree(&'a Name, TokenStream),
}

impl By<'_> {
    /// Whether it is by unknowns.
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

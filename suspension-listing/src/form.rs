//! The forms: equations that the solver knows, each at most quadratic in the coordinates.
//!
//! A statement of a listing becomes equations of these forms. Only the register below
//! distinguishes the forms; all other code uses a form through [`Equations`].

mod along;
mod bilinear;
mod carried;
mod distance;
mod linear;
mod product;
mod stretch;
mod turn;

use crate::name::Name;
use crate::site::Site;
use crate::vector::Vector;

pub use along::Along;
pub use bilinear::{Bilinear, Factor, Multiplied, Variable};
pub use carried::Carried;
pub use distance::Distance;
pub use linear::{Linear, Prescribed, Term};
pub use product::Product;
pub use stretch::Stretch;
pub use turn::Turn;

/// One of the forms.
#[derive(Clone, Debug)]
pub enum Form {
    Distance(Distance),
    Carried(Carried),
    Linear(Linear),
    Along(Along),
    Stretch(Stretch),
    Product(Product),
    Bilinear(Bilinear),
    Turn(Turn),
}

impl Form {
    /// The functions that every form has.
    pub fn equations(&self) -> &dyn Equations {
        match self {
            Self::Distance(form) => form,
            Self::Carried(form) => form,
            Self::Linear(form) => form,
            Self::Along(form) => form,
            Self::Stretch(form) => form,
            Self::Product(form) => form,
            Self::Bilinear(form) => form,
            Self::Turn(form) => form,
        }
    }
}

/// One equation, or three for a vector.
pub trait Equations {
    /// The points that it joins.
    fn sites(&self) -> Vec<&Site>;

    /// Its unknowns that are not coordinates of points, and how all rows depend on each.
    fn scalars(&self) -> Vec<(&Name, Dependence)> {
        Vec::new()
    }

    /// The values of these unknowns, from the positions of the sites and the values that earlier equations define;
    /// `None` if other equations define them.
    fn scalars_at(&self, _at: &[Vector], _known: &[f64]) -> Option<Vec<f64>> {
        None
    }

    /// 1, or 3: one per axis.
    fn rows(&self) -> usize {
        1
    }

    /// How a row depends on a coordinate of one of the sites.
    fn dependence(&self, _row: usize, _site: usize, _axis: usize) -> Dependence {
        Dependence::Any
    }

    /// The constants with which the equations hold at these positions of the sites; `None` if there are none.
    fn constants(&self, at: &[Vector]) -> Option<Vector>;

    /// The residual, one entry per row, for the scalars and for sites at other positions than those of the constants.
    /// A driven value counts as zero.
    fn residual(&self, constants: &Vector, at: &[Vector], scalars: &[f64]) -> Vector;

    /// The two points whose distance it keeps.
    fn keeps(&self) -> Option<[&Site; 2]> {
        None
    }

    /// The point that it ties to a frame in closed form.
    fn carries(&self) -> Option<&Carried> {
        None
    }

    /// The drive that it prescribes.
    fn drive(&self) -> Option<&Name> {
        None
    }
}

/// How a row of the Jacobian depends on a coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dependence {
    /// Not at all.
    Never,
    /// The derivative is 1 in every position.
    Unit,
    /// The dependence is of any other kind.
    Any,
}

//! The generated code for the equations of each form. Only the register below
//! distinguishes the forms.

mod along;
mod bilinear;
mod carried;
mod distance;
mod ends;
mod linear;
mod product;
mod stretch;
mod turn;

use proc_macro2::TokenStream;

use suspension_listing::form::Form;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Site, SiteMotion, System};

use super::gradient::{By, Gradient};
use super::operations::Operations;

pub(super) use linear::{constant, sum};

/// The code for the equations of a form, by the name of the first.
pub(super) trait Emit {
    /// The type of the constant that the model has for them.
    fn constant(&self) -> Option<TokenStream> {
        None
    }

    /// Whether the constant is measured in the frame of a body.
    fn is_framed(&self) -> bool {
        false
    }

    /// Whether the constant has a length, which is of the order of the linkage's size.
    fn has_length(&self) -> bool {
        false
    }

    /// Sets its unknowns in `free` that are not coordinates, with each site at `place`; `None` if it has none.
    fn scalars(&self, _name: &Name, _place: &dyn Fn(&Site) -> TokenStream) -> Option<TokenStream> {
        None
    }

    /// The constant from the points `at`.
    fn constant_from_points(&self, name: &Name, system: &System) -> TokenStream;

    /// The constant from `lengths`.
    fn constant_from_lengths(&self, name: &Name, system: &System) -> TokenStream;

    /// The rows of `F`.
    fn residual(&self, name: &Name) -> TokenStream;

    /// The rows of the Jacobian.
    fn gradient(&self, name: &Name) -> Gradient<'_>;

    /// The rows of `C(v, w)`; `None` if they are zero.
    fn curvature(&self, name: &Name) -> Option<TokenStream>;

    /// The rows of `-dF/du udot` for the chassis points with the given motion and, if these are driven, for the
    /// drive; `None` if they are zero.
    fn input_rate(&self, name: &Name, motion: SiteMotion) -> Option<TokenStream>;

    /// The operations of residual, Jacobian and curvature, as `suspension_core::model::constraint` writes them.
    fn cost(&self) -> [Operations; 3];
}

/// The code for the form of an equation.
pub(super) fn emitter(equation: &Equation) -> &dyn Emit {
    match &equation.form {
        Form::Distance(form) => form,
        Form::Carried(form) => form,
        Form::Linear(form) => form,
        Form::Along(form) => form,
        Form::Stretch(form) => form,
        Form::Product(form) => form,
        Form::Bilinear(form) => form,
        Form::Turn(form) => form,
    }
}

/// Each equation with its gradient with respect to the unknowns, and the index of its first row.
pub(super) fn gradients(system: &System) -> impl Iterator<Item = (usize, &Equation, Gradient<'_>)> {
    system.equations.iter().scan(0, |next, equation| {
        let first = *next;
        *next += equation.form.equations().rows();
        let mut gradient = emitter(equation).gradient(&equation.named.name);
        gradient.by.retain(By::is_free);
        Some((first, equation, gradient))
    })
}

/// Sets the scalar unknowns in `free`, with each site at `place`.
pub(super) fn scalars(system: &System, place: &dyn Fn(&Site) -> TokenStream) -> Vec<TokenStream> {
    let equations = system.equations.iter();
    equations
        .filter_map(|equation| emitter(equation).scalars(&equation.named.name, place))
        .collect()
}

/// A constant of the model that belongs to equations.
pub(super) struct Constant<'a> {
    pub(super) name: &'a Name,
    pub(super) kind: TokenStream,
    pub(super) form: &'a dyn Emit,
}

/// The constants of equations: those measured in frames, or the others.
pub(super) fn constants(system: &System, framed: bool) -> impl Iterator<Item = Constant<'_>> {
    let forms = system
        .equations
        .iter()
        .map(|equation| (equation, emitter(equation)));
    let forms = forms.filter(move |(_, form)| form.is_framed() == framed);
    forms.filter_map(|(equation, form)| {
        Some(Constant {
            name: &equation.named.name,
            kind: form.constant()?,
            form,
        })
    })
}

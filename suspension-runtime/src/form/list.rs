//! The list of the forms, which [`walk`] goes through; add a new form here.

use suspension_listing::form::Form;
use suspension_listing::system::System;

use super::entering::Equations;
use super::place::Place;
use super::{Along, Bilinear, Body, Distance, Linear, Product, Scale, Stretch, Turn};
use crate::plan::lengths::LengthNames;

/// The equations of a listing by their forms.
#[derive(Clone, Debug, Default)]
pub(crate) struct Forms {
    pub(crate) distances: Equations<Distance>,
    /// All bodies of three points or more, each with the points that it carries.
    pub(crate) bodies: Equations<Body>,
    pub(crate) linear: Equations<Linear>,
    pub(crate) lines: Equations<Along<1>>,
    pub(crate) planes: Equations<Along<2>>,
    pub(crate) stretches: Equations<Stretch>,
    pub(crate) products: Equations<Product>,
    pub(crate) turns: Equations<Turn>,
    pub(crate) bilinear: Equations<Bilinear>,
    /// The lengths by which these are divided, each once.
    pub(crate) scales: Vec<Scale>,
}

/// Does something with each equation of some [`Forms`] and its constant in a model: with `all()`, or with those that
/// are [`entered(by_drives)`](Equations::entered). A form that does not have one constant per equation gets the table
/// of its constants.
macro_rules! walk {
    ($forms:expr, $which:ident($($by:expr)?), $model:expr, |$form:ident, $constant:ident| $each:expr) => {{
        use core::iter::repeat;
        let (forms, model) = ($forms, $model);
        for ($form, $constant) in forms.distances.$which(model.distances.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.bodies.$which(repeat(model.carried.as_slice()), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.linear.$which(repeat(model.held.as_slice()), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.lines.$which(model.lines.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.planes.$which(model.planes.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.stretches.$which(model.stretches.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.products.$which(model.products.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, $constant) in forms.turns.$which(model.turns.as_slice().iter(), $($by)?) {
            $each;
        }
        for ($form, scales) in forms.bilinear.$which(repeat(&model.scales), $($by)?) {
            let $constant = &scales.get($form.constant);
            $each;
        }
    }};
}
pub(crate) use walk;

impl Forms {
    /// Creates the forms. `entries` gives the place of each derivative, by its row and, for an unknown, its column.
    pub(crate) fn new(
        system: &System,
        lengths: &LengthNames<'_>,
        entries: &dyn Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let bodies = system.bodies.iter();
        let mut forms = Self {
            bodies: Vec::from_iter(bodies.map(|body| Body::new(body, lengths))).into(),
            ..Self::default()
        };
        let mut row = 0;
        for equation in &system.equations {
            let place = Place {
                system,
                lengths,
                entries,
                name: &equation.named.name,
                row,
            };
            forms.push(&equation.form, &place);
            row += equation.form.equations().rows();
        }
        let carried = forms.bodies.iter_mut().flat_map(|body| &mut body.carried);
        for (constant, carried) in (0..).zip(carried) {
            carried.constant = constant;
        }
        forms
    }

    fn push(&mut self, form: &Form, place: &Place<'_>) {
        let of_form = form.equations();
        match form {
            Form::Distance(form) => self.distances.push(Distance::new(form, place), of_form),
            Form::Carried(form) => {
                let mut bodies = place.system.bodies.iter();
                let named = bodies.position(|body| body.name == form.body);
                if let Some(named) = named
                    && let Some(body) = self.bodies.get_mut(named)
                {
                    body.carry(form, place);
                    self.bodies.enter(named, of_form);
                }
            }
            Form::Linear(form) => {
                let held = self.held().count();
                self.linear.push(Linear::new(form, place, held), of_form);
            }
            Form::Along(form) => {
                if let Some(line) = Along::new(form, place) {
                    self.lines.push(line, of_form);
                } else if let Some(plane) = Along::new(form, place) {
                    self.planes.push(plane, of_form);
                }
            }
            Form::Stretch(form) => self.stretches.push(Stretch::new(form, place), of_form),
            Form::Product(form) => self.products.push(Product::new(form, place), of_form),
            Form::Turn(form) => self.turns.push(Turn::new(form, place), of_form),
            Form::Bilinear(form) => {
                let scale = Scale::new(form, place);
                let known = self.scales.iter().position(|other| *other == scale);
                let constant = known.unwrap_or(self.scales.len());
                if known.is_none() {
                    self.scales.push(scale);
                }
                self.bilinear
                    .push(Bilinear::new(form, place, constant), of_form);
            }
        }
    }

    /// The sums of coordinates that stay as they are.
    pub(crate) fn held(&self) -> impl Iterator<Item = &Linear> {
        self.linear.iter().filter(|linear| linear.is_held())
    }

    /// The number of points that bodies carry.
    pub(crate) fn carried(&self) -> usize {
        self.bodies.iter().map(|body| body.carried.len()).sum()
    }
}

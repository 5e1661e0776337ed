//! `Linear`: a sum of coordinates, or a scalar, that a drive prescribes or that stays as it is.

use nalgebra::{SMatrix, Vector3};
use suspension_core::Scalar;
use suspension_listing::form;
use suspension_listing::system::System;

use crate::site::{Site, Sites};
use crate::table::{SPARE, Table, index};

/// A prescribed sum of unknowns: one row.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    pub(crate) row: u16,
    pub(crate) prescribed: Prescribed,
    pub(crate) terms: Vec<Term>,
    /// An unknown that is no coordinate, added to the terms.
    scalar: Option<u16>,
    /// Where the factors hold the derivative by each term's coordinate, and by the scalar.
    entries: Vec<u16>,
    by_scalar: u16,
}

/// What prescribes a sum.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Prescribed {
    Drive(u16),
    /// Its place among the sums that stay as they are.
    Design(u16),
}

/// A coordinate of a site, times a factor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Term {
    factor: f64,
    pub(crate) site: Site,
    axis: usize,
}

impl From<&form::Term> for Term {
    fn from(term: &form::Term) -> Self {
        Self {
            factor: term.factor,
            site: Site::from(&term.site),
            axis: term.axis,
        }
    }
}

impl Term {
    /// With the opposite sign.
    pub(crate) fn less(self) -> Self {
        Self {
            factor: -self.factor,
            ..self
        }
    }

    pub(crate) fn is_positive(&self) -> bool {
        self.factor > 0.0
    }

    /// The coordinate of a vector, times the factor.
    #[inline(always)]
    pub(crate) fn value<T: Scalar>(&self, vector: &Vector3<T>) -> T {
        let coordinate = match self.axis {
            0 => vector.x,
            1 => vector.y,
            _ => vector.z,
        };
        T::constant(self.factor) * coordinate
    }
}

impl Linear {
    /// `held` others before it stay as they are.
    pub(crate) fn new(
        system: &System,
        form: &form::Linear,
        row: usize,
        held: usize,
        entry: impl Fn(usize, Option<usize>) -> u16,
    ) -> Self {
        let terms: Vec<Term> = form.terms.iter().map(Term::from).collect();
        let columns = terms.iter().map(|term| term.site.column(term.axis));
        let scalar = form.scalar.as_ref();
        let scalar = scalar.and_then(|scalar| system.scalar_column(scalar));
        let prescribed = match &form.prescribed {
            form::Prescribed::Drive(name) => {
                let mut drives = system.drives.iter();
                let drive = drives.position(|drive| drive.named.name == *name);
                Prescribed::Drive(drive.map_or(SPARE, index))
            }
            form::Prescribed::Design => Prescribed::Design(index(held)),
        };
        Self {
            row: index(row),
            prescribed,
            entries: columns.map(|column| entry(row, column)).collect(),
            scalar: scalar.map(index),
            by_scalar: entry(row, scalar),
            terms,
        }
    }

    /// Whether it stays as it is.
    pub(crate) fn is_held(&self) -> bool {
        matches!(self.prescribed, Prescribed::Design(_))
    }

    /// The sum.
    #[inline(always)]
    pub(crate) fn sum<T: Scalar>(&self, sites: &Sites<'_, T, impl Table<Vector3<T>>>) -> Option<T> {
        let mut sum = None;
        for term in &self.terms {
            let value = term.value(&sites.get(term.site)?);
            sum = Some(sum.map_or(value, |sum| sum + value));
        }
        if let Some(scalar) = self.scalar {
            let value = sites.scalar(scalar)?;
            sum = Some(sum.map_or(value, |sum| sum + value));
        }
        sum
    }

    /// Writes the derivatives into the factors.
    #[inline(always)]
    pub(crate) fn write<T: Scalar>(&self, numbers: &mut impl Table<T>) {
        for (entry, term) in self.entries.iter().zip(&self.terms) {
            *numbers.place(*entry) = T::constant(term.factor);
        }
        if self.scalar.is_some() {
            *numbers.place(self.by_scalar) = T::one();
        }
    }

    /// Writes the derivatives into a dense matrix.
    pub(crate) fn write_dense<T: Scalar, const N: usize>(&self, matrix: &mut SMatrix<T, N, N>) {
        let terms = self.terms.iter();
        let terms = terms.map(|term| (term.site.column(term.axis), term.factor));
        let scalar = self.scalar.map(|scalar| (Some(usize::from(scalar)), 1.0));
        for (column, factor) in terms.chain(scalar) {
            let place = column.map(|column| (usize::from(self.row), column));
            if let Some(entry) = place.and_then(|place| matrix.get_mut(place)) {
                *entry = T::constant(factor);
            }
        }
    }
}

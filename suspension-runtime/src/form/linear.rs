//! `Linear`: a sum of coordinates, or a scalar, that a drive prescribes or that stays as it is.

use nalgebra::Vector3;
use suspension_core::Scalar;
use suspension_core::model::constraint::Held;
use suspension_listing::form;

use super::{Entries, Place, Walked};
use crate::site::{Inputs, Site, Sites};
use crate::table::{SPARE, Table, index, put, put_sum};

/// A prescribed sum of unknowns: one row.
#[derive(Clone, Debug)]
pub(crate) struct Linear {
    pub(crate) row: u16,
    pub(crate) prescribed: Prescribed,
    pub(crate) terms: Vec<Term>,
    /// An unknown that is not a coordinate, added to the terms.
    scalar: Option<u16>,
    /// The terms of chassis points with the opposite sign, which are added first.
    of_chassis: Vec<Term>,
    /// The places of the derivatives with respect to each term's coordinate, and to the scalar.
    entries: Vec<u16>,
    by_scalar: u16,
}

/// The source of the value of a sum.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Prescribed {
    /// A drive, times a factor.
    Drive(u16, f64),
    /// The design: its index among the sums that stay as they are.
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
    /// `held` is the number of sums before it that stay as they are.
    pub(super) fn new(form: &form::Linear, place: &Place<'_>, held: usize) -> Self {
        let terms: Vec<Term> = form.terms.iter().map(Term::from).collect();
        let columns = terms.iter().map(|term| term.site.column(term.axis));
        let scalar = form.scalar.as_ref();
        let scalar = scalar.and_then(|scalar| place.system.scalar_column(scalar));
        let prescribed = match &form.prescribed {
            form::Prescribed::Drive(name) => {
                let mut drives = place.system.drives.iter();
                let drive = drives.position(|drive| drive.named.name == *name);
                Prescribed::Drive(drive.map_or(SPARE, index), form.scale.recip())
            }
            form::Prescribed::Design => Prescribed::Design(index(held)),
        };
        let on_chassis = terms.iter().filter(|term| term.site.column(0).is_none());
        let opposite = on_chassis.map(|term| Term {
            factor: -term.factor,
            ..*term
        });
        let (mut of_chassis, less): (Vec<Term>, Vec<Term>) =
            opposite.partition(|term| term.factor > 0.0);
        of_chassis.extend(less);
        Self {
            row: index(place.row),
            prescribed,
            entries: columns.map(|column| place.entry(0, column)).collect(),
            scalar: scalar.map(index),
            by_scalar: place.entry(0, scalar),
            of_chassis,
            terms,
        }
    }

    /// Whether its sum stays as it is.
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
}

impl<T: Scalar, F: Table<Vector3<T>>> Walked<T, F> for Linear {
    type Constant = [Held<T>];

    #[inline(always)]
    fn residual(&self, held: &Self::Constant, at: &Sites<'_, T, F>, rows: &mut [T]) {
        let off = self.sum(at).and_then(|sum| match self.prescribed {
            Prescribed::Drive(drive, factor) => Some(sum - T::constant(factor) * at.drive(drive)?),
            Prescribed::Design(place) => Some(held.get(usize::from(place))?.residual(sum)),
        });
        if let Some(off) = off {
            put(rows, self.row, off);
        }
    }

    #[inline(always)]
    fn gradient(&self, _: &Self::Constant, _: &Sites<'_, T, F>, to: &mut impl Entries<T>) {
        for (entry, term) in self.entries.iter().zip(&self.terms) {
            to.put(*entry, T::constant(term.factor));
        }
        if self.scalar.is_some() {
            to.put(self.by_scalar, T::one());
        }
    }

    #[inline(always)]
    fn input_rate(&self, _: &Self::Constant, inputs: &Inputs<'_, T, F>, rows: &mut [T]) {
        let of_drive = match self.prescribed {
            Prescribed::Drive(drive, factor) => {
                let rate = inputs.drive_rate.get(usize::from(drive));
                rate.map(|rate| T::constant(factor) * *rate)
            }
            Prescribed::Design(_) => None,
        };
        let terms = self.of_chassis.iter();
        let terms = terms.filter_map(|term| Some(term.value(&inputs.rate(term.site)?)));
        put_sum(rows, self.row, of_drive.into_iter().chain(terms));
    }
}

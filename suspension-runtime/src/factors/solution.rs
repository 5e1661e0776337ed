//! Solutions with the factors, made in place.

use nalgebra::{ArrayStorage, SVector, Vector3};
use suspension_core::constraint::Frame;
use suspension_core::{Scalar, linkage};

use super::Factors;
use crate::plan::{Carrier, Term};
use crate::site::three;
use crate::size::{Room, Size};
use crate::table::Table;

/// A place for each unknown, where first the row of the step that finds it stands.
type Places<T, const N: usize> = <Room<N> as Size>::Unknowns<T>;

impl<T: Scalar, const N: usize> linkage::Factors<T, N> for Factors<'_, T, N>
where
    Room<N>: Size,
{
    fn solve(&self, right: &SVector<T, N>) -> SVector<T, N> {
        let elimination = &self.plan.elimination;
        let mut x = self.rows_in_place(right);
        let mut numbers = self.numbers.as_slice().iter();
        let mut terms = elimination.forward.terms.iter();
        for &[place, count] in &elimination.forward.rows {
            let mut sum = x.get(place);
            for (&from, number) in terms.by_ref().zip(&mut numbers).take(count.into()) {
                sum = sum.minus_product(*number, x.get(from));
            }
            *x.place(place) = sum;
        }
        let mut terms = elimination.backward.terms.iter();
        for &[place, count] in &elimination.backward.rows {
            let Some(inverse) = numbers.next() else {
                break;
            };
            let mut sum = x.get(place) * *inverse;
            for (&from, number) in terms.by_ref().zip(&mut numbers).take(count.into()) {
                sum = sum.minus_product(*number, x.get(from));
            }
            *x.place(place) = sum;
        }
        self.carried_unknowns(&mut x);
        vector(&x)
    }

    fn solve_transposed(&self, right: &SVector<T, N>) -> SVector<T, N> {
        let elimination = &self.plan.elimination;
        let [mut result] = right.data.0;
        let mut x = places::<T, N>(&result);
        for carrier in &elimination.carriers {
            self.carried_gradients(carrier, &mut x);
        }
        let solution = &elimination.transposed;
        self.subtract(&mut x, &solution.before);
        self.scale(&mut x, &solution.scaled);
        self.subtract(&mut x, &solution.behind);
        for (&row, value) in elimination.row_of.iter().zip(x.as_slice()) {
            if let Some(place) = result.get_mut(usize::from(row)) {
                *place = *value;
            }
        }
        SVector::from(result)
    }

    #[inline(always)]
    fn determinant_sign(&self) -> T {
        self.determinant_sign
    }

    #[inline(always)]
    fn growth_squared(&self) -> T {
        self.growth_squared
    }
}

impl<T: Scalar, const N: usize> Factors<'_, T, N>
where
    Room<N>: Size,
{
    /// The rows of a right-hand side. Those beyond the listing's are the unknowns there.
    #[inline(always)]
    fn rows_in_place(&self, right: &SVector<T, N>) -> Places<T, N> {
        let [right] = &right.data.0;
        let mut x = Places::<T, N>::default();
        for (place, &row) in x
            .as_mut_slice()
            .iter_mut()
            .zip(&self.plan.elimination.row_of)
        {
            *place = right.get(usize::from(row)).copied().unwrap_or_default();
        }
        x
    }

    fn subtract(&self, x: &mut Places<T, N>, terms: &[Term]) {
        for &Term { to, from, number } in terms {
            let left = x
                .get(to)
                .minus_product(self.numbers.get(number), x.get(from));
            *x.place(to) = left;
        }
    }

    fn scale(&self, x: &mut Places<T, N>, scaled: &[[u16; 2]]) {
        for &[place, number] in scaled {
            *x.place(place) *= self.numbers.get(number);
        }
    }

    /// A frame that carries points, but for its place.
    #[inline(always)]
    fn edges(&self, carrier: &Carrier) -> Frame<T> {
        let edge = |first| three(self.numbers.as_slice(), first).unwrap_or_default();
        Frame {
            origin: Vector3::default(),
            u: edge(carrier.edges),
            v: edge(carrier.edges + 3),
        }
    }

    /// The carried points' unknowns, once those of their frames are found.
    #[inline(always)]
    fn carried_unknowns(&self, x: &mut Places<T, N>) {
        for carrier in &self.plan.elimination.carriers {
            let frame = self.edges(carrier);
            let [a, b, c] = carrier
                .frame
                .map(|first| three(x.as_slice(), first).unwrap_or_default());
            let change = Frame::new(a, b, c);
            for point in &carrier.points {
                let carried = self.carried.get(point.constant).velocity(&frame, &change);
                for (column, carried) in (point.column..).zip(carried.iter()) {
                    let sum = x.get(column) + *carried;
                    *x.place(column) = sum;
                }
            }
        }
    }

    /// What the carried points' unknowns add to those of their frame in a transposed solution.
    fn carried_gradients(&self, carrier: &Carrier, x: &mut Places<T, N>) {
        let frame = self.edges(carrier);
        for point in &carrier.points {
            let gradient = three(x.as_slice(), point.column).unwrap_or_default();
            let by_frame = self.carried.get(point.constant).by_frame(gradient, &frame);
            for (&first, by_point) in carrier.frame.iter().zip(&by_frame) {
                let first = usize::from(first);
                if let Some(places) = x.as_mut_slice().get_mut(first..first + 3) {
                    for (place, value) in places.iter_mut().zip(by_point.iter()) {
                        *place += *value;
                    }
                }
            }
        }
    }
}

#[inline(always)]
fn places<T: Scalar, const N: usize>(values: &[T; N]) -> Places<T, N>
where
    Room<N>: Size,
{
    let mut x = Places::<T, N>::default();
    for (place, value) in x.as_mut_slice().iter_mut().zip(values) {
        *place = *value;
    }
    x
}

#[inline(always)]
fn vector<T: Scalar, const N: usize>(x: &impl Table<T>) -> SVector<T, N> {
    let mut values = [T::zero(); N];
    for (place, value) in values.iter_mut().zip(x.as_slice()) {
        *place = *value;
    }
    SVector::from_array_storage(ArrayStorage([values]))
}

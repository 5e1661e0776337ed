//! Back-substitution with the factors, in place.

use nalgebra::{SVector, Vector3};
use suspension_core::model::constraint::Frame;
use suspension_core::{Scalar, linkage};

use super::{Factors, take};
use crate::equations::rows;
use crate::plan::{Carrier, Term};
use crate::site::three;
use crate::size::{Room, Size};
use crate::table::{Table, put};

/// A place for each unknown, which at first holds the row of the step that finds it.
type Places<T, const N: usize> = <Room<N> as Size>::Unknowns<T>;

impl<T: Scalar, const N: usize> linkage::Factors<T, N> for Factors<'_, T, N>
where
    Room<N>: Size,
{
    #[inline(always)]
    fn solve(&self, right: &SVector<T, N>) -> SVector<T, N> {
        // Rows beyond those of the listing are themselves the unknowns.
        let mut solution = *right;
        self.solve_to(rows(&mut solution), right);
        solution
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
    /// Solves for the unknowns of the listing in place.
    #[inline(never)]
    fn solve_to(&self, solution: &mut [T; N], right: &SVector<T, N>) {
        let elimination = &self.plan.elimination;
        let mut x = Places::<T, N>::default();
        let mut numbers = self.numbers.as_slice();
        let mut terms = elimination.forward.terms.as_slice();
        for row in &elimination.forward.rows {
            let right = right.get(usize::from(row.row)).copied();
            let (terms, numbers) = (take(&mut terms, row.terms), take(&mut numbers, row.terms));
            *x.place(row.place) = less(right.unwrap_or_default(), terms, numbers, &x);
        }
        let mut terms = elimination.backward.terms.as_slice();
        for row in &elimination.backward.rows {
            let Some((inverse, ahead)) = numbers.split_first() else {
                break;
            };
            numbers = ahead;
            let (terms, numbers) = (take(&mut terms, row.terms), take(&mut numbers, row.terms));
            let unknown = less(x.get(row.place) * *inverse, terms, numbers, &x);
            *x.place(row.place) = unknown;
            put(solution, row.place, unknown);
        }
        self.carried_unknowns(solution, &x);
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

    /// A frame that carries points, without its position.
    #[inline(always)]
    fn edges(&self, carrier: &Carrier) -> Frame<T> {
        let edge = |first| three(self.numbers.as_slice(), first).unwrap_or_default();
        Frame {
            origin: Vector3::default(),
            u: edge(carrier.edges),
            v: edge(carrier.edges + 3),
        }
    }

    /// Computes the unknowns of carried points, once those of their frames are found.
    #[inline(always)]
    fn carried_unknowns(&self, solution: &mut [T; N], x: &Places<T, N>) {
        for carrier in &self.plan.elimination.carriers {
            let frame = self.edges(carrier);
            let [a, b, c] = carrier
                .frame
                .map(|first| three(x.as_slice(), first).unwrap_or_default());
            let change = Frame::new(a, b, c);
            for point in &carrier.points {
                let carried = self.carried.get(point.constant).velocity(&frame, &change);
                for (column, carried) in (point.column..).zip(carried.iter()) {
                    put(solution, column, x.get(column) + *carried);
                }
            }
        }
    }

    /// Adds the contributions of the carried points' unknowns to those of their frame in a transposed solution.
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

/// A number minus the terms of its row.
#[inline(always)]
fn less<T: Scalar>(from: T, terms: &[u16], numbers: &[T], x: &impl Table<T>) -> T {
    let terms = terms.iter().zip(numbers);
    terms.fold(from, |sum, (&place, number)| {
        sum.minus_product(*number, x.get(place))
    })
}

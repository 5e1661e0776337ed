//! Motions of two drives, for example travel and steer.

use crate::arithmetic::scalar::Real;
use crate::baked::{Outside, Split, add_product, polynomial};

/// The coefficients of a patch, indexed by power of the first drive, power of the second drive, and output.
pub type Patch<T, const OUT: usize, const TERMS: usize> = [[[T; OUT]; TERMS]; TERMS];

/// A piecewise polynomial of two drives with `OUT` outputs and `TERMS` coefficients in each
/// direction of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface<'a, T, const OUT: usize, const TERMS: usize> {
    /// Each drive's first and last value, in metres (or the unit of the hardpoints) or radians.
    pub ranges: [[T; 2]; 2],
    /// The numbers of patches in each direction, divided by the lengths of the ranges.
    pub patches_per_unit: [T; 2],
    /// The number of patches in the direction of the second drive.
    pub across: usize,
    /// The patches; patches along the second drive are adjacent. The variables of a patch run from 0 to 1.
    pub patches: &'a [Patch<T, OUT, TERMS>],
}

/// A place on a [`Surface`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePlace<'a, T, const OUT: usize, const TERMS: usize> {
    patch: &'a Patch<T, OUT, TERMS>,
    variables: [T; 2],
    patches_per_unit: [T; 2],
}

impl<'a, T: Split, const OUT: usize, const TERMS: usize> Surface<'a, T, OUT, TERMS> {
    /// The place where the drives have these values.
    ///
    /// # Errors
    ///
    /// [`Outside`] with the first drive that is outside its range.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn at(&self, drives: [T; 2]) -> Result<SurfacePlace<'a, T, OUT, TERMS>, Outside<T>> {
        let [first, second] = drives;
        let [first_range, second_range] = self.ranges;
        let outside = Outside::check(first, first_range).or(Outside::check(second, second_range));
        let [first_scale, second_scale] = self.patches_per_unit;
        let along = self.patches.len().checked_div(self.across).unwrap_or(0);
        let [row, column] = [along, self.across].map(|count| count.wrapping_sub(1));
        let ([first_start, _], [second_start, _]) = (first_range, second_range);
        let (row, u) = ((first - first_start) * first_scale).split(row);
        let (column, v) = ((second - second_start) * second_scale).split(column);
        let index = row
            .checked_mul(self.across)
            .and_then(|start| start.checked_add(column));
        match (index.and_then(|index| self.patches.get(index)), outside) {
            (Some(patch), None) => Ok(SurfacePlace {
                patch,
                variables: [u, v],
                patches_per_unit: self.patches_per_unit,
            }),
            (_, outside) => Err(outside.unwrap_or(Outside {
                drive: first,
                nearest: first,
            })),
        }
    }
}

impl<T: Real, const OUT: usize, const TERMS: usize> SurfacePlace<'_, T, OUT, TERMS> {
    /// The position.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn position(&self) -> [T; OUT] {
        let [[position]] = self.derivatives();
        position
    }

    /// Position and velocity when the drives move at `rates` per second.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn velocity(&self, rates: [T; 2]) -> [[T; OUT]; 2] {
        let [[position, by_first], [by_second, _]] = self.derivatives();
        let [first, second] = self.scaled(rates);
        let mut velocity = by_first.map(|slope| slope * first);
        add_product(&mut velocity, &by_second, second);
        [position, velocity]
    }

    /// Position, velocity and acceleration when the drives move at `rates` per second and `second_rates` per second
    /// squared.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn acceleration(&self, rates: [T; 2], second_rates: [T; 2]) -> [[T; OUT]; 3] {
        let [
            [position, by_first, half_by_first_twice],
            [by_second, by_both, _],
            [half_by_second_twice, _, _],
        ] = self.derivatives();
        let [first, second] = self.scaled(rates);
        let [first_second, second_second] = self.scaled(second_rates);
        let mut velocity = by_first.map(|slope| slope * first);
        add_product(&mut velocity, &by_second, second);
        let twice = T::one() + T::one();
        let mut acceleration = half_by_first_twice.map(|half| half * (twice * first * first));
        add_product(&mut acceleration, &by_both, twice * first * second);
        add_product(
            &mut acceleration,
            &half_by_second_twice,
            twice * second * second,
        );
        add_product(&mut acceleration, &by_first, first_second);
        add_product(&mut acceleration, &by_second, second_second);
        [position, velocity, acceleration]
    }

    fn scaled(&self, rates: [T; 2]) -> [T; 2] {
        let [first, second] = rates;
        let [first_scale, second_scale] = self.patches_per_unit;
        [first * first_scale, second * second_scale]
    }

    /// Derivatives indexed by order in the second variable, then in the first, each divided by the factorials of both
    /// orders.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn derivatives<const ORDERS: usize>(&self) -> [[[T; OUT]; ORDERS]; ORDERS] {
        let [u, v] = self.variables;
        let rows: [[[T; OUT]; ORDERS]; TERMS] = self.patch.map(|row| polynomial(&row, v));
        let mut order = 0;
        [(); ORDERS].map(|()| {
            let zero = [T::zero(); OUT];
            let terms = rows.map(|row| row.get(order).copied().unwrap_or(zero));
            order += 1;
            polynomial(&terms, u)
        })
    }
}

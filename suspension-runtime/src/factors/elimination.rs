//! The steps of the elimination.

use suspension_core::Scalar;

use super::{Factors, take};
use crate::plan::Step;
use crate::size::{Room, Size};
use crate::table::Table;

/// The remaining lists of the steps.
struct Ahead<'a> {
    uppers: &'a [u16],
    multipliers: &'a [u16],
    targets: &'a [u16],
}

impl<T: Scalar, const N: usize> Factors<'_, T, N>
where
    Room<N>: Size,
{
    /// Eliminates, and sets the growth and a number with the sign of the determinant, each in four chains side by
    /// side.
    #[inline(always)]
    pub(super) fn eliminate(&mut self) {
        let elimination = &self.plan.elimination;
        let mut ahead = Ahead {
            uppers: &elimination.uppers,
            multipliers: &elimination.multipliers,
            targets: &elimination.targets,
        };
        let mut squares = [T::zero(); 4];
        let mut products = [T::one(); 4];
        let mut chain = 0;
        for step in &elimination.steps {
            let inverse = ahead.step(step, &mut self.numbers);
            if step.unit {
                continue;
            }
            if let (Some(square), Some(product)) = (squares.get_mut(chain), products.get_mut(chain))
            {
                *square = square.plus_product(inverse, inverse);
                *product *= inverse;
            }
            chain = (chain + 1) % 4;
        }
        let [a, b, c, d] = squares;
        self.growth_squared = (a + b) + (c + d);
        let [a, b, c, d] = products;
        let product = (a * b) * (c * d);
        self.determinant_sign = if elimination.is_odd {
            -product
        } else {
            product
        };
    }
}

impl Ahead<'_> {
    /// Makes one step; returns the pivot's inverse.
    #[inline(always)]
    fn step<T: Scalar>(&mut self, step: &Step, numbers: &mut impl Table<T>) -> T {
        let inverse = T::one() / numbers.get(step.pivot);
        *numbers.place(step.pivot) = inverse;
        let uppers = take(&mut self.uppers, step.right);
        let multipliers = take(&mut self.multipliers, step.below);
        match step.right {
            0 => self.rows::<T, 0>(inverse, uppers, multipliers, numbers),
            1 => self.rows::<T, 1>(inverse, uppers, multipliers, numbers),
            2 => self.rows::<T, 2>(inverse, uppers, multipliers, numbers),
            3 => self.rows::<T, 3>(inverse, uppers, multipliers, numbers),
            4 => self.rows::<T, 4>(inverse, uppers, multipliers, numbers),
            5 => self.rows::<T, 5>(inverse, uppers, multipliers, numbers),
            6 => self.rows::<T, 6>(inverse, uppers, multipliers, numbers),
            7 => self.rows::<T, 7>(inverse, uppers, multipliers, numbers),
            8 => self.rows::<T, 8>(inverse, uppers, multipliers, numbers),
            _ => self.long_rows(inverse, uppers, multipliers, numbers),
        }
        inverse
    }

    /// Computes the multipliers and subtracts their products from each row below. There are `R` numbers right of the
    /// pivot, which stay in registers.
    #[inline(always)]
    fn rows<T: Scalar, const R: usize>(
        &mut self,
        inverse: T,
        uppers: &[u16],
        multipliers: &[u16],
        numbers: &mut impl Table<T>,
    ) {
        let Some(uppers) = uppers.first_chunk::<R>() else {
            return;
        };
        let right = uppers.map(|upper| numbers.get(upper));
        for &number in multipliers {
            let multiplier = numbers.get(number) * inverse;
            *numbers.place(number) = multiplier;
            let Some((targets, ahead)) = self.targets.split_first_chunk::<R>() else {
                return;
            };
            self.targets = ahead;
            for (&target, right) in targets.iter().zip(right) {
                let left = numbers.get(target).minus_product(multiplier, right);
                *numbers.place(target) = left;
            }
        }
        for (&upper, right) in uppers.iter().zip(right) {
            *numbers.place(upper) = right * inverse;
        }
    }

    /// The same with any count of numbers right of the pivot.
    #[inline(always)]
    fn long_rows<T: Scalar>(
        &mut self,
        inverse: T,
        uppers: &[u16],
        multipliers: &[u16],
        numbers: &mut impl Table<T>,
    ) {
        for &number in multipliers {
            let multiplier = numbers.get(number) * inverse;
            *numbers.place(number) = multiplier;
            let Some((targets, ahead)) = self.targets.split_at_checked(uppers.len()) else {
                return;
            };
            self.targets = ahead;
            for (&target, &upper) in targets.iter().zip(uppers) {
                let right = numbers.get(upper);
                let left = numbers.get(target).minus_product(multiplier, right);
                *numbers.place(target) = left;
            }
        }
        for &upper in uppers {
            let scaled = numbers.get(upper) * inverse;
            *numbers.place(upper) = scaled;
        }
    }
}

//! The factored Jacobian, walked: the arithmetic of what `linkage!` writes, in the same order.

use nalgebra::{SVector, Vector3};
use suspension_core::Scalar;
use suspension_core::constraint::{Carried, Frame};

use crate::model::{Few, Model};
use crate::plan::{Elimination, Plan, Reduction, Step, ZERO};
use crate::site::Sites;
use crate::size::{Room, Size};
use crate::table::Table;

/// The Jacobian eliminated in the order of the listing, `L D U`.
#[derive(Clone, Copy, Debug)]
pub struct Factors<'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    plan: &'l Plan,
    entries: <Room<N> as Size>::Entries<T>,
    carried: Few<Carried<T>, N>,
    growth_squared: T,
    determinant_sign: T,
}

impl<'l, T: Scalar, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    /// The factors of `J`, computed from its non-zero entries alone.
    #[inline(always)]
    #[inline(always)]
    pub fn factor(&self, q: &SVector<T, N>, fixed: &Few<Vector3<T>, N>) -> Factors<'l, T, N> {
        let mut factors = Factors {
            plan: &self.listing.plan,
            entries: Table::filled(T::zero()),
            carried: self.carried,
            growth_squared: T::zero(),
            determinant_sign: T::zero(),
        };
        factors.assemble(self, q, fixed);
        factors.reduce(q, fixed);
        factors.eliminate();
        factors
    }
}

impl<T: Scalar, const N: usize> Factors<'_, T, N>
where
    Room<N>: Size,
{
    /// Writes the entries of the Jacobian that are not always zero.
    #[inline(always)]
    fn assemble(&mut self, model: &Model<'_, T, N>, q: &SVector<T, N>, fixed: &Few<Vector3<T>, N>) {
        let plan = self.plan;
        let sites = Sites::new(q, fixed);
        let entries = &mut self.entries;
        // What fills in starts at a zero that a subtraction leaves no trace of, its sign included.
        for &place in &plan.elimination.filled {
            *entries.place(place) = -T::zero();
        }
        for (distance, constant) in plan.distances.iter().zip(&model.distances) {
            distance.write(constant, &sites, entries);
        }
        let mut constants = model.carried.as_slice().iter();
        for body in &plan.bodies {
            let Some(frame) = body.frame(&sites) else {
                continue;
            };
            for (point, constant) in body.carried.iter().zip(&mut constants) {
                point.write(constant, &frame, entries);
            }
        }
        for coordinate in &plan.coordinates {
            coordinate.write(entries);
        }
        *entries.place(ZERO) = T::zero();
    }

    /// Rows that depend on carried points depend on their frames instead.
    #[inline(always)]
    fn reduce(&mut self, q: &SVector<T, N>, fixed: &Few<Vector3<T>, N>) {
        let plan = self.plan;
        let sites = Sites::new(q, fixed);
        let mut reductions = plan.elimination.reductions.as_slice();
        for carrier in &plan.elimination.carriers {
            let body = plan.bodies.get(usize::from(carrier.body));
            let Some(frame) = body.and_then(|body| body.frame(&sites)) else {
                continue;
            };
            let edges = frame.u.iter().chain(&frame.v);
            for (place, edge) in (carrier.edges..).zip(edges) {
                *self.entries.place(place) = *edge;
            }
            for point in &carrier.points {
                let constant = self.carried.get(point.constant);
                for reduction in take(&mut reductions, point.reductions) {
                    reduce(reduction, &constant, &frame, &mut self.entries);
                }
            }
        }
    }

    #[inline(always)]
    fn eliminate(&mut self) {
        [self.growth_squared, self.determinant_sign] = eliminate(&self.plan.elimination, &mut self.entries);
    }
}

/// Makes a row depend on a frame in place of a point that it carries.
#[inline(always)]
fn reduce<T: Scalar>(
    reduction: &Reduction,
    constant: &Carried<T>,
    frame: &Frame<T>,
    entries: &mut impl Table<T>,
) {
    let [x, y, z] = reduction.gradient.map(|entry| entries.get(entry));
    let by_frame = constant.by_frame(Vector3::new(x, y, z), frame);
    let values = by_frame.iter().flat_map(|by_point| by_point.iter());
    for (&place, value) in reduction.sums.iter().zip(values) {
        let sum = entries.get(place) + *value;
        *entries.place(place) = sum;
    }
}

/// Eliminates; returns the growth squared and a number with the sign of the determinant.
#[inline(always)]
fn eliminate<T: Scalar>(elimination: &Elimination, entries: &mut impl Table<T>) -> [T; 2] {
    let mut multipliers = elimination.multipliers.as_slice();
    let mut uppers = elimination.uppers.as_slice();
    let mut targets = elimination.targets.as_slice();
    let mut squares = [T::zero(); 4];
    let mut products = [T::one(); 4];
    let mut inverted = 0;
    for step in &elimination.steps {
        let &Step {
            pivot,
            right,
            below,
            unit,
        } = step;
        let inverse = T::one() / entries.get(pivot);
        *entries.place(pivot) = inverse;
        if !unit {
            if let (Some(square), Some(product)) = (
                squares.get_mut(inverted % 4),
                products.get_mut(inverted % 4),
            ) {
                *square = square.plus_product(inverse, inverse);
                *product *= inverse;
            }
            inverted += 1;
        }
        let multipliers = take(&mut multipliers, below);
        let t = &mut targets;
        let upper = take(&mut uppers, right);
        match right {
            0 => rows::<T, 0>(upper, inverse, multipliers, t, entries),
            1 => rows::<T, 1>(upper, inverse, multipliers, t, entries),
            2 => rows::<T, 2>(upper, inverse, multipliers, t, entries),
            3 => rows::<T, 3>(upper, inverse, multipliers, t, entries),
            4 => rows::<T, 4>(upper, inverse, multipliers, t, entries),
            5 => rows::<T, 5>(upper, inverse, multipliers, t, entries),
            6 => rows::<T, 6>(upper, inverse, multipliers, t, entries),
            7 => rows::<T, 7>(upper, inverse, multipliers, t, entries),
            8 => rows::<T, 8>(upper, inverse, multipliers, t, entries),
            _ => many(upper, inverse, multipliers, t, entries),
        }
    }
    let [a, b, c, d] = products;
    let product = (a * b) * (c * d);
    let sign = if elimination.is_odd { -product } else { product };
    let [a, b, c, d] = squares;
    [(a + b) + (c + d), sign]
}

#[inline(always)]
fn many<T: Scalar>(
    upper: &[u16],
    inverse: T,
    multipliers: &[u16],
    targets: &mut &[u16],
    entries: &mut impl Table<T>,
) {
    for &place in multipliers {
        let multiplier = entries.get(place) * inverse;
        *entries.place(place) = multiplier;
        let count = u16::try_from(upper.len()).unwrap_or_default();
        for (&of_pivot, &target) in upper.iter().zip(take(targets, count)) {
            let left = entries.get(target).minus_product(multiplier, entries.get(of_pivot));
            *entries.place(target) = left;
        }
    }
    for &of_pivot in upper {
        let scaled = entries.get(of_pivot) * inverse;
        *entries.place(of_pivot) = scaled;
    }
}

#[inline(always)]
fn rows<T: Scalar, const R: usize>(
    upper: &[u16],
    inverse: T,
    multipliers: &[u16],
    targets: &mut &[u16],
    entries: &mut impl Table<T>,
) {
    let Some(upper) = upper.first_chunk::<R>() else {
        return;
    };
    let of_pivot = upper.map(|place| entries.get(place));
    for &place in multipliers {
        let multiplier = entries.get(place) * inverse;
        *entries.place(place) = multiplier;
        let Some((of_row, left)) = targets.split_first_chunk::<R>() else {
            return;
        };
        *targets = left;
        for (&target, of_pivot) in of_row.iter().zip(of_pivot) {
            let left = entries.get(target).minus_product(multiplier, of_pivot);
            *entries.place(target) = left;
        }
    }
    for (&place, of_pivot) in upper.iter().zip(of_pivot) {
        *entries.place(place) = of_pivot * inverse;
    }
}

/// The next few of a list.
#[inline(always)]
fn take<'a, V>(list: &mut &'a [V], count: u16) -> &'a [V] {
    let (taken, left) = list
        .split_at_checked(usize::from(count))
        .unwrap_or_default();
    *list = left;
    taken
}

impl<T: Scalar, const N: usize> Factors<'_, T, N>
where
    Room<N>: Size,
{
    /// See [`suspension_core::linkage::Factors`].
    pub fn growth_squared(&self) -> T {
        self.growth_squared
    }

    /// See [`suspension_core::linkage::Factors`].
    pub fn determinant_sign(&self) -> T {
        self.determinant_sign
    }

    /// Solves `J x = right`.
    #[inline(always)]
    pub fn solve(&self, right: &SVector<T, N>) -> SVector<T, N> {
        let elimination = &self.plan.elimination;
        let mut x = <Room<N> as Size>::Sites::filled(T::zero());
        let [right] = &right.data.0;
        for (place, value) in x.as_mut_slice().iter_mut().zip(right) {
            *place = *value;
        }
        // Each row stands where the unknown does that its step finds.
        for (place, &row) in x.as_mut_slice().iter_mut().zip(&elimination.row_of) {
            if let Some(value) = right.get(usize::from(row)) {
                *place = *value;
            }
        }
        let mut numbers = self.entries.as_slice().iter();
        let mut terms = elimination.forward.terms.iter();
        for row in &elimination.forward.rows {
            let mut sum = x.get(row.place);
            for (&from, number) in terms.by_ref().zip(&mut numbers).take(row.terms.into()) {
                sum = sum.minus_product(*number, x.get(from));
            }
            *x.place(row.place) = sum;
        }
        let mut terms = elimination.backward.terms.iter();
        for row in &elimination.backward.rows {
            let Some(inverse) = numbers.next() else {
                break;
            };
            let mut sum = x.get(row.place) * *inverse;
            for (&from, number) in terms.by_ref().zip(&mut numbers).take(row.terms.into()) {
                sum = sum.minus_product(*number, x.get(from));
            }
            *x.place(row.place) = sum;
        }
        self.carried_unknowns(elimination, &mut x);
        let mut values = x.as_slice().iter();
        SVector::from_array_storage(nalgebra::ArrayStorage([[(); N].map(|()| *values.next().unwrap_or(&right[0]))]))
    }

    /// The carried points' unknowns, once those of their frames are found.
    #[inline(always)]
    fn carried_unknowns(&self, elimination: &Elimination, x: &mut <Room<N> as Size>::Sites<T>) {
        for carrier in &elimination.carriers {
            let [u, v] = [carrier.edges, carrier.edges + 3].map(|first| three(&self.entries, first));
            let [origin, second, third] = carrier.frame.map(|first| three(x, first));
            let (frame, change) = (Frame { origin, u, v }, Frame::new(origin, second, third));
            for point in &carrier.points {
                let constant = self.carried.get(point.constant);
                let carried = constant.velocity(&frame, &change);
                for (column, carried) in (point.column..).zip(carried.iter()) {
                    let sum = x.get(column) + *carried;
                    *x.place(column) = sum;
                }
            }
        }
    }
}

#[inline(always)]
fn three<T: Scalar>(x: &impl Table<T>, first: u16) -> Vector3<T> {
    let first = usize::from(first);
    match x.as_slice().get(first..first + 3) {
        Some(&[x, y, z]) => Vector3::new(x, y, z),
        _ => Vector3::new(T::zero(), T::zero(), T::zero()),
    }
}

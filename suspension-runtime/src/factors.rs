//! The factored Jacobian, walked: the arithmetic of what `linkage!` writes, in the same order.

mod elimination;
mod solution;

use nalgebra::{SVector, Vector3};
use suspension_core::Scalar;
use suspension_core::model::constraint::Carried;

use crate::form::{Walked, walk};
use crate::model::Model;
use crate::plan::{Plan, ZERO};
use crate::site::Sites;
use crate::size::{Chassis, Few, Room, Size};
use crate::table::Table;

/// The Jacobian, factored as `L D U` in the order of the listing.
#[derive(Clone, Copy, Debug)]
pub struct Factors<'l, T: Scalar, const N: usize>
where
    Room<N>: Size,
{
    plan: &'l Plan,
    /// The multipliers left of each pivot; the pivot's inverse and the entries right of it, divided by the pivot; the
    /// edges of frames.
    numbers: <Room<N> as Size>::Numbers<T>,
    carried: Few<Carried<T>, N>,
    growth_squared: T,
    determinant_sign: T,
}

impl<'l, T: Scalar, const N: usize> Model<'l, T, N>
where
    Room<N>: Size,
{
    /// The assembled and eliminated factors.
    #[inline(always)]
    pub(crate) fn factor(&self, q: &SVector<T, N>, fixed: &Chassis<T, N>) -> Factors<'l, T, N> {
        let mut factors = Factors {
            plan: self.plan(),
            numbers: Default::default(),
            carried: self.carried,
            growth_squared: T::zero(),
            determinant_sign: T::zero(),
        };
        factors.fill(self, q, fixed);
        factors
    }
}

impl<T: Scalar, const N: usize> Factors<'_, T, N>
where
    Room<N>: Size,
{
    /// Assembles and eliminates in place, because factors that a call returns are copied. It is not inlined,
    /// otherwise its 15 kB would be in every caller, for each size.
    #[inline(never)]
    fn fill(&mut self, model: &Model<'_, T, N>, q: &SVector<T, N>, fixed: &Chassis<T, N>) {
        self.assemble(model, q, fixed);
        self.reduce(q, fixed);
        self.eliminate();
    }

    /// Writes the entries of the Jacobian that are not always zero.
    #[inline(always)]
    fn assemble(&mut self, model: &Model<'_, T, N>, q: &SVector<T, N>, fixed: &Chassis<T, N>) {
        let (plan, numbers) = (self.plan, &mut self.numbers);
        let sites = Sites::new(q.as_slice(), fixed);
        // Fill-in starts at a zero that leaves no trace in a difference, not even in its sign.
        for &number in &plan.elimination.filled {
            *numbers.place(number) = -T::zero();
        }
        walk!(&plan.forms, all(), model, |form, constant| {
            form.gradient(constant, &sites, numbers)
        });
        *numbers.place(ZERO) = T::zero();
    }

    /// Makes rows that depend on carried points depend on their frames instead.
    #[inline(always)]
    fn reduce(&mut self, q: &SVector<T, N>, fixed: &Chassis<T, N>) {
        let (plan, numbers) = (self.plan, &mut self.numbers);
        let sites = Sites::new(q.as_slice(), fixed);
        for carrier in &plan.elimination.carriers {
            let body = plan.forms.bodies.get(usize::from(carrier.body));
            let Some(frame) = body.and_then(|body| body.frame(&sites)) else {
                continue;
            };
            let edges = frame.u.iter().chain(&frame.v);
            for (number, edge) in (carrier.edges..).zip(edges) {
                *numbers.place(number) = *edge;
            }
            for point in &carrier.points {
                let constant = self.carried.get(point.constant);
                for reduction in &point.reductions {
                    let [x, y, z] = reduction.gradient.map(|number| numbers.get(number));
                    let by_frame = constant.by_frame(Vector3::new(x, y, z), &frame);
                    let values = by_frame.iter().flat_map(|by_point| by_point.iter());
                    for (&number, value) in reduction.sums.iter().zip(values) {
                        let sum = numbers.get(number) + *value;
                        *numbers.place(number) = sum;
                    }
                }
            }
        }
    }
}

/// The next `count` entries of a list.
#[inline(always)]
fn take<'a, V>(list: &mut &'a [V], count: u16) -> &'a [V] {
    let (taken, left) = list.split_at_checked(count.into()).unwrap_or_default();
    *list = left;
    taken
}

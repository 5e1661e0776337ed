//! What the inputs' rates contribute to velocity and acceleration, walked: `-dF/du udot`.

use nalgebra::{SVector, Vector3};
use suspension_core::Scalar;
use suspension_core::generated::dot;

use crate::equations::{put, put_three};
use crate::form::InputRates;
use crate::model::Model;
use crate::site::Sites;
use crate::size::{Few, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// Of some inputs, in rows that are zeros: `drive_rate` is that of a drive, for inputs that have drives.
    #[inline(never)]
    pub(crate) fn input_rates_to(
        &self,
        rows: &mut [T; N],
        inputs: &InputRates,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        fixed_rate: &Few<Vector3<T>, N>,
        drive_rate: impl Fn(u16) -> T,
    ) {
        let plan = self.plan();
        let (sites, rates) = (Sites::new(q, fixed), Sites::new(q, fixed_rate));
        for &index in &inputs.distances {
            let index = usize::from(index);
            let form = plan.distances.get(index).zip(self.distances.get(index));
            if let Some((distance, constant)) = form
                && let Some(vector) = distance.span.vector(&sites)
                && let Some(rate) = rates.get(distance.span.from)
            {
                put(
                    rows,
                    distance.span.row,
                    dot(constant.gradient(vector), rate),
                );
            }
        }
        for &index in &inputs.stretches {
            let index = usize::from(index);
            let constant = self.stretches.as_slice().get(index);
            if let Some((stretch, constant)) = plan.stretches.get(index).zip(constant)
                && let Some(vector) = stretch.span.vector(&sites)
                && let Some(rate) = rates.get(stretch.span.from)
            {
                put(rows, stretch.span.row, dot(constant.gradient(vector), rate));
            }
        }
        for moved in &inputs.carried {
            let Some(body) = plan.bodies.get(usize::from(moved.body)) else {
                continue;
            };
            let carried = body.carried.get(usize::from(moved.point));
            if let Some((carried, frame)) = carried.zip(body.frame(&sites)) {
                let gradient = self.carried.get(moved.constant).gradient(&frame);
                let blocks = [gradient.origin, gradient.second, gradient.third];
                let sites = blocks.into_iter().zip(moved.moved);
                let mut terms = sites.filter_map(|(block, site)| Some((block, rates.get(site?)?)));
                let first = terms.next().map(|(block, rate)| -block * rate);
                let less = |sum, (block, rate)| sum - block * rate;
                if let Some(first) = first {
                    put_three(rows, carried.row, terms.fold(first, less));
                }
            }
        }
        for moved in &inputs.lines {
            let index = usize::from(moved.form);
            let form = plan.lines.get(index).zip(self.lines.as_slice().get(index));
            if let Some((line, constant)) = form
                && let Some(sum) = line.input_rate(constant, moved, &sites, &rates)
            {
                put_three(rows, line.row, sum);
            }
        }
        for moved in &inputs.planes {
            let index = usize::from(moved.form);
            let form = plan
                .planes
                .get(index)
                .zip(self.planes.as_slice().get(index));
            if let Some((plane, constant)) = form
                && let Some(sum) = plane.input_rate(constant, moved, &sites, &rates)
            {
                put_three(rows, plane.row, sum);
            }
        }
        for &(index, moved) in &inputs.products {
            let index = usize::from(index);
            let constant = self.products.as_slice().get(index);
            if let Some((product, constant)) = plan.products.get(index).zip(constant)
                && let Some(sum) = product.input_rate(constant, moved, &sites, &rates)
            {
                put(rows, product.row, sum);
            }
        }
        for &(index, motion) in &inputs.bilinear {
            if let Some(bilinear) = plan.bilinear.get(usize::from(index))
                && let constant = self.scales.get(bilinear.constant)
                && let Some(sum) = bilinear.input_rate(&constant, motion, &sites, &rates)
            {
                put(rows, bilinear.row, sum);
            }
        }
        for linear in &inputs.linear {
            let of_drive = linear.drive.map(&drive_rate);
            let terms = linear.terms.iter();
            let terms = terms.filter_map(|term| Some(term.value(&rates.get(term.site)?)));
            let sum = of_drive
                .into_iter()
                .chain(terms)
                .reduce(|sum, term| sum + term);
            if let Some(sum) = sum {
                put(rows, linear.row, sum);
            }
        }
    }
}

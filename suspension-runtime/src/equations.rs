//! The equations and their derivatives, walked.

use nalgebra::{ArrayStorage, SMatrix, SVector, Vector3};
use suspension_core::Scalar;

use crate::form::Prescribed;
use crate::model::Model;
use crate::site::Sites;
use crate::size::{Few, Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// In place, as every vector of unknowns here: what a call returns is copied.
    #[inline(never)]
    pub(crate) fn residual_to(
        &self,
        rows: &mut [T; N],
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        drives: &Few<T, N>,
    ) {
        let plan = self.plan();
        let sites = Sites::new(q, fixed);
        // Rows beyond those of the listing hold their unknown at zero.
        *rows = q.data.0[0];
        for (distance, constant) in plan.distances.iter().zip(&self.distances) {
            if let Some(vector) = distance.span.vector(&sites) {
                put(rows, distance.span.row, constant.residual(vector));
            }
        }
        let mut constants = self.carried.as_slice().iter();
        for body in &plan.bodies {
            let Some(frame) = body.frame(&sites) else {
                continue;
            };
            for (carried, constant) in body.carried.iter().zip(&mut constants) {
                if let Some(point) = sites.get(carried.point) {
                    put_three(rows, carried.row, constant.residual(point, &frame));
                }
            }
        }
        for linear in &plan.linear {
            if let Some(sum) = linear.sum(&sites) {
                let off = match linear.prescribed {
                    Prescribed::Drive(drive) => sum - drives.get(drive),
                    Prescribed::Design(held) => self.held.get(held).residual(sum),
                };
                put(rows, linear.row, off);
            }
        }
        for (line, constant) in plan.lines.iter().zip(self.lines.as_slice()) {
            if let Some(off) = line.residual(constant, &sites) {
                put_three(rows, line.row, off);
            }
        }
        for (plane, constant) in plan.planes.iter().zip(self.planes.as_slice()) {
            if let Some(off) = plane.residual(constant, &sites) {
                put_three(rows, plane.row, off);
            }
        }
        for (stretch, constant) in plan.stretches.iter().zip(self.stretches.as_slice()) {
            if let Some((vector, length)) = stretch.change(&sites) {
                put(rows, stretch.span.row, constant.residual(vector, length));
            }
        }
        for (product, constant) in plan.products.iter().zip(self.products.as_slice()) {
            if let Some([d, e]) = product.vectors(&sites) {
                put(rows, product.row, constant.residual(d, e));
            }
        }
        for (turn, constant) in plan.turns.iter().zip(self.turns.as_slice()) {
            if let Some([sine, cosine]) = turn.parts(&sites) {
                put(rows, turn.row, constant.residual(sine, cosine));
            }
        }
        for bilinear in &plan.bilinear {
            let constant = self.scales.get(bilinear.constant);
            put(rows, bilinear.row, bilinear.residual(&constant, &sites));
        }
    }

    pub(crate) fn jacobian_at(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
    ) -> SMatrix<T, N, N> {
        let plan = self.plan();
        let sites = Sites::new(q, fixed);
        let mut matrix = SMatrix::from_array_storage(ArrayStorage([[T::zero(); N]; N]));
        for (distance, constant) in plan.distances.iter().zip(&self.distances) {
            distance.write_dense(constant, &sites, &mut matrix);
        }
        let mut constants = self.carried.as_slice().iter();
        for body in &plan.bodies {
            let Some(frame) = body.frame(&sites) else {
                continue;
            };
            for (carried, constant) in body.carried.iter().zip(&mut constants) {
                carried.write_dense(constant, body.frame, &frame, &mut matrix);
            }
        }
        for linear in &plan.linear {
            linear.write_dense(&mut matrix);
        }
        for (line, constant) in plan.lines.iter().zip(self.lines.as_slice()) {
            line.write_dense(constant, &sites, &mut matrix);
        }
        for (plane, constant) in plan.planes.iter().zip(self.planes.as_slice()) {
            plane.write_dense(constant, &sites, &mut matrix);
        }
        for (stretch, constant) in plan.stretches.iter().zip(self.stretches.as_slice()) {
            stretch.write_dense(constant, &sites, &mut matrix);
        }
        for (product, constant) in plan.products.iter().zip(self.products.as_slice()) {
            product.write_dense(constant, &sites, &mut matrix);
        }
        for (turn, constant) in plan.turns.iter().zip(self.turns.as_slice()) {
            turn.write_dense(constant, &sites, &mut matrix);
        }
        for bilinear in &plan.bilinear {
            bilinear.write_dense(&self.scales.get(bilinear.constant), &sites, &mut matrix);
        }
        for beyond in usize::from(plan.unknowns)..N {
            if let Some(entry) = matrix.get_mut((beyond, beyond)) {
                *entry = T::one();
            }
        }
        matrix
    }

    /// In rows that are [`zeros`].
    #[inline(never)]
    pub(crate) fn curvature_to(
        &self,
        rows: &mut [T; N],
        v: &SVector<T, N>,
        v_fixed: &Few<Vector3<T>, N>,
        w: &SVector<T, N>,
        w_fixed: &Few<Vector3<T>, N>,
    ) {
        let plan = self.plan();
        let (v, w) = (Sites::new(v, v_fixed), Sites::new(w, w_fixed));
        for (distance, constant) in plan.distances.iter().zip(&self.distances) {
            if let (Some(v), Some(w)) = (distance.span.vector(&v), distance.span.vector(&w)) {
                put(rows, distance.span.row, constant.curvature(v, w));
            }
        }
        let mut constants = self.carried.as_slice().iter();
        for body in &plan.bodies {
            let (Some(frame_v), Some(frame_w)) = (body.frame(&v), body.frame(&w)) else {
                continue;
            };
            for (carried, constant) in body.carried.iter().zip(&mut constants) {
                put_three(rows, carried.row, constant.curvature(&frame_v, &frame_w));
            }
        }
        for (line, constant) in plan.lines.iter().zip(self.lines.as_slice()) {
            if let (Some(v), Some(w)) = (line.change(&v), line.change(&w)) {
                put_three(rows, line.row, constant.curvature(v, w));
            }
        }
        for (plane, constant) in plan.planes.iter().zip(self.planes.as_slice()) {
            if let (Some(v), Some(w)) = (plane.change(&v), plane.change(&w)) {
                put_three(rows, plane.row, constant.curvature(v, w));
            }
        }
        for (stretch, constant) in plan.stretches.iter().zip(self.stretches.as_slice()) {
            if let (Some(v), Some(w)) = (stretch.change(&v), stretch.change(&w)) {
                put(rows, stretch.span.row, constant.curvature(v, w));
            }
        }
        for (product, constant) in plan.products.iter().zip(self.products.as_slice()) {
            if let (Some(v), Some(w)) = (product.vectors(&v), product.vectors(&w)) {
                put(rows, product.row, constant.curvature(v, w));
            }
        }
        for (turn, constant) in plan.turns.iter().zip(self.turns.as_slice()) {
            if let (Some(v), Some(w)) = (turn.parts(&v), turn.parts(&w)) {
                put(rows, turn.row, constant.curvature(v, w));
            }
        }
        for bilinear in &plan.bilinear {
            let constant = self.scales.get(bilinear.constant);
            put(rows, bilinear.row, bilinear.curvature(&constant, &v, &w));
        }
    }
}

/// Rows that nothing contributes to: zeros that an addition leaves no trace of, their sign included.
#[inline(always)]
pub(crate) fn zeros<T: Scalar, const N: usize>() -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([[-T::zero(); N]]))
}

/// The entries of a vector of unknowns or rows.
#[inline(always)]
pub(crate) fn rows<T, const N: usize>(vector: &mut SVector<T, N>) -> &mut [T; N] {
    let [rows] = &mut vector.data.0;
    rows
}

#[inline(always)]
pub(crate) fn put<T, const N: usize>(rows: &mut [T; N], row: u16, value: T) {
    if let Some(place) = rows.get_mut(usize::from(row)) {
        *place = value;
    }
}

#[inline(always)]
pub(crate) fn put_three<T: Scalar, const N: usize>(
    rows: &mut [T; N],
    first: u16,
    value: Vector3<T>,
) {
    let first = usize::from(first);
    if let Some([x, y, z]) = rows.get_mut(first..first + 3) {
        (*x, *y, *z) = (value.x, value.y, value.z);
    }
}

//! The equations and their derivatives, walked.

use nalgebra::{ArrayStorage, SMatrix, SVector, Vector3};
use suspension_core::Scalar;
use suspension_core::generated::dot;

use crate::form::Moving;
use crate::model::{Few, Model};
use crate::site::Sites;
use crate::size::{Room, Size};
use crate::table::Table;

impl<T: Scalar, const N: usize> Model<'_, T, N>
where
    Room<N>: Size,
{
    /// `F(q)`, in units of length.
    #[inline(always)]
    pub fn residual(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        drives: &Few<T, N>,
    ) -> SVector<T, N> {
        let plan = &self.listing.plan;
        let sites = Sites::new(q, fixed);
        // Rows beyond those of the listing hold their unknown at zero.
        let mut result = *q;
        let [rows] = &mut result.data.0;
        for (distance, constant) in plan.distances.iter().zip(&self.distances) {
            let Some(vector) = distance.vector(&sites) else {
                continue;
            };
            put(rows, distance.row, constant.residual(vector));
        }
        let mut constants = self.carried.as_slice().iter();
        for body in &plan.bodies {
            let Some(frame) = body.frame(&sites) else {
                continue;
            };
            for (point, constant) in body.carried.iter().zip(&mut constants) {
                if let Some(at) = sites.get(point.point) {
                    put_three(rows, point.row, constant.residual(at, &frame));
                }
            }
        }
        for coordinate in &plan.coordinates {
            let drive = drives.get(coordinate.drive);
            if let Some(off) = coordinate.residual(&sites, drive) {
                put(rows, coordinate.row, off);
            }
        }
        result
    }

    /// `J = dF/dq`, rows are equations.
    pub fn jacobian(&self, q: &SVector<T, N>, fixed: &Few<Vector3<T>, N>) -> SMatrix<T, N, N> {
        let plan = &self.listing.plan;
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
            for (point, constant) in body.carried.iter().zip(&mut constants) {
                point.write_dense(constant, &frame, &mut matrix);
            }
        }
        for coordinate in &plan.coordinates {
            coordinate.write_dense(&mut matrix);
        }
        for beyond in usize::from(plan.unknowns)..N {
            if let Some(entry) = matrix.get_mut((beyond, beyond)) {
                *entry = T::one();
            }
        }
        matrix
    }

    /// `C(v, w)`: the constant second derivative of `F` applied to two rates of all points.
    #[inline(always)]
    pub fn curvature(
        &self,
        v: &SVector<T, N>,
        v_fixed: &Few<Vector3<T>, N>,
        w: &SVector<T, N>,
        w_fixed: &Few<Vector3<T>, N>,
    ) -> SVector<T, N> {
        let plan = &self.listing.plan;
        let (v, w) = (Sites::new(v, v_fixed), Sites::new(w, w_fixed));
        let mut result = zeros();
        let [rows] = &mut result.data.0;
        for (distance, constant) in plan.distances.iter().zip(&self.distances) {
            let (Some(v), Some(w)) = (distance.vector(&v), distance.vector(&w)) else {
                continue;
            };
            put(rows, distance.row, constant.curvature(v, w));
        }
        let mut constants = self.carried.as_slice().iter();
        for body in &plan.bodies {
            let (Some(v), Some(w)) = (body.frame(&v), body.frame(&w)) else {
                continue;
            };
            for (point, constant) in body.carried.iter().zip(&mut constants) {
                put_three(rows, point.row, constant.curvature(&v, &w));
            }
        }
        result
    }

    /// `-dF/du udot` of the drives, driven chassis points included.
    #[inline(always)]
    pub fn drive_rate(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        fixed_rate: &Few<Vector3<T>, N>,
        drive_rate: &Few<T, N>,
    ) -> SVector<T, N> {
        let moving = &self.listing.plan.driven;
        self.rates(q, fixed, fixed_rate, moving, |drive| Some(drive_rate.get(drive)))
    }

    /// `-dF/du udot` of the chassis points that no drive moves.
    pub fn chassis_rate(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        fixed_rate: &Few<Vector3<T>, N>,
    ) -> SVector<T, N> {
        let moving = &self.listing.plan.undriven;
        self.rates(q, fixed, fixed_rate, moving, |_| None)
    }

    #[inline(always)]
    fn rates(
        &self,
        q: &SVector<T, N>,
        fixed: &Few<Vector3<T>, N>,
        fixed_rate: &Few<Vector3<T>, N>,
        moving: &Moving,
        drive_rate: impl Fn(u16) -> Option<T>,
    ) -> SVector<T, N> {
        let plan = &self.listing.plan;
        let sites = Sites::new(q, fixed);
        let rates = Sites::new(q, fixed_rate);
        let rate = |site: u16| rates.chassis(site);
        let mut result = zeros();
        let [rows] = &mut result.data.0;
        for &index in &moving.distances {
            let index = usize::from(index);
            if let (Some(distance), Some(constant)) = (plan.distances.get(index), self.distances.get(index)) {
                if let Some(vector) = distance.vector(&sites) {
                    let term = dot(constant.gradient(vector), rate(distance.from));
                    put(rows, distance.row, term);
                }
            }
        }
        for (index, moved) in &moving.bodies {
            self.rates_of_body(*index, *moved, &sites, &rate, rows);
        }
        for (coordinate, moves) in plan.coordinates.iter().zip(&moving.coordinates) {
            let drive = drive_rate(coordinate.drive);
            if drive.is_some() || moves.contains(&true) {
                let term = coordinate.rate(drive, *moves, &rate);
                put(rows, coordinate.row, term);
            }
        }
        result
    }

    fn rates_of_body(
        &self,
        index: u16,
        moved: [bool; 3],
        sites: &Sites<'_, T, Few<Vector3<T>, N>>,
        rate: &impl Fn(u16) -> Vector3<T>,
        rows: &mut [T; N],
    ) {
        let bodies = &self.listing.plan.bodies;
        let (before, body) = match bodies.split_at_checked(usize::from(index)) {
            Some((before, [body, ..])) => (before, body),
            _ => return,
        };
        let first = before.iter().map(|body| body.carried.len()).sum();
        let constants = self.carried.as_slice().iter().skip(first);
        let Some(frame) = body.frame(sites) else {
            return;
        };
        for (point, constant) in body.carried.iter().zip(constants) {
            let gradient = constant.gradient(&frame);
            let blocks = [gradient.origin, gradient.second, gradient.third];
            let mut moved = blocks.iter().zip(body.frame).zip(moved).filter(|(_, moved)| *moved);
            let first = moved.next().map(|((block, site), _)| -*block * rate(site));
            let term = moved.fold(first, |sum, ((block, site), _)| {
                sum.map(|sum| sum - *block * rate(site))
            });
            if let Some(term) = term {
                put_three(rows, point.row, term);
            }
        }
    }
}

/// Rows that nothing contributes to: zeros that an addition leaves no trace of, their sign included.
#[inline(always)]
fn zeros<T: Scalar, const N: usize>() -> SVector<T, N> {
    SVector::from_array_storage(ArrayStorage([[-T::zero(); N]]))
}

#[inline(always)]
fn put<T, const N: usize>(rows: &mut [T; N], row: u16, value: T) {
    if let Some(place) = rows.get_mut(usize::from(row)) {
        *place = value;
    }
}

#[inline(always)]
fn put_three<T: Scalar, const N: usize>(rows: &mut [T; N], first: u16, value: Vector3<T>) {
    let first = usize::from(first);
    if let Some([x, y, z]) = rows.get_mut(first..first + 3) {
        (*x, *y, *z) = (value.x, value.y, value.z);
    }
}

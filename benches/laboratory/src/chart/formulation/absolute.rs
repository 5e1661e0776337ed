//! Absolute coordinates: position and Euler parameters of the knuckle.

use nalgebra::{SMatrix, SVector, Vector3, Vector4};
use suspension_core::model::constraint::angle_to_coordinate;
use suspension_core::{Real, Signal, Values};

use super::five_links::{FiveLinks, in_a_row};
use super::{Formulation, State};

/// Seven unknowns: the first knuckle end `r` and the Euler parameters `e`, scalar first, of the
/// turn since the motion began. Rows: five lengths, `(|d|^2 - L^2) / (2 L)`; the height of the
/// first knuckle end; the norm of `e`.
#[derive(Clone, Copy, Debug)]
pub struct Absolute<T>(pub FiveLinks<T>);

const HEIGHT: usize = 5;
const NORM: usize = 6;

fn parts<T: Real>(x: &SVector<T, 7>) -> (Vector3<T>, Vector4<T>) {
    (x.fixed_rows::<3>(0).into(), x.fixed_rows::<4>(3).into())
}

fn split<T: Real>(e: &Vector4<T>) -> (T, Vector3<T>) {
    (e.x, Vector3::new(e.y, e.z, e.w))
}

/// The symmetric bilinear form of which `turned(e, e, s)` is the vector `s` turned by `e`.
fn turned<T: Real>(e: &Vector4<T>, f: &Vector4<T>, s: &Vector3<T>) -> Vector3<T> {
    let ((a, v), (b, w)) = (split(e), split(f));
    s * (a * b - v.dot(&w)) + v * w.dot(s) + w * v.dot(s) + w.cross(s) * a + v.cross(s) * b
}

/// The gradient of `d . turned(e, e, s)` with respect to `e`.
fn gradient_of_turned<T: Real>(e: &Vector4<T>, s: &Vector3<T>, d: &Vector3<T>) -> Vector4<T> {
    let (a, v) = split(e);
    let scalar = d.dot(&(s * a + v.cross(s)));
    let vector = d * v.dot(s) + s * d.dot(&v) - v * s.dot(d) + s.cross(d) * a;
    Vector4::new(scalar, vector.x, vector.y, vector.z) * T::constant(2.0)
}

impl<T: Real> Absolute<T> {
    fn link(&self, x: &SVector<T, 7>, i: usize) -> Vector3<T> {
        let (r, e) = parts(x);
        r + turned(&e, &e, &self.0.knuckle[i]) - self.0.chassis[i]
    }

    /// A knuckle end's velocity, or the linear part of its acceleration, from rates `dx`.
    fn rate_of_end(&self, x: &SVector<T, 7>, dx: &SVector<T, 7>, i: usize) -> Vector3<T> {
        let ((_, e), (dr, de)) = (parts(x), parts(dx));
        dr + turned(&e, &de, &self.0.knuckle[i]) * T::constant(2.0)
    }

    /// The part of a knuckle end's acceleration that is quadratic in the rates `dx`.
    fn centripetal(&self, dx: &SVector<T, 7>, i: usize) -> Vector3<T> {
        let (_, de) = parts(dx);
        turned(&de, &de, &self.0.knuckle[i]) * T::constant(2.0)
    }
}

impl<T: Real, D: Values<f64>, const N: usize> Formulation<T, D, 7, N> for Absolute<T> {
    /// The height of the first knuckle end above its chassis end.
    type Input = Signal<T>;

    fn input(&self, drives: &Signal<D>) -> Signal<T> {
        angle_to_coordinate(self.0.lengths[0], super::first_drive(drives))
    }

    fn size(&self) -> T {
        self.0.size()
    }

    fn residual(&self, x: &SVector<T, 7>, height: &Signal<T>) -> SVector<T, 7> {
        let half = T::constant(0.5);
        let (r, e) = parts(x);
        let mut rows = SVector::zeros();
        for (i, length) in self.0.lengths.iter().enumerate() {
            let square = self.link(x, i).norm_squared() - *length * *length;
            rows[i] = square * half / *length;
        }
        rows[HEIGHT] = r.z - self.0.chassis[0].z - height.value;
        rows[NORM] = (e.norm_squared() - T::one()) * half;
        rows
    }

    fn jacobian(&self, x: &SVector<T, 7>, _: &Signal<T>) -> SMatrix<T, 7, 7> {
        let (_, e) = parts(x);
        let mut rows = SMatrix::<T, 7, 7>::zeros();
        for (i, length) in self.0.lengths.iter().enumerate() {
            let d = self.link(x, i) / *length;
            let turn = gradient_of_turned(&e, &self.0.knuckle[i], &d);
            rows.fixed_view_mut::<1, 3>(i, 0).tr_copy_from(&d);
            rows.fixed_view_mut::<1, 4>(i, 3).tr_copy_from(&turn);
        }
        rows[(HEIGHT, 2)] = T::one();
        rows.fixed_view_mut::<1, 4>(NORM, 3).tr_copy_from(&e);
        rows
    }

    fn rate(&self, _: &SVector<T, 7>, height: &Signal<T>) -> SVector<T, 7> {
        SVector::ith(HEIGHT, height.rate)
    }

    fn second_rate(
        &self,
        x: &SVector<T, 7>,
        velocity: &SVector<T, 7>,
        height: &Signal<T>,
    ) -> SVector<T, 7> {
        let (_, de) = parts(velocity);
        let mut rows = SVector::ith(HEIGHT, height.second_rate);
        for (i, length) in self.0.lengths.iter().enumerate() {
            let square = self.rate_of_end(x, velocity, i).norm_squared();
            let turning = self.link(x, i).dot(&self.centripetal(velocity, i));
            rows[i] = -(square + turning) / *length;
        }
        rows[NORM] = -de.norm_squared();
        rows
    }

    fn near_points(&self, _: &SVector<f64, N>) -> SVector<T, 7> {
        let at_rest = Vector4::new(T::one(), T::zero(), T::zero(), T::zero());
        SVector::from_fn(|row, _| match row {
            0..3 => self.0.origin[row],
            _ => at_rest[row - 3],
        })
    }

    fn points(&self, [x, dx, ddx]: &State<T, 7>) -> [SVector<f64, N>; 3] {
        [
            in_a_row(|i| self.link(x, i) + self.0.chassis[i]),
            in_a_row(|i| self.rate_of_end(x, dx, i)),
            in_a_row(|i| self.rate_of_end(x, ddx, i) + self.centripetal(dx, i)),
        ]
    }
}

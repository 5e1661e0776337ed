//! Vector algebra of straight-line code: every function is inlined wherever it is called, because
//! lanes of numbers are fast only inside code that is compiled for their instructions. With debug assertions too:
//! tests take up to a third less time.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Scalar;

/// `a + b`.
#[inline(always)]
pub(crate) fn sum<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(a.x + b.x, a.y + b.y, a.z + b.z)
}

/// `a - b`.
#[inline(always)]
pub fn difference<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(a.x - b.x, a.y - b.y, a.z - b.z)
}

/// `-a`.
#[inline(always)]
pub fn opposite<T: Scalar>(a: Vector3<T>) -> Vector3<T> {
    Vector3::new(-a.x, -a.y, -a.z)
}

/// The components.
#[inline(always)]
pub fn xyz<T: Scalar>(a: Vector3<T>) -> [T; 3] {
    let [components] = a.data.0;
    components
}

/// `a k`.
#[inline(always)]
pub(crate) fn multiple<T: Scalar>(a: Vector3<T>, k: T) -> Vector3<T> {
    Vector3::new(a.x * k, a.y * k, a.z * k)
}

/// `a . b`.
#[inline(always)]
pub fn dot<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> T {
    (a.x * b.x).plus_product(a.y, b.y).plus_product(a.z, b.z)
}

/// `sum + a x b`.
#[inline(always)]
pub(crate) fn plus_cross<T: Scalar>(sum: Vector3<T>, a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(
        sum.x.plus_product(a.y, b.z).minus_product(a.z, b.y),
        sum.y.plus_product(a.z, b.x).minus_product(a.x, b.z),
        sum.z.plus_product(a.x, b.y).minus_product(a.y, b.x),
    )
}

/// `a x b`.
#[inline(always)]
pub(crate) fn cross<T: Scalar>(a: Vector3<T>, b: Vector3<T>) -> Vector3<T> {
    Vector3::new(
        (a.y * b.z).minus_product(a.z, b.y),
        (a.z * b.x).minus_product(a.x, b.z),
        (a.x * b.y).minus_product(a.y, b.x),
    )
}

/// `sum + a k`.
#[inline(always)]
pub(crate) fn plus_multiple<T: Scalar>(sum: Vector3<T>, a: Vector3<T>, k: T) -> Vector3<T> {
    Vector3::new(
        sum.x.plus_product(a.x, k),
        sum.y.plus_product(a.y, k),
        sum.z.plus_product(a.z, k),
    )
}

/// `sum - a k`.
#[inline(always)]
pub(crate) fn minus_multiple<T: Scalar>(sum: Vector3<T>, a: Vector3<T>, k: T) -> Vector3<T> {
    Vector3::new(
        sum.x.minus_product(a.x, k),
        sum.y.minus_product(a.y, k),
        sum.z.minus_product(a.z, k),
    )
}

/// A point moved along a unit vector until its coordinate along that vector has the given value.
#[inline(always)]
pub fn moved_along<T: Scalar>(
    point: Vector3<T>,
    direction: Vector3<T>,
    coordinate: T,
) -> Vector3<T> {
    plus_multiple(point, direction, coordinate - dot(point, direction))
}

/// The same vector in another number type: see [`Listing::gather`](crate::linkage::Listing::gather).
#[inline(always)]
pub fn gather_vector<M, S: Scalar, T: Scalar>(
    of: impl Fn(&M) -> Vector3<S>,
    number: &impl Fn(&dyn Fn(&M) -> S) -> T,
) -> Vector3<T> {
    Vector3::new(
        number(&|model| of(model).x),
        number(&|model| of(model).y),
        number(&|model| of(model).z),
    )
}

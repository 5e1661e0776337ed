//! Quantities computed from the points: value, rate and second rate.
//!
//! A line is the vector `d` from one point to another with its rates.

use nalgebra::Vector3;

use crate::arithmetic::scalar::Real;
use crate::signal::{Number, Signal};

/// `|d|`, in the unit of the points. The rates are NaN where the two points coincide, because the length turns back
/// there.
pub fn length<T: Real>(line: &Signal<Vector3<T>>) -> Signal<T> {
    let (d, rate, second) = (line.value, line.rate, line.second_rate);
    let length = d.norm();
    let growth = d.dot(&rate) / length;
    Signal {
        value: length,
        rate: growth,
        second_rate: (d.dot(&second) + rate.norm_squared() - growth * growth) / length,
    }
}

/// The angle in radians, from 0 to pi, between `d` and the unit vector `axis`: `atan2(s, c)`, where `c = d . axis`
/// and `s` is the length of the part of `d` normal to the axis. The rates are NaN where `d` is parallel to the axis,
/// because the angle turns back there, and where `d` is zero.
pub fn angle<T: Real>(line: &Signal<Vector3<T>>, axis: Vector3<T>) -> Signal<T> {
    let along = line.map(|d| d.dot(&axis));
    let across = length(&line.map(|d| d - axis * d.dot(&axis)));
    Signal::arc_tangent(across, along)
}

/// The angle in radians, from 0 to pi, between two lines: `atan2(|d x e|, d . e)`. The rates are NaN where the lines
/// are parallel, because the angle turns back there.
pub fn between<T: Real>(first: &Signal<Vector3<T>>, second: &Signal<Vector3<T>>) -> Signal<T> {
    let (d, e) = (first.components(), second.components());
    let normal = d.cross(&e);
    Signal::arc_tangent(normal.dot(&normal).square_root(), d.dot(&e))
}

/// The angle in radians, from -pi to pi, by which a line appears turned against another, seen with `axis` pointing
/// towards the viewer, anticlockwise positive: the angle between the parts of both lines normal to the axis.
pub fn turn<T: Real>(
    first: &Signal<Vector3<T>>,
    second: &Signal<Vector3<T>>,
    axis: &Signal<Vector3<T>>,
) -> Signal<T> {
    let [d, e, n] = [first, second, axis].map(Signal::components);
    let square = n.dot(&n);
    Signal::arc_tangent(
        d.cross(&e).dot(&n) * square.square_root(),
        d.dot(&e) * square - d.dot(&n) * e.dot(&n),
    )
}

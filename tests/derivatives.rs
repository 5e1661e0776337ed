//! Every entry of every Jacobian and curvature against central differences.
//!
//! The equations are at most quadratic, so a central difference is exact up to rounding and the step may be large.

use std::iter::repeat_with;

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::Named;
use suspension_core::listing::Part;
use suspension_core::model::constraint::{Carried, Distance, Frame, angle_to_coordinate};
use suspension_core::{Build, Linkage, Real, Signal, Values, model::measure};

use crate::support;

const STEP: f64 = 0.125;

/// A number in [-0.4, 0.4], the same for the same seed: coordinates of no special geometry.
fn crooked<T: Real>(seed: usize) -> T {
    T::constant(((seed * 7919 + 17) % 1009) as f64 / 1009.0 * 0.8 - 0.4)
}

fn crooked_vector<T: Real>(seed: usize) -> Vector3<T> {
    Vector3::new(
        crooked(3 * seed),
        crooked(3 * seed + 1),
        crooked(3 * seed + 2),
    )
}

fn assert_near<T: Real>(found: T, expected: T, what: &str) {
    let bound = T::EPSILON * T::constant(400.0);
    assert!(
        (found - expected).abs() <= bound,
        "{what}: {found} instead of {expected}"
    );
}

fn axis<T: Real, const N: usize>(index: usize) -> SVector<T, N> {
    SVector::from_fn(|row, _| if row == index { T::one() } else { T::zero() })
}

fn distance<T: Real>() {
    let constraint = Distance::new(T::constant(0.3));
    let d = crooked_vector::<T>(1);
    let step = T::constant(STEP);
    for i in 0..3 {
        let e = axis::<T, 3>(i);
        let difference = constraint.residual(d + e * step) - constraint.residual(d - e * step);
        assert_near(
            constraint.gradient(d)[i],
            difference / (step + step),
            "distance gradient",
        );
        for j in 0..3 {
            let w = axis::<T, 3>(j);
            let change = constraint.gradient(d + e * step) - constraint.gradient(d - e * step);
            let expected = change.dot(&w) / (step + step);
            assert_near(constraint.curvature(e, w), expected, "distance curvature");
        }
    }
}

fn carried<T: Real>() {
    let rest = Frame::new(crooked_vector(2), crooked_vector(3), crooked_vector(4));
    let constraint = Carried::new(crooked_vector(5), &rest).expect("a triangle");
    let points = [crooked_vector::<T>(6), crooked_vector(7), crooked_vector(8)];
    let frame = |p: [Vector3<T>; 3]| Frame::new(p[0], p[1], p[2]);
    let moved = |which: usize, by: Vector3<T>| {
        let mut points = points;
        points[which] += by;
        frame(points)
    };
    let blocks = |at: &Frame<T>| {
        let gradient = constraint.gradient(at);
        [gradient.origin, gradient.second, gradient.third]
    };
    let point = crooked_vector::<T>(9);
    let step = T::constant(STEP);
    let unit = |which: usize, i: usize| {
        let mut rates = [Vector3::zeros(); 3];
        rates[which] = axis::<T, 3>(i);
        frame(rates)
    };
    for (which, i) in (0..3).flat_map(|which| (0..3).map(move |i| (which, i))) {
        let e = axis::<T, 3>(i);
        let (ahead, behind) = (moved(which, e * step), moved(which, e * -step));
        let difference = constraint.residual(point, &ahead) - constraint.residual(point, &behind);
        let column = blocks(&frame(points))[which].column(i).into_owned();
        for row in 0..3 {
            let expected = difference[row] / (step + step);
            assert_near(column[row], expected, "carried gradient");
        }
        for (other, j) in (0..3).flat_map(|other| (0..3).map(move |j| (other, j))) {
            let change = blocks(&ahead)[other].column(j) - blocks(&behind)[other].column(j);
            let curvature = constraint.curvature(&unit(which, i), &unit(other, j));
            for row in 0..3 {
                assert_near(
                    curvature[row],
                    change[row] / (step + step),
                    "carried curvature",
                );
            }
        }
    }
}

/// Jacobian, input rates and curvature of a whole linkage.
fn listing<T: Real, L: Linkage<15, Scalar = T>>(model: &L) {
    let q = SVector::<T, 15>::from_fn(|i, _| crooked(100 + i));
    let mut seed = 200;
    let mut next_seed = || {
        seed += 1;
        seed
    };
    let fixed = L::Fixed::from_values(repeat_with(|| crooked_vector(next_seed())));
    let fixed_rate = L::Fixed::from_values(repeat_with(|| crooked_vector::<T>(next_seed())));
    let drives = L::Drives::from_values(repeat_with(|| crooked(next_seed())));
    let zero = L::Fixed::default();
    let step = T::constant(STEP);
    let two_steps = step + step;
    let jacobian = model.jacobian(&q, &fixed);
    for column in 0..15 {
        let e = axis::<T, 15>(column);
        let ahead = model.residual(&(q + e * step), &fixed, &drives);
        let behind = model.residual(&(q - e * step), &fixed, &drives);
        let change =
            model.jacobian(&(q + e * step), &fixed) - model.jacobian(&(q - e * step), &fixed);
        for row in 0..15 {
            let what = format!(
                "dF/dq of {} by {}",
                model.name(Part::Equation(row)),
                model.name(Part::Unknown(column))
            );
            assert_near(
                jacobian[(row, column)],
                (ahead[row] - behind[row]) / two_steps,
                &what,
            );
        }
        for other in 0..15 {
            let curvature = model.curvature(&e, &zero, &axis(other), &zero);
            for row in 0..15 {
                let what = format!(
                    "C of {} by {column} and {other}",
                    model.name(Part::Equation(row))
                );
                assert_near(curvature[row], change[(row, other)] / two_steps, &what);
            }
        }
    }
    inputs(model, &q, [&fixed, &fixed_rate], &drives);
}

/// `-dF/du udot` of moving chassis points and drives, and the curvature with moving chassis.
fn inputs<T: Real, L: Linkage<15, Scalar = T>>(
    model: &L,
    q: &SVector<T, 15>,
    [fixed, fixed_rate]: [&L::Fixed; 2],
    drives: &L::Drives,
) {
    let step = T::constant(STEP);
    let drive_rate = drives.map(|_| T::constant(0.7));
    let v = SVector::<T, 15>::from_fn(|i, _| crooked(400 + i));
    let at = |s: T, v: &SVector<T, 15>| {
        let moving = fixed.values().zip(fixed_rate.values());
        let fixed = L::Fixed::from_values(moving.map(|(point, rate)| point + rate * s));
        let drives = drives.map(|drive| drive + T::constant(0.7) * s);
        model.residual(&(q + v * s), &fixed, &drives)
    };
    let zero = SVector::zeros();
    let expected = (at(step, &zero) - at(-step, &zero)) / (step + step);
    let found = model.drive_rate(q, fixed, fixed_rate, &drive_rate)
        + model.chassis_rate(q, fixed, fixed_rate);
    let second =
        (at(step, &v) - at(T::zero(), &v) * T::constant(2.0) + at(-step, &v)) / (step * step);
    let curvature = model.curvature(&v, fixed_rate, &v, fixed_rate);
    for row in 0..15 {
        assert_near(
            found[row],
            -expected[row],
            &format!("-dF/du of {}", model.name(Part::Equation(row))),
        );
        let what = format!("second rate of {}", model.name(Part::Equation(row)));
        assert_near(curvature[row], second[row], &what);
    }
}

#[test]
fn derivatives_of_distances_agree_with_differences_in_f64_and_f32() {
    distance::<f64>();
    distance::<f32>();
}

#[test]
fn derivatives_of_carried_points_agree_with_differences() {
    carried::<f64>();
    carried::<f32>();
}

#[test]
fn derivatives_of_attia2003_agree_with_differences() {
    listing(&support::attia_model::<f64>());
    listing(&support::attia_model::<f32>());
}

#[test]
fn derivatives_of_five_link_agree_with_differences() {
    listing(&support::five_link_model::<f64>());
    listing(&support::five_link_model::<f32>());
}

/// Every kind of measure against central differences in time, of points that move as polynomials.
#[test]
fn derivatives_of_measures_agree_with_differences() {
    suspension_core::linkage! {
        mod gauge {
            fixed: a;
            free:  p, q;
            link rod:  a -> p;
            link bar:  p -> q;
            drive p_y: p.y;
            drive p_z: p.z;
            drive q_y: q.y;
            drive q_z: q.z;
            point hub: a, p, q;
            measure height: hub.z;
            measure track:  q.y - a.y;
            measure spring: length(a -> hub);
            measure from_x: angle(hub -> p, x);
            measure from_y: angle(a -> q, y);
            measure from_z: angle(q -> hub, z);
            measure mean: 0.5 hub.z - 2 q.x + p.y;
            measure apart: angle(a -> p, hub -> q);
            measure about: angle(a -> p, hub -> q about p -> hub);
        }
    }
    use gauge::{Measures, Model, Points};
    type Point = Vector3<f64>;
    let at = |t: f64| {
        let terms =
            |name: usize| [0_usize, 1, 2, 3].map(|order| crooked_vector::<f64>(10 * order + name));
        let points = |of: &dyn Fn([Point; 4]) -> Point| {
            Points::<f64>::from_values((501..).map(|name| of(terms(name))))
        };
        let value = points(&|[a, b, c, d]| a + (b + (c + d * t) * t) * t);
        let model = Model::new(&value).expect("a linkage");
        model.measures(&Signal {
            value,
            rate: points(&|[_, b, c, d]| b + (c * 2.0 + d * 3.0 * t) * t),
            second_rate: points(&|[_, _, c, d]| c * 2.0 + d * 6.0 * t),
        })
    };
    let h = 1e-4;
    for t in [-0.3, 0.1, 0.4] {
        let (now, ahead, behind) = (at(t), at(t + h), at(t - h));
        let change = |ahead: Measures<f64>, behind: Measures<f64>| {
            let (ahead, behind) = (ahead.values(), behind.values());
            let pairs: Vec<_> = ahead.zip(behind).collect();
            pairs
                .into_iter()
                .map(|(ahead, behind)| (ahead - behind) / (2.0 * h))
        };
        let names = <Measures<f64> as Named<f64>>::NAMES;
        for (expected, found) in [
            (change(ahead.value, behind.value), now.rate),
            (change(ahead.rate, behind.rate), now.second_rate),
        ] {
            for ((name, expected), found) in names.iter().zip(expected).zip(found.values()) {
                let bound = 1e-5 * (1.0 + expected.abs());
                assert!(
                    (found - expected).abs() < bound,
                    "{name} at {t}: {found} instead of {expected}"
                );
            }
        }
        let line = Vector3::x() * (t + 1.0);
        let still = Signal {
            value: line,
            ..Signal::default()
        };
        assert_eq!(measure::length(&still).value, t + 1.0);
        assert_eq!(measure::angle(&still, Vector3::x()).value, 0.0);
        let right = measure::angle(&still, Vector3::z()).value;
        assert_eq!(right, std::f64::consts::FRAC_PI_2);
    }
}

/// The chain rule of a driving angle against differences of `L cos(theta)` in time.
#[test]
fn derivatives_of_a_driving_angle_agree_with_differences() {
    let at = |t: f64| angle_to_coordinate(0.45, support::theta(t));
    let (t, h) = (0.8, 1e-4);
    let rate = (at(t + h).value - at(t - h).value) / (2.0 * h);
    let second_rate = (at(t + h).rate - at(t - h).rate) / (2.0 * h);
    let Signal {
        rate: found_rate,
        second_rate: found_second,
        ..
    } = at(t);
    assert!(
        (found_rate - rate).abs() < 1e-8,
        "{found_rate} instead of {rate}"
    );
    assert!(
        (found_second - second_rate).abs() < 1e-8,
        "{found_second} instead of {second_rate}"
    );
}

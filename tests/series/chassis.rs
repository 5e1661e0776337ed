//! Moving chassis points, driven anchors and coordinates.

use nalgebra::{Rotation3, SVector, Vector3};
use suspension_core::linkages::five_link;
use suspension_core::step::series::{InputSeries, Jet, Series};
use suspension_core::{Build, Linkage, Newton, Signal, Tangent, Values, assemble};

use crate::support;

/// `about + amplitude sin(omega t + phase)` and its Taylor coefficients at `t`.
fn swing<const K: usize>(about: f64, amplitude: f64, omega: f64, t: f64) -> Jet<f64, K> {
    let angle = |order: usize| omega * t + std::f64::consts::FRAC_PI_2 * order as f64;
    let mut factor = amplitude;
    let terms = std::array::from_fn(|index| {
        factor *= omega / (index + 1) as f64;
        factor * angle(index + 1).sin()
    });
    Jet {
        value: about + amplitude * angle(0).sin(),
        terms,
    }
}

/// As many jets as there are names, made one.
fn named<V, S: Values<V>, const K: usize>(jets: &[Jet<V, K>]) -> Jet<S, K>
where
    V: Copy + Default,
{
    let collect = |part: &dyn Fn(&Jet<V, K>) -> V| S::from_values(jets.iter().map(part));
    Jet {
        value: collect(&|jet| jet.value),
        terms: std::array::from_fn(|index| collect(&move |jet| jet.terms[index])),
    }
}

/// A chassis that turns about z with the angular velocity `omega`: the driving angle, measured
/// from z, stays, and the whole motion turns with it.
#[test]
fn the_series_of_points_turns_with_the_chassis() {
    const K: usize = 24;
    let (t, omega) = (1.0, 0.8);
    let model: five_link::Model<f64> = support::five_link_model();
    let rough = support::five_link_rough();
    let start = support::motions(&model, &rough, support::five_link_inputs)[4].position;
    let drives = Jet::of_signal(&support::five_link_inputs(t).drives);
    let at_rest = Series::<_, 15, K>::at(&model, &InputSeries::still(drives), &start)
        .expect("a regular configuration");
    let points: Vec<Jet<Vector3<f64>, K>> =
        model.fixed().values().map(|p| turning(p, omega)).collect();
    let inputs = InputSeries {
        chassis: named(&points),
        drives,
    };
    let moving = Series::at(&model, &inputs, &start).expect("a regular configuration");
    for dt in [-0.1, 0.05, 0.2] {
        let [found, rest] = [&moving, &at_rest].map(|series| series.motion(dt));
        let turn = Rotation3::from_axis_angle(&Vector3::z_axis(), omega * dt);
        let spin = Vector3::z() * omega;
        for point in 0..5 {
            let rows = |v: &SVector<f64, 15>| v.fixed_rows::<3>(3 * point).into_owned();
            let (r, v, a) = (
                rows(&rest.position),
                rows(&rest.velocity),
                rows(&rest.acceleration),
            );
            let expected = [
                r,
                v + spin.cross(&r),
                a + spin.cross(&v) * 2.0 + spin.cross(&spin.cross(&r)),
            ];
            let found = [&found.position, &found.velocity, &found.acceleration].map(rows);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - turn * expected).amax() < 1e-10, "at {dt} s");
            }
        }
    }
}

/// A point that turns about z.
fn turning<const K: usize>(point: Vector3<f64>, omega: f64) -> Jet<Vector3<f64>, K> {
    let [sine, cosine] =
        [0.0, std::f64::consts::FRAC_PI_2 / omega].map(|t| swing(0.0, 1.0, omega, t));
    let turned =
        |c: f64, s: f64| Vector3::new(c * point.x - s * point.y, s * point.x + c * point.y, 0.0);
    let (sine, cosine): (Jet<f64, K>, Jet<f64, K>) = (sine, cosine);
    Jet {
        value: turned(cosine.value, sine.value) + Vector3::z() * point.z,
        terms: std::array::from_fn(|index| turned(cosine.terms[index], sine.terms[index])),
    }
}

suspension_core::linkage! {
    /// A four-bar that is turned and slid, with one anchor driven.
    mod four_bar {
        fixed: crank_pin, rocker_pin;
        free:  crank_end, rocker_end;
        link crank:   crank_pin -> crank_end;
        link coupler: crank_end -> rocker_end;
        link rocker:  rocker_pin -> rocker_end;
        drive turn:   angle(crank_pin -> crank_end, z);
        drive slide:  crank_end.x;
        drive align:  rocker_end.x - crank_end.x;
        drive shift:  rocker_pin.y;
    }
}

suspension_core::linkage! {
    /// A semi-trailing arm, hinged to the chassis, with a flap.
    mod arm {
        fixed: inner, outer;
        free:  hinge_in, hinge_out, tip;
        body arm:  hinge_in, hinge_out, inner, outer;
        body flap: tip, hinge_in, hinge_out;
        drive bump: hinge_out.z;
        drive fold: tip.z - hinge_in.z;
    }
}

/// All drives and chassis points swing; the series must meet the solution of the equations, its
/// velocities and accelerations.
fn assert_series_follows_the_motion<L, const N: usize>(model: &L, design: &L::Points)
where
    L: Build<N, Scalar = f64>,
{
    const K: usize = 20;
    let about = model.drives_at(design);
    let inputs = |t: f64| {
        let drives: Vec<Jet<f64, K>> = about
            .values()
            .enumerate()
            .map(|(index, about)| swing(about, 0.05, 2.0 + index as f64, t))
            .collect();
        let points: Vec<Jet<Vector3<f64>, K>> = model
            .fixed()
            .values()
            .map(|point| {
                let axes =
                    [0, 1, 2].map(|axis| swing::<K>(point[axis], 0.02, 1.0 + axis as f64, t));
                Jet {
                    value: Vector3::from(axes.map(|jet| jet.value)),
                    terms: std::array::from_fn(|k| Vector3::from(axes.map(|jet| jet.terms[k]))),
                }
            })
            .collect();
        InputSeries {
            chassis: named::<_, L::Fixed, K>(&points),
            drives: named::<_, L::Drives, K>(&drives),
        }
    };
    let solve = |t: f64| {
        let inputs = inputs(t).at(0.0);
        let mut q = model.unknowns(design);
        assemble(&Newton::from_afar(), model, &inputs, &mut q).expect("a configuration near by");
        Tangent::new(model, &inputs, &q).and_then(|tangent| tangent.motion())
    };
    let start = solve(0.3).expect("a regular configuration");
    let series = Series::at(model, &inputs(0.3), &start.position).expect("a regular configuration");
    assert_eq!(
        Some(series.positive_determinant),
        start.positive_determinant
    );
    for dt in [-0.05, 0.02, 0.1] {
        let (found, expected) = (series.motion(dt), solve(0.3 + dt).expect("regular"));
        let off = [
            found.position - expected.position,
            found.velocity - expected.velocity,
            found.acceleration - expected.acceleration,
        ]
        .map(|difference| difference.amax());
        println!("{dt}: {off:?}, radius {:?}", series.radius());
        assert!(
            off[0] < 1e-13 && off[1] < 1e-11 && off[2] < 1e-9,
            "{off:?} at {dt} s"
        );
    }
}

#[test]
fn the_series_of_a_four_bar_follows_a_swinging_chassis() {
    let design = four_bar::Points {
        crank_pin: Vector3::zeros(),
        rocker_pin: Vector3::new(0.0, 0.6, 0.1),
        crank_end: Vector3::new(0.0, 0.17, 0.1),
        rocker_end: Vector3::new(0.0, 0.55, 0.45),
    };
    assert_series_follows_the_motion(&four_bar::Model::new(&design).expect("a four-bar"), &design);
}

#[test]
fn the_series_of_arm_and_flap_follows_a_swinging_chassis() {
    let design = arm::Points {
        inner: Vector3::new(0.40, 0.20, 0.30),
        outer: Vector3::new(0.35, 0.55, 0.28),
        hinge_in: Vector3::new(0.05, 0.40, 0.32),
        hinge_out: Vector3::new(0.02, 0.60, 0.30),
        tip: Vector3::new(-0.15, 0.50, 0.35),
    };
    assert_series_follows_the_motion(&arm::Model::new(&design).expect("an arm"), &design);
}

/// A signal's polynomial and its values elsewhere.
#[test]
fn the_series_of_a_signal_is_its_polynomial() {
    let signal = support::five_link_inputs(1.0).drives;
    let jet: Jet<_, 5> = Jet::of_signal(&signal);
    let (found, expected) = (jet.signal(0.3), support::five_link_inputs(1.3).drives);
    let off =
        |part: fn(&Signal<five_link::Drives<f64>>) -> f64| (part(&found) - part(&expected)).abs();
    assert!(off(|s| s.value.theta) < 1e-15 && off(|s| s.rate.theta) < 1e-15);
    assert!(off(|s| s.second_rate.theta) < 1e-15);
}

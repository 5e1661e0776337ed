//! Curves of one drive.

use nalgebra::Vector3;
use suspension::bake::{Baked, Continuity, Exact, Path, RequestedPoints, TERMS, Wanted, bake};
use suspension::mechanism::Suspension;
use suspension_core::baked::Curve;
use suspension_core::linkage::Named;
use suspension_core::linkages::five_link;
use suspension_core::{Inputs, Real, Still};

use super::mixed;
use crate::support::{self, INSTANTS, Reference, theta};

const CONTINUITIES: [Continuity; 3] = [
    Continuity::Position,
    Continuity::Velocity,
    Continuity::Acceleration,
];

/// The range of the published motion.
const RANGE: [f64; 2] = [0.7, 2.150_312_5];

fn wanted(tolerance: f64, continuity: Continuity) -> Wanted {
    Wanted {
        range: RANGE,
        tolerance,
        metre: 1.0,
        continuity,
    }
}

/// Bakes the published motion and gives it, with the exact one, to `check`.
fn published<L>(
    model: &L,
    rough: &L::Points,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
    points: RequestedPoints,
    wanted: &Wanted,
    check: impl Fn(&Baked, &dyn Exact),
) where
    L: Suspension<15>,
{
    let start = support::motions(model, rough, inputs)[0];
    let held = inputs(0.0).drives.value;
    let path = Path::new(model, &start, held, 0, RANGE, points).expect("a regular range");
    check(&bake(wanted, &path).expect("within the tolerance"), &path);
}

fn curve_of<T: Real, const OUT: usize>(baked: &Baked) -> Curve<'static, T, OUT, TERMS> {
    baked.curve(baked.table().expect("the number of outputs").leak())
}

fn vectors<const OUT: usize>(numbers: &[f64; OUT]) -> Vec<Vector3<f64>> {
    numbers.chunks(3).map(Vector3::from_column_slice).collect()
}

/// Differences from the solver at random places are within what the file would claim.
fn check_against_the_solver(baked: &Baked, exact: &dyn Exact) {
    const SEED: u64 = 3;
    let Wanted {
        range: [from, to],
        tolerance,
        ..
    } = baked.wanted;
    let curve = curve_of::<f64, 6>(baked);
    let mut largest = [0.0_f64; 3];
    let ends = [0.0, 1.0].into_iter();
    for part in ends.chain(mixed(SEED).take(3000)) {
        let at = (from + (to - from) * part).min(to);
        let found = curve.at(at).expect("inside").acceleration(1.0, 0.0);
        let exact = exact.at(at).expect("regular");
        for (order, found) in found.iter().enumerate() {
            for (found, exact) in vectors(found).iter().zip(&exact) {
                largest[order] = largest[order].max((found - exact[order]).norm());
            }
        }
    }
    let reached = baked.reached;
    assert!(reached.position <= tolerance);
    for (order, claimed) in [reached.position, reached.first, reached.second]
        .into_iter()
        .enumerate()
    {
        let found = largest[order];
        assert!(
            found <= claimed,
            "seed {SEED}, derivative {order}: {found:e} > {claimed:e}"
        );
        assert!(
            found > 0.4 * claimed,
            "derivative {order}: {found:e} is far less than {claimed:e}"
        );
    }
}

#[test]
fn a_baked_wheel_is_within_its_stated_errors() {
    for continuity in CONTINUITIES {
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let wanted = wanted(tolerance, continuity);
            published(
                &support::five_link_model(),
                &support::five_link_rough(),
                support::five_link_inputs,
                RequestedPoints::Wheel(0),
                &wanted,
                check_against_the_solver,
            );
            published(
                &support::attia_model(),
                &support::attia_rough(),
                support::attia_inputs,
                RequestedPoints::Wheel(0),
                &wanted,
                check_against_the_solver,
            );
        }
    }
}

#[test]
fn baked_points_agree_with_the_40_digit_reference() {
    let reference = Reference::load();
    let check = |baked: &Baked, _: &dyn Exact| {
        let curve = curve_of::<f64, 18>(baked);
        let reached = baked.reached;
        for (instant, t) in INSTANTS.into_iter().enumerate() {
            let drive = theta(t);
            let place = curve.at(drive.value).expect("inside");
            let found = place.acceleration(drive.rate, drive.second_rate);
            let allowed = [
                reached.position,
                reached.first * drive.rate,
                reached.second * drive.rate.powi(2) + reached.first * drive.second_rate,
            ];
            for ((found, kind), allowed) in found.iter().zip(["", "v", "a"]).zip(allowed) {
                for (index, found) in vectors(found).iter().take(5).enumerate() {
                    let prefix = format!("p{}_{kind}", index + 6);
                    let off = (found - reference.vector(instant, &prefix)).norm();
                    assert!(
                        off <= allowed + 1e-10,
                        "{prefix} at {t} s: {off:e} > {allowed:e}"
                    );
                }
            }
        }
    };
    published(
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
        RequestedPoints::AllPoints,
        &wanted(1e-7, Continuity::Acceleration),
        check,
    );
}

#[test]
fn segments_of_a_curve_join_with_the_requested_continuity() {
    for (continuous, continuity) in CONTINUITIES.into_iter().enumerate() {
        let check = |baked: &Baked, _: &dyn Exact| {
            let curve = curve_of::<f64, 6>(baked);
            let length = 1.0 / curve.segments_per_unit;
            let rounding = [1e-14, 1e-12, 1e-10];
            for join in 1..curve.segments.len() {
                let at = RANGE[0] + length * join as f64;
                let [before, after] = [-1e-9, 1e-9].map(|off| {
                    curve
                        .at(at + off * length)
                        .expect("inside")
                        .acceleration(1.0, 0.0)
                });
                for order in 0..=continuous {
                    let moved = after.get(order + 1).map_or(1e4, norm) * 4e-9 * length;
                    let jump = norm(&std::array::from_fn(|i| after[order][i] - before[order][i]));
                    assert!(jump <= moved + rounding[order], "{order} at {at}: {jump:e}");
                }
            }
        };
        published(
            &support::five_link_model(),
            &support::five_link_rough(),
            support::five_link_inputs,
            RequestedPoints::Wheel(0),
            &wanted(1e-4, continuity),
            check,
        );
    }
}

fn norm(numbers: &[f64; 6]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn a_curve_refuses_a_drive_outside_its_range() {
    static LINE: Curve<'_, f32, 1, 2> = Curve {
        range: [-1.0, 3.0],
        segments_per_unit: 0.5,
        segments: &[[[10.0], [2.0]], [[12.0], [4.0]]],
    };
    for (drive, value) in [
        (-1.0, 10.0),
        (0.0, 11.0),
        (1.0, 12.0),
        (2.0, 14.0),
        (3.0, 16.0),
    ] {
        let place = LINE.at(drive).expect("inside");
        assert_eq!(place.position(), [value]);
        let slope = if drive < 1.0 { 1.0 } else { 2.0 };
        assert_eq!(place.velocity(3.0), [[value], [3.0 * slope]]);
        assert_eq!(place.acceleration(3.0, 5.0)[2], [5.0 * slope]);
    }
    for (drive, nearest) in [
        (-1.001, -1.0),
        (3.001, 3.0),
        (f32::INFINITY, 3.0),
        (f32::NAN, -1.0),
    ] {
        let outside = LINE.at(drive).expect_err("outside");
        assert_eq!(outside.nearest, nearest);
        assert!(LINE.at(outside.nearest).is_ok());
    }
    let empty = Curve::<f64, 1, 1> {
        range: [0.0, 1.0],
        segments_per_unit: 0.0,
        segments: &[],
    };
    assert!(empty.at(0.5).is_err());
}

#[test]
fn baked_outputs_have_the_point_names_of_the_listing() {
    let check = |baked: &Baked, _: &dyn Exact| {
        let names = <five_link::Points<f64> as Named<Vector3<f64>>>::NAMES;
        let found = baked.outputs.iter().map(|output| output.name());
        assert!(found.eq(names[5..].iter().copied()));
    };
    published(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
        RequestedPoints::AllPoints,
        &wanted(1e-4, Continuity::Position),
        check,
    );
}

#[test]
fn a_curve_in_f32_loses_only_rounding() {
    let check = |baked: &Baked, exact: &dyn Exact| {
        let curve = curve_of::<f32, 6>(baked);
        for part in mixed(7).take(1000) {
            let [from, to] = curve.range;
            let at = (from + (to - from) * part as f32).min(to);
            let found = curve.at(at).expect("inside").position().map(f64::from);
            let exact = exact.at(f64::from(at)).expect("regular");
            for (found, exact) in vectors(&found).iter().zip(&exact) {
                let off = (found - exact[0]).norm();
                assert!(off <= baked.reached.position + 1e-6, "{off:e} at {at}");
            }
        }
    };
    published(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
        RequestedPoints::Wheel(0),
        &wanted(1e-5, Continuity::Velocity),
        check,
    );
}

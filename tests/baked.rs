//! Baked motions against the solver and the 40-digit reference.

mod support;

use nalgebra::Vector3;
use support::{INSTANTS, Reference, theta};
use suspension::bake::{
    Baked, Continuity, Exact, Path, TERMS, Wanted, WantedSurface, Wish, bake, bake_surface,
};
use suspension_core::baked::{Curve, Surface};
use suspension_core::linkages::five_link;
use suspension_core::{
    Build, HasWheel, Inputs, Linkage, Motion, Named, Signal, Still, Tracker, linkage,
};

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
    wish: Wish,
    wanted: &Wanted,
    check: impl Fn(&Baked, &dyn Exact),
) where
    L: Build<15, Scalar = f64, Points: HasWheel<f64>>,
{
    let start = support::motions(model, rough, inputs)[0];
    let held = inputs(0.0).drives.value;
    let path = Path::new(model, &start, held, 0, RANGE, wish).expect("a regular range");
    check(&bake(wanted, &path).expect("within the tolerance"), &path);
}

fn curve<const OUT: usize>(
    baked: &Baked,
    segments: &'static [[[f64; OUT]; TERMS]],
) -> Curve<'static, f64, OUT, TERMS> {
    Curve {
        range: baked.wanted.range,
        segments_per_unit: baked.segments_per_unit(),
        segments,
    }
}

fn curve_of<const OUT: usize>(baked: &Baked) -> Curve<'static, f64, OUT, TERMS> {
    curve(baked, baked.table().expect("the number of outputs").leak())
}

/// Evenly mixed numbers from 0 to 1, always the same (splitmix64).
fn mixed(seed: u64) -> impl Iterator<Item = f64> {
    (1..).map(move |k: u64| {
        let mut z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64
    })
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
    let curve = curve_of::<6>(baked);
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
fn a_baked_wheel_is_as_close_to_the_solver_as_it_says() {
    for continuity in CONTINUITIES {
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let wanted = wanted(tolerance, continuity);
            published(
                &support::five_link_model(),
                &support::five_link_rough(),
                support::five_link_inputs,
                Wish::Wheel,
                &wanted,
                check_against_the_solver,
            );
            published(
                &support::attia_model(),
                &support::attia_rough(),
                support::attia_inputs,
                Wish::Wheel,
                &wanted,
                check_against_the_solver,
            );
        }
    }
}

#[test]
fn baked_points_agree_with_the_reference() {
    let reference = Reference::load();
    let check = |baked: &Baked, _: &dyn Exact| {
        let curve = curve_of::<18>(baked);
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
        Wish::AllPoints,
        &wanted(1e-7, Continuity::Acceleration),
        check,
    );
}

#[test]
fn segments_join_as_smoothly_as_asked() {
    for (continuous, continuity) in CONTINUITIES.into_iter().enumerate() {
        let check = |baked: &Baked, _: &dyn Exact| {
            let curve = curve_of::<6>(baked);
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
            Wish::Wheel,
            &wanted(1e-4, continuity),
            check,
        );
    }
}

fn norm(numbers: &[f64; 6]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

#[test]
fn outside_its_range_a_curve_says_so() {
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
fn names_of_points_are_those_of_the_listing() {
    let check = |baked: &Baked, _: &dyn Exact| {
        let names = <five_link::Points<f64> as Named<Vector3<f64>>>::NAMES;
        let found = baked.outputs.iter().map(|output| output.name());
        assert!(found.eq(names[5..].iter().copied()));
    };
    published(
        &support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
        Wish::AllPoints,
        &wanted(1e-4, Continuity::Position),
        check,
    );
}

linkage! {
    /// A user's own listing, of two drives. Axes as ISO 8855.
    mod double_wishbone {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        link lower_fore: lower_front -> lower_ball;
        link lower_aft:  lower_rear  -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft:  upper_rear  -> upper_ball;
        link tie_rod:    rack        -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;

        drive bump:  axle_outer.z;
        drive steer: rack.y;

        wheel:   axle_inner -> axle_outer;
        kingpin: lower_ball -> upper_ball;
    }
}

fn wishbone() -> double_wishbone::Points<f64> {
    let at = Vector3::new;
    double_wishbone::Points {
        lower_front: at(0.15, 0.40, 0.18),
        lower_rear: at(-0.20, 0.42, 0.19),
        upper_front: at(0.10, 0.45, 0.55),
        upper_rear: at(-0.15, 0.48, 0.56),
        rack: at(-0.16, 0.38, 0.30),
        lower_ball: at(0.01, 0.75, 0.15),
        upper_ball: at(-0.02, 0.68, 0.56),
        tie_ball: at(-0.14, 0.74, 0.31),
        axle_inner: at(0.0, 0.66, 0.33),
        axle_outer: at(0.0, 0.76, 0.33),
    }
}

/// Travel of 80 mm and steering of 40 mm at the rack, either way, from the design.
const TRAVEL: f64 = 0.08;
const RACK: f64 = 0.04;

fn check_surface(tolerance: f64, smooth: bool, velocity_within: f64) {
    const SEED: u64 = 5;
    let design = wishbone();
    let model = double_wishbone::Model::new(&design).expect("a double wishbone");
    let at_rest = Motion::at_rest(double_wishbone::Model::unknowns(&design));
    let held = model.drives_at(&design);
    let ranges = [
        [held.bump - TRAVEL, held.bump + TRAVEL],
        [held.steer - RACK, held.steer + RACK],
    ];
    let wanted = WantedSurface {
        drives: [0, 1],
        ranges,
        tolerance,
        metre: 1.0,
        smooth,
        wish: Wish::Wheel,
    };
    let baked = bake_surface(&model, &at_rest, held, &wanted).expect("within the tolerance");
    assert!(baked.reached <= tolerance);
    let table = baked.table::<6>().expect("six outputs");
    let surface = Surface {
        ranges,
        patches_per_unit: baked.patches_per_unit(),
        across: baked.counts[1],
        patches: &table,
    };
    let mut motion = at_rest;
    let mut worst = [0.0_f64; 3];
    let numbers: Vec<f64> = mixed(SEED).take(4000).collect();
    let mut last = held;
    for pair in numbers.chunks_exact(2) {
        let [bump, steer] = [0, 1].map(|way| {
            let [from, to] = ranges[way];
            (from + (to - from) * pair[way]).min(to)
        });
        let drives = double_wishbone::Drives { bump, steer };
        let inputs = |part: f64| {
            let rate = |from: f64, to: f64| to - from;
            Inputs::still(Signal {
                value: double_wishbone::Drives {
                    bump: last.bump + rate(last.bump, bump) * part,
                    steer: last.steer + rate(last.steer, steer) * part,
                },
                rate: double_wishbone::Drives {
                    bump: 0.3,
                    steer: -0.2,
                },
                second_rate: double_wishbone::Drives {
                    bump: 2.0,
                    steer: 1.0,
                },
            })
        };
        let still = Motion::at_rest(motion.position);
        motion = still;
        Tracker::default()
            .advance(&model, inputs, 0.0, 1.0, &mut motion)
            .expect("regular");
        let points = motion.points(&model, &inputs(1.0));
        let found = surface.at([bump, steer]).expect("inside");
        let found = found.acceleration([0.3, -0.2], [2.0, 1.0]);
        for (order, exact) in [&points.value, &points.rate, &points.second_rate]
            .into_iter()
            .enumerate()
        {
            let axis = (exact.axle_outer - exact.axle_inner) / 0.1;
            let exact = [exact.axle_outer, axis];
            for (found, exact) in points_of(&found[order]).iter().zip(&exact) {
                worst[order] = worst[order].max((found - exact).norm());
            }
        }
        last = drives;
    }
    assert!(
        worst[0] <= baked.reached,
        "seed {SEED}: {worst:?} > {:e}",
        baked.reached
    );
    assert!(
        worst[0] > 0.2 * baked.reached,
        "{worst:?} is far less than {:e}",
        baked.reached
    );
    assert!(
        worst[1] <= velocity_within,
        "{worst:?}, {:?} patches",
        baked.counts
    );
    assert!(surface.at([ranges[0][0] - 1e-9, held.steer]).is_err());
    let outside = surface
        .at([held.bump, ranges[1][1] + 1e-9])
        .expect_err("outside");
    assert_eq!(outside.nearest, ranges[1][1]);
    eprintln!("{:?} patches, worst {worst:?}", baked.counts);
}

fn points_of(numbers: &[f64; 6]) -> [Vector3<f64>; 2] {
    let [a, b, c, d, e, f] = *numbers;
    [Vector3::new(a, b, c), Vector3::new(d, e, f)]
}

#[test]
fn a_surface_of_travel_and_steering_is_as_close_to_the_solver_as_it_says() {
    for (tolerance, velocity_within) in [(1e-4, 1e-2), (1e-6, 3e-4), (1e-8, 1e-5)] {
        check_surface(tolerance, true, velocity_within);
        check_surface(tolerance, false, 3.0 * velocity_within);
    }
}

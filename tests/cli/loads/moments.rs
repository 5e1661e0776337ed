//! Moments about angles: a torsion bar, a rotary actuator, an angle that is held. What carries a line of the angle passes them on.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;

use super::{force, table};

type Row = BTreeMap<String, f64>;

/// Returns the only row of loads of statements at their single instant.
fn only(statements: &str, drives: &str, loads: &str) -> Row {
    let file = file(statements, drives, loads);
    let rows = table(&file, &["--motion"]);
    assert_eq!(rows.len(), 1);
    rows[0].clone()
}

fn file(statements: &str, drives: &str, loads: &str) -> String {
    format!(
        "statements = '''\n{statements}'''\nunit = \"m\"\ntime = {{ instants = [0.0] }}\nvehicle = {{ wheel_radius = 0.3 }}\n\
         [drives]\n{drives}\n[loads.c]\n{loads}\n"
    )
}

fn assert_near(found: Vector3<f64>, expected: [f64; 3], what: &str) {
    let off = (found - Vector3::from(expected)).norm();
    assert!(off < 1e-8, "{what}: {found:?}, not {expected:?}");
}

/// A trailing arm, 0.4 m long, whose hub is somewhere across the vehicle.
fn arm(hub: f64) -> String {
    format!(
        "fixed: outer at [0.4, 0.6, 0.3], inner at [0.4, 0.3, 0.3], mark at [-0.1, 0.3, 0.3];
free: hub at [0.0, {hub:?}, 0.3];
hinge arm: outer, inner -> hub;\n"
    )
}

/// A bar exerts only a moment about its own axis: the bushes bear the load by the lever rule, for any line of the arm in the
/// angle.
#[test]
fn bushes_of_an_arm_on_a_torsion_bar_bear_the_lever_rule_forces() {
    let load = "hub = [0.0, 0.0, 1000.0]";
    for hub in [0.6, 0.45, 0.3, 0.7] {
        for from in ["outer", "inner"] {
            let arm = arm(hub);
            let bar = format!("bar: angle(inner -> mark, {from} -> hub about inner -> outer);");
            let measured = format!("{arm}drive bump: hub.z;\nmeasure {bar}\n");
            let carried = only(&measured, "bump = 0.3", &format!("{load}\nbump = \"bar\""));
            let driven = only(&format!("{arm}drive {bar}\n"), "bar = 0.0", load);
            assert!((carried["c_bar_Nm"] + 400.0).abs() < 1e-9, "{carried:?}");
            assert!((driven["c_bar_Nm"] - 400.0).abs() < 1e-9, "{driven:?}");
            let share = 1000.0 * (hub - 0.3) / 0.3;
            for row in [carried, driven] {
                let of = |name: &str| force(&row, &format!("c_arm_{name}"));
                assert_near(
                    of("outer"),
                    [0.0, 0.0, share],
                    &format!("{hub} {from} outer"),
                );
                assert_near(
                    of("inner"),
                    [0.0, 0.0, 1000.0 - share],
                    &format!("{hub} {from} inner"),
                );
                assert_near(of("hub"), [0.0, 0.0, -1000.0], "hub");
            }
        }
    }
}

/// At the joint of knuckle and wishbone one presses on the other; the bushes bear that force, and the bar a moment about
/// their line.
#[test]
fn a_wishbone_on_a_torsion_bar_is_in_equilibrium_with_bushes() {
    let [af, ar, lb] = [[0.3, 0.3, 0.2], [-0.25, 0.28, 0.18], [0.0, 0.7, 0.16]].map(Vector3::from);
    for from in ["af", "ar"] {
        let statements = format!(
            "fixed: af at [0.3, 0.3, 0.2], ar at [-0.25, 0.28, 0.18], uf at [0.15, 0.42, 0.42], ur at [-0.15, 0.42, 0.44];
fixed: rk at [0.12, 0.33, 0.2], mark at [0.0, 0.5, 0.35];
free: lb at [0.0, 0.7, 0.16], ub at [-0.02, 0.66, 0.44], tb at [0.12, 0.67, 0.21], wc at [0.0, 0.75, 0.3];
hinge lower: af, ar -> lb;
hinge upper: uf, ur -> ub;
body knuckle: lb, ub, tb, wc;
link tie: rk -> tb;
drive bump: wc.z;
measure bar: angle(af -> mark, {from} -> lb about ar -> af);
point axle: knuckle at [0.002, 0.62, 0.301];
wheel: axle -> wc;\n"
        );
        let loads = "contact = [0.0, 0.0, 4000.0]\nbump = \"bar\"";
        let row = only(&statements, "bump = 0.3", loads);
        let of = |name: &str| force(&row, &format!("c_{name}"));
        assert!((of("lower_lb") + of("knuckle_lb")).norm() < 1e-8, "{row:?}");
        let bushes = of("lower_af") + of("lower_ar");
        assert!((bushes - of("knuckle_lb")).norm() < 1e-8, "{bushes:?}");
        let moments = [(af, "lower_af"), (ar, "lower_ar"), (lb, "lower_lb")];
        let moment: Vector3<f64> = moments.map(|(at, name)| at.cross(&of(name))).iter().sum();
        let bar = (af - ar).normalize() * row["c_bar_Nm"];
        assert!((moment - bar).norm() < 1e-8, "{moment:?}, the bar {bar:?}");
        // All of the load, with the forces of the upper wishbone and the tie rod.
        let all = bushes + of("upper_uf") + of("upper_ur") + of("knuckle_tb");
        assert!(
            (all - Vector3::new(0.0, 0.0, 4000.0)).norm() < 1e-8,
            "{all:?}"
        );
    }
}

/// The moment depends neither on the zero of its angle nor on the number of turns.
#[test]
fn a_moment_does_not_depend_on_the_turn_of_its_angle() {
    let statements =
        "fixed: a at [0.0, 0.0, 0.3], ahead at [0.2, 0.0, 0.3], mark at [0.0, 0.3, 0.3];
free: p at [0.0, 0.0, 0.5];
hinge arm: a, ahead -> p;
drive turn: angle(a -> mark, a -> p about a -> ahead);\n";
    let mut count = 0;
    for design in [FRAC_PI_2, FRAC_PI_2 - TAU] {
        for turned in [-3.3, -3.0, -1.0, 0.0, 1.0, 3.0, 3.3] {
            let turn = design + turned;
            if turn.abs() > 6.2 {
                continue;
            }
            let drives = format!("turn = {turn:?}\n[design]\nturn = {design:?}");
            let row = only(statements, &drives, "p = [0.0, 10.0, 0.0]");
            // The arm is 0.2 m long.
            let expected = -2.0 * f64::sin(turn);
            let found = row["c_turn_Nm"];
            assert!(
                (found - expected).abs() < 1e-9,
                "{design} {turn}: {found}, not {expected}"
            );
            count += 1;
        }
    }
    assert!(count > 8);
}

const TWO_LINKS: &str = "fixed: a at [0.0, 0.0, 0.3], b at [0.3, 0.5, 0.2];
free: p at [0.05, 0.16, 0.42];
link ap: a -> p;
link bp: b -> p;\n";
const ANGLE: f64 = 0.949_505_195_260_471;

/// The statement that holds the angle of a link bears its moment, and the link the remaining force along it.
#[test]
fn the_force_in_a_link_does_not_depend_on_how_its_angle_is_stated() {
    let marks = "fixed: above at [0.0, 0.0, 0.6], side at [0.16, -0.05, 0.3];\n";
    let angles = [
        ("", "angle(a -> p, z)"),
        (marks, "angle(a -> above, a -> p about side -> a)"),
    ];
    let rows = angles.map(|(marks, angle)| {
        let statements = format!("{TWO_LINKS}{marks}drive turn: {angle};\n");
        only(
            &statements,
            &format!("turn = {ANGLE}"),
            "p = [3.0, 10.0, 4.0]",
        )
    });
    let [from_axis, about] = &rows;
    for (name, found) in from_axis {
        let expected = about[name];
        // A driven angle has unknowns of its own, and differs from the points by rounding.
        assert!(
            (found.abs() - expected.abs()).abs() < 1e-6,
            "{name}: {found}, not {expected}"
        );
    }
    assert!(
        (from_axis["c_ap_N"] - 10.987_6).abs() < 1e-3,
        "{from_axis:?}"
    );
    let [at, end] = [[0.05, 0.16, 0.42], [0.3, 0.5, 0.2]].map(Vector3::from);
    let other = (end - at).normalize() * from_axis["c_bp_N"];
    let sum = force(from_axis, "c_ap_p") + other + Vector3::new(3.0, 10.0, 4.0);
    assert!(sum.norm() < 1e-8, "{sum:?}");
}

/// At both ends of the angle all forces are in equilibrium, including the couple on each line.
#[test]
fn links_at_a_held_angle_are_in_equilibrium() {
    let statements = "fixed: a at [0.0, 0.0, 0.3], b at [0.3, 0.5, 0.2], c at [-0.3, 0.4, 0.25], d at [0.6, 0.1, 0.5];
free: p at [0.05, 0.16, 0.42], q at [0.4, 0.35, 0.5];
link ap: a -> p;
link cp: c -> p;
link bq: b -> q;
link dq: d -> q;
angle held: a -> p, b -> q;
drive up: p.z;\n";
    let row = only(
        statements,
        "up = 0.42",
        "p = [3.0, 10.0, 0.0]\nq = [20.0, -10.0, 50.0]",
    );
    let is_joint_of_angle = |name: &String| name.contains("held") && name.ends_with("_N");
    assert!(!row.keys().any(is_joint_of_angle), "{row:?}");
    let [p, q, c, d] = [
        [0.05, 0.16, 0.42],
        [0.4, 0.35, 0.5],
        [-0.3, 0.4, 0.25],
        [0.6, 0.1, 0.5],
    ]
    .map(Vector3::from);
    let at_q = force(&row, "c_bq_q")
        + (d - q).normalize() * row["c_dq_N"]
        + Vector3::new(20.0, -10.0, 50.0);
    assert!(at_q.norm() < 1e-8, "{at_q:?}");
    // The drive holds the height.
    let at_p =
        force(&row, "c_ap_p") + (c - p).normalize() * row["c_cp_N"] + Vector3::new(3.0, 10.0, 0.0);
    assert!(
        at_p.xy().norm() < 1e-8 && (at_p.z - row["c_up_N"]).abs() < 1e-8,
        "{at_p:?} {row:?}"
    );
}

/// A line between two chassis points belongs to the chassis, even if a hinge has these points too.
#[test]
fn a_moment_between_chassis_and_arm_loads_no_other_arm() {
    let row = |line: &str, marks: &str| {
        let statements = format!(
            "fixed: af at [0.2, 0.35, 0.16], ar at [-0.2, 0.30, 0.18], uf at [0.15, 0.42, 0.42], ur at [-0.15, 0.40, 0.44];
{marks}free: lb at [0.0, 0.7, 0.17], ub at [-0.015, 0.66, 0.44];
hinge lower: af, ar -> lb;
hinge upper: uf, ur -> ub;
link upright: lb -> ub;
drive bump: lb.z;
measure held: angle({line}, uf -> ub);\n"
        );
        only(&statements, "bump = 0.17", "held = 1000.0")
    };
    let marks = "fixed: m at [-0.2, 0.1, 0.5], n at [0.2, 0.15, 0.48];\n";
    let (own, others) = (row("ar -> af", ""), row("m -> n", marks));
    assert!(own["c_bump_N"].abs() > 10.0);
    for (name, found) in &own {
        assert!(
            (found - others[name]).abs() < 1e-8,
            "{name}: {found}, {}",
            others[name]
        );
    }
}

/// A link that is the axis of a driven angle has the same force as one that is the axis of a measured angle with the same
/// moment.
#[test]
fn an_axis_link_has_the_same_force_for_driven_and_measured_angles() {
    let statements = |angle: &str| {
        format!(
            "fixed: e at [0.0, 0.0, 0.3], n at [0.2, 0.0, 0.35], g at [0.3, 0.45, 0.1];
free: f at [0.0, 0.4, 0.32], a at [0.15, 0.15, 0.55];
link ef: e -> f;
link gf: g -> f;
link ea: e -> a;
link fa: f -> a;
drive up: f.z;
{angle}"
        )
    };
    let turn = "turn = -0.7716000579382774";
    let load = "a = [10.0, 100.0, 50.0]";
    let driven = |line: &str| {
        let drive = format!("drive turn: angle(e -> n, {line} about e -> f);\n");
        only(&statements(&drive), &format!("up = 0.32\n{turn}"), load)
    };
    let (from_e, from_f) = (driven("e -> a"), driven("f -> a"));
    for link in ["ef", "gf", "ea", "fa"] {
        let [e, f] = [&from_e, &from_f].map(|row| row[&format!("c_{link}_N")]);
        assert!((e - f).abs() < 1e-7, "{link}: {e}, {f}");
    }
    // By virtual work.
    assert!((from_e["c_ef_N"] - 54.064).abs() < 1e-3, "{from_e:?}");
}

/// An arm on a moving body, pressed midway between both points that they share: each bears half.
#[test]
fn moments_on_an_axis_between_two_bodies_are_equal_and_opposite() {
    let statements = "fixed: f1 at [0.3, 0.3, 0.2], f2 at [-0.3, 0.3, 0.2];
free: e at [0.0, 0.6, 0.2], f at [0.0, 0.6, 0.5], n at [0.2, 0.5, 0.2], a at [0.15, 0.65, 0.35];
hinge car: f1, f2 -> e, f, n;
body arm: e, f, a;
drive up: n.z;
drive turn: angle(e -> n, e -> a about e -> f);\n";
    let row = only(
        statements,
        "up = 0.2\nturn = 0.7853981633974483",
        "a = [0.0, 100.0, 0.0]",
    );
    let of = |name: &str| force(&row, &format!("c_{name}"));
    for end in ["e", "f"] {
        let [car, arm] = ["car", "arm"].map(|body| of(&format!("{body}_{end}")));
        assert!((car + arm).norm() < 1e-8, "{end}: {car:?} {arm:?}");
        assert!(
            (arm.y - 50.0).abs() < 1e-8 && arm.x.abs() < 1e-8,
            "{end}: {arm:?}"
        );
    }
}

/// A T-bar whose twist is measured from its foot's own hinge line, or from another line of the chassis: the load on the
/// chassis there is no load on the foot, which tilts about that line and carries the stem.
#[test]
fn a_foot_that_carries_an_axis_is_in_equilibrium_with_a_chassis_line() {
    let rows = ["side -> low", "low -> side", "low -> out", "out -> side"].map(|line| {
        let statements = format!(
            "fixed: side at [0.0, 0.1, 0.2], low at [0.0, 0.0, 0.2], out at [0.05, 0.2, 0.25];
free: top at [0.1, 0.0, 0.5], tip at [0.05, 0.2, 0.5], other at [0.05, -0.2, 0.5];
hinge foot: low, side -> top;
body cross: low, top, tip, other;
drive tilt: top.x;
drive turn: tip.x;
measure from_out: length(out -> top);
measure twist: angle({line}, other -> tip about low -> top);\n"
        );
        let drives = "tilt = 0.12\nturn = 0.08";
        (line, only(&statements, drives, "twist = 20.0"))
    });
    for (line, row) in &rows {
        let of = |name: &str| force(row, &format!("c_{name}"));
        let [low, side, top] = ["foot_low", "foot_side", "foot_top"].map(of);
        let sum = low + side + top;
        assert!(sum.norm() < 1e-8, "{line}: {sum:?} {row:?}");
        // The drive holds the head of the stem along x.
        let at_top = top + of("cross_top");
        assert!(at_top.yz().norm() < 1e-8, "{line}: {at_top:?} {row:?}");
        assert!((at_top.x - row["c_tilt_N"]).abs() < 1e-8, "{line} {row:?}");
        if line.contains("out") {
            continue; // Such a line is oblique to the stem: tilting the foot changes the angle.
        }
        let moments = Vector3::new(0.0, 0.1, 0.0).cross(&side) + stem().cross(&top);
        assert!(moments.norm() < 1e-8, "{line}: {moments:?} {row:?}");
    }
}

/// Returns the vector from the foot to the head of the stem.
fn stem() -> Vector3<f64> {
    Vector3::new(0.12, 0.0, (0.1_f64 - 0.12 * 0.12).sqrt())
}

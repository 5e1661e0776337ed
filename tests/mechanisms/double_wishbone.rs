//! A double wishbone with rack steering against the results of Adams/Car in kinematic mode.
//!
//! The published data are not part of this repository: `SUSPENSION_PUBLISHED_DATA` names the
//! folder that holds them.

use std::io::Write;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;
use suspension_core::wheel::{camber_to_ground, toe};
use suspension_core::{Build, HasWheel, Inputs, Linkage, Motion, Signal, Tracker};

use super::checks;

suspension_core::linkage! {
    /// Double wishbone. Axes as ISO 8855.
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

use double_wishbone::{Drives, Model, Points};

/// Points of about the size of a passenger car's, metres.
fn design() -> Points<f64> {
    Points {
        lower_front: Vector3::new(0.15, 0.40, 0.18),
        lower_rear: Vector3::new(-0.20, 0.42, 0.19),
        upper_front: Vector3::new(0.10, 0.45, 0.55),
        upper_rear: Vector3::new(-0.15, 0.48, 0.56),
        rack: Vector3::new(-0.16, 0.38, 0.30),
        lower_ball: Vector3::new(0.01, 0.75, 0.15),
        upper_ball: Vector3::new(-0.02, 0.68, 0.56),
        tie_ball: Vector3::new(-0.14, 0.74, 0.31),
        axle_inner: Vector3::new(0.0, 0.66, 0.33),
        axle_outer: Vector3::new(0.0, 0.76, 0.33),
    }
}

#[test]
fn derivatives_and_motion_with_a_steering_rack() {
    let model = Model::new(&design()).expect("a double wishbone");
    checks::derivatives(&model, &design());
    let drives = |t| checks::swinging(model.drives_at(&design()), 0.02, t);
    checks::motion(&model, &design(), |t| Inputs::still(drives(t)));
    let heaving = |t| Inputs {
        chassis: checks::heaving(model.fixed(), 0.01, t),
        drives: drives(t),
    };
    checks::motion(&model, &design(), heaving);
}

#[derive(Clone, Copy, Debug)]
enum Side {
    Left,
    Right,
}

/// The file's axes, x rearward and y to the right, as ISO 8855 has them; and the other way.
fn half_turn(v: Vector3<f64>) -> Vector3<f64> {
    Vector3::new(-v.x, -v.y, v.z)
}

/// The hardpoints of `adams_dw_tr_front.toml`, mm, in the axes of ISO 8855.
fn adams(file: &Path, side: Side) -> Points<f64> {
    let text = std::fs::read_to_string(file).unwrap_or_else(|e| panic!("{}: {e}", file.display()));
    let table: toml::Table = text.parse().expect("valid TOML");
    let point = |name: &str| {
        let entries = table["left"][name].as_array().expect("three numbers");
        let number = |x: &toml::Value| x.as_float().expect("a number");
        let left = half_turn(Vector3::from_iterator(entries.iter().map(number)));
        match side {
            Side::Left => left,
            Side::Right => Vector3::new(left.x, -left.y, left.z),
        }
    };
    let centre = point("wheel_center");
    // Toe and camber are zero in the design.
    let outboard = Vector3::new(0.0, 100.0 * centre.y.signum(), 0.0);
    Points {
        lower_front: point("lca_front"),
        lower_rear: point("lca_rear"),
        upper_front: point("uca_front"),
        upper_rear: point("uca_rear"),
        rack: point("tierod_inner"),
        lower_ball: point("lca_outer"),
        upper_ball: point("uca_outer"),
        tie_ball: point("tierod_outer"),
        axle_inner: centre - outboard,
        axle_outer: centre,
    }
}

/// Differences from a row of the results: wheel centre in mm, then toe and camber in degrees.
fn differences(
    model: &Model<f64>,
    design: &Points<f64>,
    side: Side,
    row: impl Fn(&str) -> f64,
) -> [f64; 3] {
    let drives = Drives {
        bump: design.axle_outer.z + row("wheel_travel_mm"),
        steer: design.rack.y - row("rack_mm"),
    };
    let points = checks::solve(model, design, drives);
    let [inner, centre] = points.wheel();
    let axis = centre - inner;
    let prefix = format!("{side:?}").to_lowercase();
    let published = |what: &str| row(&format!("{prefix}_{what}"));
    let wheel_centre = Vector3::from(["wc_x_mm", "wc_y_mm", "wc_z_mm"].map(published));
    [
        (half_turn(centre) - wheel_centre).amax(),
        (toe(&axis).to_degrees() - published("toe_deg")).abs(),
        (camber_to_ground(&axis).to_degrees() - published("camber_deg")).abs(),
    ]
}

#[test]
fn agrees_with_adams_car() {
    const ENVIRONMENT: &str = "SUSPENSION_PUBLISHED_DATA";
    // Of the published design position, from the initial assembly.
    const OFFSET_MM: f64 = 1e-7;
    let Some(folder) = std::env::var_os(ENVIRONMENT).map(PathBuf::from) else {
        let skipped = "SKIPPED agrees_with_adams_car";
        // The test harness captures what eprintln! writes, but not this.
        writeln!(
            std::io::stderr(),
            "{skipped}: {ENVIRONMENT} does not name the data's folder"
        )
        .expect("standard error");
        return;
    };
    let results = folder.join("adams_dw_tr_front_results.csv");
    let mut reader = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .from_path(&results)
        .unwrap_or_else(|e| panic!("{}: {e}", results.display()));
    let rows: Vec<std::collections::BTreeMap<String, f64>> = reader
        .deserialize()
        .collect::<Result<_, _>>()
        .expect("numbers under a header");
    assert_eq!(rows.len(), 9);
    let mut worst = [0.0_f64; 3];
    for side in [Side::Left, Side::Right] {
        let design = adams(&folder.join("adams_dw_tr_front.toml"), side);
        let model = Model::new(&design).expect("a double wishbone");
        for row in &rows {
            let off = differences(&model, &design, side, |column| row[column]);
            for (worst, off) in worst.iter_mut().zip(off) {
                *worst = worst.max(off);
            }
        }
    }
    println!("largest difference: {worst:?} in mm, deg, deg");
    let [centre, toe, camber] = worst;
    assert!(
        centre < 1e-6 + OFFSET_MM,
        "wheel centre off by {centre:e} mm"
    );
    assert!(
        toe < 2e-6 && camber < 2e-6,
        "toe, camber off by {toe:e}, {camber:e} deg"
    );
}

/// Bump and steer that swing near a singularity of the linkage: one call over the whole time, as
/// many small ones, or none at all, but never another assembly.
#[test]
fn a_long_way_past_singularities_stays_in_the_assembly() {
    let at = Vector3::new;
    let design = Points {
        lower_front: at(0.20, 0.35, 0.16),
        lower_rear: at(-0.20, 0.35, 0.16),
        upper_front: at(0.15, 0.42, 0.42),
        upper_rear: at(-0.15, 0.42, 0.42),
        rack: at(0.11, 0.34, 0.20),
        lower_ball: at(0.005, 0.70, 0.17),
        upper_ball: at(-0.015, 0.66, 0.44),
        tie_ball: at(0.12, 0.68, 0.21),
        axle_inner: at(0.0, 0.65, 0.30),
        axle_outer: at(0.0, 0.75, 0.30),
    };
    let model = Model::new(&design).expect("a geometry");
    let start = model.drives_at(&design);
    let phase: f64 = 3941.0 * 0.37;
    let inputs = |t: f64| {
        let (bump, steer) = (0.1358, 0.0679);
        let swing = 3.0 * t + phase;
        Inputs::still(Signal {
            value: Drives {
                bump: start.bump + bump * (swing.sin() - phase.sin()),
                steer: start.steer + steer * (2.1 * t).sin(),
            },
            rate: Drives {
                bump: 3.0 * bump * swing.cos(),
                steer: 2.1 * steer * (2.1 * t).cos(),
            },
            second_rate: Drives {
                bump: -9.0 * bump * swing.sin(),
                steer: -4.41 * steer * (2.1 * t).sin(),
            },
        })
    };
    let tracker = Tracker {
        max_steps: 100_000,
        ..Tracker::default()
    };
    let travel = |calls: u32| {
        let mut motion = Motion::at_rest(model.unknowns(&design));
        let end = |call: u32| 17.1 * f64::from(call) / f64::from(calls);
        (0..calls)
            .try_for_each(|call| {
                let advanced =
                    tracker.advance(&model, inputs, end(call), end(call + 1), &mut motion);
                advanced.map(drop)
            })
            .map(|()| motion.position)
    };
    let expected = travel(1710).expect("small steps pass");
    for calls in [1, 10, 100] {
        if let Ok(position) = travel(calls) {
            let difference = (position - expected).amax();
            assert!(difference < 1e-9, "{calls} calls: {difference:e} m");
        }
    }
}

//! Motion files of a user's own linkage, whose drives are coordinates (the catalogue has no such linkage): the same results far
//! from the origin.

use std::sync::atomic::AtomicBool;

use std::ops::ControlFlow;

use suspension::bake::source::Table;
use suspension::bake::{Continuity, RequestedPoints};
use suspension::commands::assemblies::search::{self, list};
use suspension::commands::bake::baking::{Baking, RequestedDrive, Variables};
use suspension::file::Source;
use suspension::mechanism::{Mechanism, State};
use suspension::prepare::load_own;
use suspension::quantities::{catalogue, columns};
use suspension::reach::meeting;
use suspension::reach::range;
use suspension::sensitivities::{Change, coordinates, sensitivities};
use suspension_core::linkage;

linkage! {
    mod double_wishbone {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free: lower_ball at [0.005, 0.70, 0.17], upper_ball at [-0.015, 0.66, 0.44],
              tie_ball at [0.12, 0.68, 0.21];
        link lower_fore: lower_front -> lower_ball;
        link lower_aft: lower_rear -> lower_ball;
        link upper_fore: upper_front -> upper_ball;
        link upper_aft: upper_rear -> upper_ball;
        link tie_rod: rack -> tie_ball;
        body upright: lower_ball, upper_ball, tie_ball;
        drive bump: lower_ball.z;
        drive steer: rack.y;
        point axle_inner: upright;
        point axle_outer: upright;
        wheel: axle_inner -> axle_outer;
        kingpin: lower_ball -> upper_ball;
    }
}

const DESIGN: [(&str, [f64; 3]); 10] = [
    ("lower_front", [0.20, 0.35, 0.16]),
    ("lower_rear", [-0.20, 0.35, 0.16]),
    ("upper_front", [0.15, 0.42, 0.42]),
    ("upper_rear", [-0.15, 0.42, 0.42]),
    ("rack", [0.11, 0.34, 0.20]),
    ("lower_ball", [0.005, 0.70, 0.17]),
    ("upper_ball", [-0.015, 0.66, 0.44]),
    ("tie_ball", [0.12, 0.68, 0.21]),
    ("axle_inner", [0.0, 0.65, 0.30]),
    ("axle_outer", [0.0, 0.75, 0.30]),
];

/// Far enough for coordinates to lose four digits, a whole number so that nothing else is lost.
const AWAY: [f64; 3] = [4096.0, -2048.0, 1024.0];

/// The tolerance that rounding leaves for a comparison over that distance.
const TOLERANCE: f64 = 1e-9;

/// A motion file of the mechanism, all coordinates with `away` more.
fn file(away: [f64; 3]) -> String {
    let [_, y, z] = away;
    let points = DESIGN.map(|(name, at)| {
        let at: Vec<f64> = at.iter().zip(away).map(|(x, away)| x + away).collect();
        format!("{name} = {at:?}\n")
    });
    let [bump, steer] = [0.18 + z, 0.34 + y];
    format!(
        "linkage = \"double_wishbone\"\nunit = \"m\"\n[points]\n{}\n[time]\ninstants = [0.0, 0.5, \
         1.0]\n[drives]\nbump = [{bump:?}, 0.05]\nsteer = [{steer:?}]\n",
        points.concat()
    )
}

type Wishbone = Mechanism<double_wishbone::Model<f64>, 9>;

fn mechanism(away: [f64; 3]) -> Wishbone {
    let source = Source::new("a.toml", file(away));
    load_own("double_wishbone", &source).expect("a mechanism")
}

/// By how much a column is more in coordinates with [`AWAY`] more.
fn shift(column: &str) -> f64 {
    let [x, y, z] = AWAY;
    match column {
        "bump_m" => z,
        "steer_m" => y,
        _ if column.starts_with("omega_") || column.starts_with("alpha_") => 0.0,
        _ if column.ends_with("_x") => x,
        _ if column.ends_with("_y") => y,
        _ if column.ends_with("_z") => z,
        _ => 0.0,
    }
}

fn assert_shifted(mechanism: &Wishbone, home: &State, away: &State) {
    for column in columns(catalogue(), &mechanism.names) {
        let name = match column.name.as_str() {
            "centre" => continue, // the marker `axle_outer`
            _ => column.csv_name(mechanism.unit),
        };
        let [home, away] = [home, away].map(|state| column.value(state));
        let off = away - shift(&name) - home;
        let is_count = name == "iterations";
        assert!(is_count || off.abs() < TOLERANCE, "{name}: {home} {away}");
    }
}

fn states(mechanism: &Wishbone) -> Vec<State> {
    let mut states = Vec::new();
    let swept = mechanism.move_through(&mechanism.instants, &mut |state| {
        states.push(state);
        Ok(ControlFlow::Continue(()))
    });
    swept.expect("kept");
    states
}

#[test]
fn a_motion_file_for_another_linkage_is_refused() {
    let other = file([0.0; 3]).replace("double_wishbone", "five_link");
    let source = Source::new("a.toml", other);
    let loaded = load_own::<double_wishbone::Model<f64>, 9>("double_wishbone", &source);
    let refused = loaded.expect_err("a refusal").to_string();
    assert_eq!(
        refused,
        "a.toml:1:11: unknown linkage `five_link`; known are double_wishbone"
    );
}

#[test]
fn a_motion_far_from_the_origin_is_only_shifted() {
    let [home, away] = [[0.0; 3], AWAY].map(mechanism);
    let [near, far] = [&home, &away].map(states);
    assert_eq!([near.len(), far.len()], [3; 2]);
    for (near, far) in near.iter().zip(&far) {
        assert_shifted(&home, near, far);
    }
    let names = home.names.drive_names();
    let bump = names.iter().position(|name| *name == "bump");
    assert_eq!(near[0].drives[bump.expect("a drive")], 0.18);
}

#[test]
fn ranges_far_from_the_origin_are_only_shifted() {
    let [home, away] = [[0.0; 3], AWAY].map(mechanism);
    let [near, far] = [&home, &away].map(|mechanism| {
        [0, 1].map(|drive| range(mechanism, drive, &false.into()).expect("a curve"))
    });
    for (near, far) in near.iter().zip(&far) {
        let shift = shift(&format!("{}_m", near.name));
        assert!((far.start - shift - near.start).abs() < TOLERANCE);
        for (end, moved) in near.ends.iter().zip(&far.ends) {
            assert!((moved.value - shift - end.value).abs() < TOLERANCE);
        }
        let stations = [&near.usable, &far.usable].map(|stations| &stations[1]);
        let [first, moved] = stations.map(|station| station.value());
        assert!((moved - shift - first).abs() < 1e-6, "{first} {moved}");
    }
    let met = [(&home, 0.0), (&away, AWAY[2])].map(|(mechanism, shift)| {
        let ends = [0.15, 0.25].map(|end| end + shift);
        let met = meeting(mechanism, 0, ends);
        met.expect("bump goes on growing")
    });
    assert_eq!(met.map(|(_, end)| end), [1, 1]);
    for (t, _) in met {
        assert!((t - 1.4).abs() < TOLERANCE, "{t}");
    }
}

#[test]
fn a_baked_curve_far_from_the_origin_is_only_shifted() {
    let [near, far] = [[0.0; 3], AWAY].map(|away| {
        let baking = Baking {
            file: "a.toml",
            mechanism: &mechanism(away),
            variables: Variables::Drives(vec![RequestedDrive {
                drive: Some("bump".to_owned()),
                range: [None, Some(0.25 + away[2])],
            }]),
            tolerance: 1e-6,
            continuity: Continuity::Velocity,
            points: RequestedPoints::Wheel(0),
            interrupted: &AtomicBool::new(false),
        };
        let sheet = baking.execute().expect("a curve");
        match sheet.baked {
            Table::Curve(baked) => (sheet.about, baked),
            Table::Surface(_) => panic!("of one drive a curve"),
        }
    });
    let [(_, near), (about, far)] = [near, far];
    assert_eq!(near.wanted.range, [0.18, 0.25]);
    assert_eq!(far.wanted.range, [0.18, 0.25].map(|end| end + AWAY[2]));
    assert_eq!(about.held, "steer = -2047.66 m");
    let constants = [near, far].map(|baked| baked.segments[0][0][0]);
    for (axis, away) in AWAY.iter().enumerate() {
        assert!((constants[1][axis] - away - constants[0][axis]).abs() < TOLERANCE);
    }
}

#[test]
fn assemblies_far_from_the_origin_are_only_shifted() {
    let [near, far] = [[0.0; 3], AWAY].map(|away| {
        let request = search::Request {
            drive: Some("bump".to_owned()),
            at: vec![0.2 + away[2]],
        };
        let mut listed = Vec::new();
        let mut keep = |at: &search::Listed| {
            listed.push(at.clone());
            Ok(())
        };
        let result = list(
            &mechanism(away),
            "a.toml",
            &request,
            &false.into(),
            &mut keep,
        );
        result.expect("assemblies");
        listed.remove(0)
    });
    assert_eq!(near.drives_in_words, "bump = 0.2 m, steer = 0.34 m");
    assert_eq!(far.drives_in_words, "bump = 1024.2 m, steer = -2047.66 m");
    assert_eq!(near.assemblies.len(), far.assemblies.len());
    let [first, moved] = [&near, &far].map(|listed| &listed.assemblies[0].state);
    for point in 5..10 {
        let off = moved.position(point) - first.position(point);
        for (off, away) in off.iter().zip(AWAY) {
            assert!((off - away).abs() < TOLERANCE, "point {point}: {off}");
        }
    }
}

/// A mechanism moved as a whole has the same kinematics.
#[test]
fn sensitivities_to_x_of_all_points_sum_to_zero() {
    let mechanism = mechanism([0.0; 3]);
    let points = 0..DESIGN.len();
    let changes = points.flat_map(|point| coordinates(&mechanism, point, &[]));
    let along_x: Vec<Change> = changes
        .filter(|change| change.name.ends_with(".x"))
        .collect();
    let found = sensitivities(&mechanism, &along_x, &false.into(), || ());
    let found = found.expect("sensitivities");
    let mut checked = 0;
    for (place, column) in found.columns.iter().enumerate() {
        for number in (0..3).filter(|_| column.axis.is_none()) {
            let all = found.each.iter().map(|each| each.of[(place, number)]);
            let largest = all
                .clone()
                .fold(0.0_f64, |largest, by| largest.max(by.abs()));
            let sum: f64 = all.sum();
            let name = column.title();
            assert!(
                sum.is_nan() || sum.abs() <= 1e-7 * largest + 1e-9,
                "{name}: {sum:e} of {largest}"
            );
            checked += usize::from(sum.is_finite() && largest > 1e-3);
        }
    }
    assert!(checked > 5, "{checked}");
}

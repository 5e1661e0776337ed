//! A linkage that states neither wheel nor kingpin: every command works, and missing quantities have no columns.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use suspension::bake::{Continuity, RequestedPoints};
use suspension::commands::assemblies::search::{self, list};
use suspension::commands::bake::baking::{Baking, RequestedDrive, Variables};
use suspension::file::Source;
use suspension::kinematics::Kinematics;
use suspension::output::motion::plots::{draw, height_and_angles};
use suspension::output::motion::record::record;
use suspension::output::motion::summary;
use suspension::output::rows::TableTargets;
use suspension::output::svg_folder::SvgFolder;
use suspension::output::target::Target;
use suspension::prepare::load;

/// A point on two links, its height driven.
const FILE: &str = "\
statements = '''
fixed: left, right;
free:  top;
link one: left -> top;
link two: right -> top;
drive height: top.z;
'''
unit = \"m\"
[points]
left = [-3.0, 0.0, 0.0]
right = [3.0, 0.0, 0.0]
top = [0.0, 4.0, 0.0]
[time]
start = 0.0
stop = 1.0
step = 0.25
[drives]
height = [0.0, 2.0]
";

fn with_mechanism<R>(work: impl FnOnce(&dyn Kinematics) -> R) -> R {
    let source = Source::new("a.toml", FILE);
    let loaded = load(&source).expect("a listing");
    work(&*loaded.at_first_instant().expect("a mechanism"))
}

#[test]
fn a_motion_without_a_wheel_has_columns_of_points_alone() {
    with_mechanism(has_columns_of_points_alone);
}

fn has_columns_of_points_alone(mechanism: &dyn Kinematics) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.csv");
    let tables = TableTargets {
        csv: Some(Target::File(path.clone())),
        ..TableTargets::default()
    };
    let never = AtomicBool::new(false);
    let outcome = record(mechanism, &mechanism.instants, &tables, 12, &never);
    let outcome = outcome.expect("a table");
    let table = std::fs::read_to_string(path).expect("a table");
    assert_eq!(
        table.lines().next(),
        Some(
            "t_s,height_m,top_x,top_y,top_z,top_vx,top_vy,top_vz,top_ax,top_ay,top_az,iterations,\
             residual_m"
        )
    );
    assert_eq!(table.lines().count(), 6);
    assert!(!table.contains("NaN"), "{table}");
    let text = summary::text(mechanism, &outcome);
    assert!(
        text.contains("  height\n") && !text.contains("camber"),
        "{text}"
    );
    let plots = SvgFolder::new(folder.path(), Path::new("a.toml"));
    let written = draw(mechanism, &outcome, &plots, height_and_angles).expect("no plots");
    assert_eq!(written, [] as [&Path; 0], "there is nothing to draw");
}

#[test]
fn range_and_assemblies_work_without_a_wheel() {
    with_mechanism(has_ends_and_assemblies);
}

fn has_ends_and_assemblies(mechanism: &dyn Kinematics) {
    let found = mechanism.range(0, &false.into()).expect("a curve");
    for (end, expected) in found.ends.iter().zip([-4.0, 4.0]) {
        assert!((end.value - expected).abs() < 1e-9, "{end:?}");
    }
    let mut assemblies = 0;
    let listed = list(
        mechanism,
        "a.toml",
        &search::Request::default(),
        &false.into(),
        &mut |listed| {
            assemblies = listed.assemblies.len();
            Ok(())
        },
    );
    listed.expect("assemblies");
    assert_eq!(assemblies, 2);
}

#[test]
fn without_a_wheel_points_are_baked_and_a_wheel_is_refused() {
    with_mechanism(bakes_points_alone);
}

fn bakes_points_alone(mechanism: &dyn Kinematics) {
    let baked = |points| {
        Baking {
            file: "a.toml",
            mechanism,
            variables: Variables::Drives(vec![RequestedDrive::default()]),
            tolerance: 1e-6,
            continuity: Continuity::Velocity,
            points,
            interrupted: &AtomicBool::new(false),
        }
        .execute()
    };
    let points = baked(RequestedPoints::AllPoints).expect("a curve");
    assert_eq!(points.subject(), "points_by_height");
    let refused = baked(RequestedPoints::Wheel(0))
        .expect_err("no wheel")
        .to_string();
    assert_eq!(
        refused,
        "a.toml: the linkage has no wheel to bake; --points all bakes its points"
    );
}

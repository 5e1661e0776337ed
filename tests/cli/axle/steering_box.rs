//! A steering box: the angle of its pitman arm steers.

use super::steering_wheel::{check, check_refused};
use super::{assert_near, folder, run, table, text};

/// The double wishbone, its tie rod on the arm of a steering box, as the page of layouts has it.
fn on_a_steering_box(vehicle: &str) -> String {
    let listing = include_str!("../../../suspension-core/src/linkages/double_wishbone.linkage");
    let listing = ["fixed: rack at [0.11, 0.34, 0.20];", "drive steer: rack.y;"]
        .into_iter()
        .fold(listing.to_owned(), |listing, replaced| {
            assert!(listing.contains(replaced), "{replaced}");
            listing.replace(replaced, "")
        });
    let page = include_str!("../../../docs/layouts.md");
    let statements = page.split("```text\n").nth(1);
    let statements = statements.and_then(|block| block.split("```").next());
    format!(
        "statements = '''{listing}\n{}'''\n\
         unit = \"m\"\nangle = \"deg\"\n[vehicle]\n{vehicle}\n[time]\ninstants = [0.0]\n\
         [drives]\nbump = 0.3\nsteer = 90.0\n",
        statements.expect("a block")
    )
}

/// The same with the angle about the arm's axis that the documentation shows, zero at the design position, where the end of
/// the arm is at `straight`.
fn on_an_arm_that_passes_the_axis(vehicle: &str) -> String {
    let page = include_str!("../../../docs/layouts.md");
    let angle = page
        .lines()
        .find_map(|line| line.strip_prefix("`angle(pitman_low -> straight"));
    let angle = angle
        .and_then(|line| line.strip_suffix("`."))
        .expect("the angle");
    on_a_steering_box(vehicle)
        .replace(
            "drive steer: angle(pitman_low -> rack, y);",
            &format!("fixed: straight at [0.11, 0.34, 0.20];\ndrive steer: angle(pitman_low -> straight{angle};"),
        )
        .replace("steer = 90.0", "steer = 0.0")
}

/// The line that a steering ratio needs is that of the drive's kind: an angle of the arm has no rack.
#[test]
fn a_missing_steering_ratio_names_the_line_steering_box_ratio() {
    let folder = folder();
    let file = on_a_steering_box("wheel_radius = 0.3");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    for quantity in ["steering_ratio", "steering_wheel_angle"] {
        let output = run(
            folder.path(),
            &["sensitivities", "a.toml", "--of", quantity],
        );
        let expected = format!(
            "a.toml: there is no `{quantity}` of this mechanism: it needs steering_box_ratio under [vehicle], see suspension motion --help\n"
        );
        assert_eq!(text(&output.stderr), expected);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
    }
}

#[test]
fn a_length_and_an_angle_do_not_move_together() {
    let folder = folder();
    let file = on_a_steering_box("wheel_radius = 0.3");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(
        folder.path(),
        &["sweep", "a.toml", "--drive", "bump,steer=0:0.01:2"],
    );
    let expected = "a.toml: the drive `bump` is a length and `steer` an angle, so that they cannot move by the same number; state each by itself\n";
    assert_eq!(text(&output.stderr), expected);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
}

/// Values that are no angles of the arm: metres of a rack, or a change from the design position.
#[test]
fn steering_box_angles_that_count_from_the_design_are_noted() {
    let vehicle = "steering_box_ratio = 16.0";
    let steered = |value: &str| {
        on_a_steering_box(vehicle).replace("steer = 90.0", &format!("steer = {value}"))
    };
    let own = "a.toml: [drives]: `steer` takes the drive's own value, not a change from the design position: `steer` is 90 deg at the \
               design position; write steer = [90, ...]";
    let change = "note: a.toml: --drive: `steer` takes a change from the design position, not the drive's own value: `steer` is 90 deg \
                  at the design position; use --absolute to state its own values";
    let sweep = |value| ["sweep", "a.toml", "--csv", "-", "--drive", value];
    for (file, arguments, expected) in [
        (steered("0.34"), &["motion", "a.toml"][..], Some(own)),
        (steered("0.0"), &["motion", "a.toml"], Some(own)),
        (steered("0.0"), &["check", "a.toml"], Some(own)),
        (steered("[80.0, 10.0]"), &["motion", "a.toml"], None),
        (steered("90.0"), &sweep("steer=90"), Some(change)),
        (steered("90.0"), &sweep("steer=-10:10:3"), None),
        (
            steered("90.0"),
            &["bake", "a.toml", "--drive", "steer=-5:5"],
            Some(
                "`steer` is 90 deg at the design position; for that range about the design write --drive steer=85:95",
            ),
        ),
        (
            on_an_arm_that_passes_the_axis(vehicle),
            &["motion", "a.toml"],
            None,
        ),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), &file).expect("written");
        let output = run(folder.path(), arguments);
        let outputs = [&output.stdout, &output.stderr].map(|bytes| text(bytes));
        let outputs = outputs.concat();
        match expected {
            Some(expected) => assert!(outputs.contains(expected), "{arguments:?}: {outputs}"),
            None => assert!(
                !outputs.contains("`steer` takes"),
                "{arguments:?}: {outputs}"
            ),
        }
    }
}

#[test]
fn a_steering_box_has_the_same_quantities_as_a_rack() {
    let names = [
        "steering_wheel_angle_deg",
        "toe_deg",
        "steering_ratio_deg_deg",
    ];
    let ratio = "steering_box_ratio = 16.0";
    for motion in [
        on_a_steering_box(ratio),
        on_an_arm_that_passes_the_axis(ratio),
    ] {
        for arm in [-8.0, 0.0, 6.0] {
            let places = [arm - 0.01, arm, arm + 0.01].map(|arm| {
                let drive = format!("--drive=steer={arm:?}");
                table(&motion, &["sweep", &drive]).remove(0)
            });
            check(&places, names, -1.0);
            assert!(
                [arm, 90.0 + arm].contains(&places[1]["steer_deg"]),
                "as stated"
            );
            // The arm turns away from y, which moves its end to the right, and with it the front of the wheel.
            assert_near(places[1][names[0]], -16.0 * arm, 1e-9, "box");
        }
    }
}

/// Degrees that a conversion to radians and back would change.
#[test]
fn stated_degrees_of_a_drive_are_printed_unchanged_in_tables() {
    let file = on_an_arm_that_passes_the_axis("steering_box_ratio = 16.0");
    let loaded = format!("{file}\n[loads.corner]\nwheel_centre = [0.0, 1000.0, 0.0]\n");
    for stated in [-12.0, -7.5, -3.0, 1.5, 6.0] {
        let file = file.replace("steer = 0.0", &format!("steer = {stated:?}"));
        let drive = format!("--drive=steer={stated:?}");
        for mut rows in [
            table(&file, &["motion"]),
            table(&loaded, &["loads", &drive]),
        ] {
            assert_eq!(rows.remove(0)["steer_deg"], stated);
        }
    }
}

#[test]
fn an_invalid_steering_box_ratio_is_refused() {
    let of_a_rack =
        "rack_per_turn is the travel of a rack, but the drive that steers, `steer`, is an angle";
    for (vehicle, expected) in [
        (
            "steering_box_ratio = 16.0\nrack_per_turn = 0.052",
            of_a_rack,
        ),
        ("rack_per_turn = 0.0", of_a_rack),
        (
            "steering_box_ratio = 0.0",
            "steering_box_ratio is not a positive finite number; write the steering wheel's angle per angle of the pitman arm, for example 16.0",
        ),
    ] {
        check_refused(on_a_steering_box(vehicle), expected);
    }
}

/// CarMaker's rows are per radian of the arm, where those of a rack are per metre.
#[test]
fn the_table_for_carmaker_says_in_which_unit_the_steering_is() {
    let folder = folder();
    let file = on_an_arm_that_passes_the_axis("steering_box_ratio = 16.0");
    std::fs::write(folder.path().join("box.toml"), file).expect("written");
    std::fs::write(
        folder.path().join("rack.toml"),
        super::super::program::CORNER,
    )
    .expect("written");
    for (file, unit) in [("box.toml", "rad"), ("rack.toml", "m")] {
        let output = run(
            folder.path(),
            &["tables", file, "--as", "carmaker", "-o", "-"],
        );
        let expected =
            format!("per m of compression, per {unit} of `steer` that steers to the left");
        assert!(text(&output.stdout).contains(&expected), "{output:?}");
    }
}

//! The page of a suspension.

mod axle;
mod held;
mod over_centre;

use super::program::{CORNER, folder, run, text};

/// The cells of the row of a quantity.
fn cells<'a>(page: &'a str, quantity: &str) -> Vec<&'a str> {
    let begins = format!("<tr class=\"first\"><td>{quantity}</td>");
    let (_, row) = page
        .split_once(&begins)
        .unwrap_or_else(|| panic!("no row {quantity}"));
    let (row, _) = row.split_once("</tr>").expect("a row");
    let cells = row
        .split("</td>")
        .filter_map(|cell| Some(cell.split_once('>')?.1.trim()));
    cells.collect()
}

#[test]
fn the_sheet_has_design_values_derivatives_and_curves() {
    let folder = folder();
    // The page is of the design position, wherever the motion begins.
    let in_rebound = CORNER.replace("bump = 0.3", "bump = [0.25, 0.1]");
    std::fs::write(folder.path().join("a.toml"), in_rebound).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("out/a_sheet.html")).expect("a page");
    // The kingpin falls by 40 mm inboard over 270 mm; the wheel stands upright.
    let kingpin = 0.04_f64.atan2(0.27).to_degrees();
    assert_eq!(
        cells(&page, "kingpin angle")[..2],
        [format!("{kingpin:.5}").as_str(), "deg"]
    );
    assert_eq!(cells(&page, "camber angle")[..2], ["0", "deg"]);
    assert_eq!(
        cells(&page, "wheel centre z")[..6],
        ["0.3", "m", "1", "m/m", "0", "m/m"]
    );
    let of_roll_centre = cells(&page, "height of the roll centre above the ground");
    let per_bump = of_roll_centre[2].parse::<f64>();
    assert!(
        per_bump.is_ok_and(|per_bump| per_bump < -0.5),
        "{of_roll_centre:?}"
    );
    for heading in [
        "Over bump",
        "Over steer",
        "<title>Kinematics of a.toml (double_wishbone_pushrod)</title>",
        "toe angle (bump steer)",
        "camber angle (bump camber)",
        "Its derivative with respect to wheel travel is bump steer. Positive where the front of the wheel points inboard",
        "motion ratio: damper per bump",
        "<code>bar_arm</code>: Turn of the anti-roll bar's arm about the bar, against the line of the wishbones' front bushes.",
        "<code>toe</code>: the angle of the spin axis",
    ] {
        assert!(page.contains(heading), "{heading}");
    }
    assert!(page.matches("<svg").count() > 40, "curves");
    for from_elsewhere in ["src=", "href=", "url(", "@import"] {
        assert!(!page.contains(from_elsewhere), "{from_elsewhere}");
    }
}

/// A quantity that is zero at the design position has curves and no row of numbers, but a definition.
#[test]
fn a_quantity_shown_only_as_a_curve_is_defined_on_the_sheet() {
    let folder = folder();
    let vehicle = "[vehicle]\nrack_per_turn = 0.052";
    let corner =
        include_str!("../../examples/double_wishbone_pushrod.toml").replace("[vehicle]", vehicle);
    std::fs::write(folder.path().join("a.toml"), corner).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = text(&output.stdout);
    for (title, name) in [
        ("angle of the steering wheel", "steering_wheel_angle"),
        ("wheel travel", "wheel_travel"),
        ("recession", "recession"),
        ("change of half track", "half_track_change"),
    ] {
        assert!(cells(page, title).is_empty(), "no numbers of {title}");
        let definition = format!("<code>{name}</code>: ");
        assert_eq!(page.matches(&definition).count(), 1, "{title}");
    }
}

/// 0.3 m are 300 mm, and 0.3 / 0.0254 in.
#[test]
fn the_radius_of_a_wheel_without_one_is_in_the_unit_of_the_file() {
    let arm = |unit: &str| {
        format!(
            "unit = \"{unit}\"\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.0 }}\nstatements = \"\"\"\n\
             fixed: fore at [3, 0, 0], aft at [-2, 0, 0];\nfree: hub at [0, 4, 0], tip at [0, 5, 0];\n\
             hinge arm: fore, aft -> hub, tip;\nwheel: hub -> tip;\ndrive bump: tip.z;\n\"\"\"\n"
        )
    };
    for (unit, radius) in [("m", "0.3 m"), ("mm", "300 mm"), ("in", "11.811 in")] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), arm(unit)).expect("written");
        let output = run(folder.path(), &["sheet", "a.toml", "-o", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let expected = format!("drawn with a radius of {radius}. State it");
        assert!(text(&output.stdout).contains(&expected), "{expected}");
    }
}

/// The rulers of drawings, which a radius beyond all measure makes tiny, end.
#[test]
fn a_sheet_with_an_absurd_wheel_radius_terminates() {
    let folder = folder();
    let file = include_str!("../../examples/double_wishbone_pushrod.toml");
    let radius = file.lines().find(|line| line.starts_with("wheel_radius"));
    let file = file.replacen(radius.expect("a radius"), "wheel_radius = 1e17", 1);
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "a.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

/// The load is too large for the axis of a curve.
#[test]
fn a_sheet_with_an_absurd_spring_load_terminates() {
    let folder = folder();
    let file = "linkage = \"trailing_arm\"
unit = \"m\"
time = { instants = [0.0] }
vehicle = { wheel_radius = 0.3 }
springs.absurd = { along = \"spring\", rate = 1e308, load = 1e308 }
drives.bump = 0.3
";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "a.html"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
}

#[test]
fn a_sheet_over_a_lock_is_written_with_shortened_curves() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let output = run(
        folder.path(),
        &["sheet", "a.toml", "--travel", "-0.2:0.2", "--out", "a.html"],
    );
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains("of 61 places are out of reach"),
        "{message}"
    );
    assert!(
        message.contains("the drive `bump` locks at +0.1375 m from the design"),
        "{message}"
    );
    assert!(
        message.contains(
            "`suspension range a.toml` shows how far each drive reaches and what limits it"
        ),
        "{message}"
    );
    assert!(folder.path().join("a.html").exists());
}

/// A short steering arm locks within the usual 30 mm of the rack. Only a range that is asked for has to be reached.
#[test]
fn a_lock_within_the_usual_range_is_a_note() {
    let folder = folder();
    let file = CORNER.to_owned() + "[points]\ntie_ball = [-0.025, 0.72, 0.2]\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let lock = "the drive `steer` locks at +0.005253 m from the design";
    for (command, options, code, said) in [
        (
            "sheet",
            &[][..],
            0,
            "note: the usual range of steer is longer than its reach",
        ),
        ("sheet", &["--steer", "-0.03:0.03"][..], 3, lock),
        (
            "compare",
            &["a.toml"][..],
            0,
            "note: the usual range of steer is longer than its reach",
        ),
        ("compare", &["a.toml", "--steer", "-0.03:0.03"][..], 3, lock),
    ] {
        let output = run(folder.path(), &[&[command, "a.toml"], options].concat());
        assert_eq!(output.status.code(), Some(code), "{command}: {output:?}");
        let message = text(&output.stderr);
        assert!(
            message.contains(said) && message.contains(lock),
            "{message}"
        );
    }
    run(folder.path(), &["sheet", "a.toml"]);
    let page = std::fs::read_to_string(folder.path().join("out/a_sheet.html")).expect("a page");
    let lock = lock.replace("`steer`", "<code>steer</code>");
    assert!(page.contains("The curves are cut short: ") && page.contains(&lock));
}

#[test]
fn a_sheet_reports_missing_drives_and_wrong_options() {
    let folder = folder();
    let example = super::program::example("attia2003.toml");
    std::fs::write(folder.path().join("a.toml"), example).expect("written");
    for (arguments, expected) in [
        (
            vec!["sheet", "a.toml"],
            "which drive moves the wheel up and down? Write [vehicle] with travel = \"theta\"; the drives are theta",
        ),
        (
            vec!["sheet", "a.toml", "--travel", "1:0"],
            "FROM must be less than TO, as in -0.06:0.06",
        ),
        (
            vec!["sheet", "a.toml", "--out", "a.toml"],
            "--out would overwrite",
        ),
    ] {
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}

#[test]
fn a_travel_range_in_another_unit_is_noted() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    for (travel, expected) in [
        ("-0.03:0.03", None),
        (
            "-0.00008:0.00008",
            Some("note: a.toml: bump is from -8e-5 m to 8e-5 m: is it in another unit?"),
        ),
        (
            "-30:30",
            Some("note: a.toml: bump is from -30 m to 30 m: is it in another unit?"),
        ),
    ] {
        let output = run(folder.path(), &["sheet", "a.toml", "--travel", travel]);
        let messages = text(&output.stderr);
        let note = messages.lines().find(|line| line.starts_with("note: "));
        assert_eq!(note, expected, "{messages}");
    }
}

/// An arm of 0.5 m on the y axis whose hub is the wheel's centre, with a spring upright above the hub: led by the hub's height, by
/// the spring's length or by an angle it has the same bump camber, in degrees per metre that the wheel rises.
#[test]
fn the_sheet_has_derivatives_per_wheel_travel_for_any_drive() {
    let page = |drive: &str, value: f64| {
        let folder = folder();
        let file = format!(
            "unit = \"m\"\nangle = \"deg\"\nstatements = \"\"\"\n\
             fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3], top at [0.0, 0.75, 0.8];\n\
             free: hub at [0.0, 0.8, 0.3];\nhinge arm: front, rear -> hub;\n\
             point axle: arm at [0.0, 0.7, 0.3];\ndrive lift: {drive};\nmeasure spring: length(hub -> top);\nwheel: axle -> hub;\n\"\"\"\n\
             time = {{ instants = [0.0] }}\ndrives.lift = {value:?}\nvehicle.travel = \"lift\"\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        text(&output.stdout).to_owned()
    };
    let column = "per wheel travel (lift)";
    let by_height = page("hub.z", 0.3);
    assert!(!by_height.contains(column), "that is the drive already");
    assert!(!by_height.contains("Over wheel travel"));
    let camber = cells(&by_height, "camber angle")[2..4].to_vec();
    let expected = (-1.0 / 0.5_f64).to_degrees();
    assert_eq!(camber, [format!("{expected:.3}").as_str(), "deg/m"]);
    let length = 0.5_f64.hypot(0.05);
    for (drive, value) in [
        ("length(hub -> top)", length),
        ("angle(front -> hub, z)", 90.0),
    ] {
        let page = page(drive, value);
        for expected in [column, "Over wheel travel (lift", "spring per wheel travel"] {
            assert!(page.contains(expected), "{drive}, {expected}: {page}");
        }
        assert_eq!(cells(&page, "camber angle")[4..6], camber, "{drive}");
        let height = cells(&page, "wheel centre z")[4..6].to_vec();
        assert_eq!(height, ["1", "m/m"], "{drive}");
    }
}

/// A knuckle on a fixed kingpin is steered and does not rise: there is no other drive to name.
#[test]
fn for_a_mechanism_without_travel_other_commands_are_named() {
    let folder = folder();
    let file = "unit = 'm'\ntime = { instants = [0.0] }\ndrives = { steer = 0.3 }\nstatements = '''\n\
                fixed: low at [0.0, 0.7, 0.2], high at [0.0, 0.68, 0.45], rack at [-0.1, 0.3, 0.3];\n\
                free: ball at [-0.1, 0.65, 0.3], wheel_centre at [0.0, 0.78, 0.3];\n\
                hinge knuckle: low, high -> ball, wheel_centre;\npoint hub: knuckle at [0.0, 0.74, 0.3];\n\
                link tie_rod: rack -> ball;\ndrive steer: rack.y;\nwheel: hub -> wheel_centre;\n'''\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "a.toml: the curves need a drive that moves the wheel up and down, and only steering does; if the wheel can rise, add \
                    one to the listing, for example `drive bump: wheel_centre.z;`; `suspension sweep` makes tables over any drive\n";
    assert_eq!(text(&output.stderr), expected);
}

/// In rebound the carrier of this wheel moves parallel in the front view about 40 mm below the design position.
#[test]
fn curves_near_infinity_are_cut_and_named_on_the_sheet() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = text(&output.stdout);
    let (_, over_bump) = page.split_once("<h2>Over bump</h2>").expect("curves");
    let (over_bump, over_steer) = over_bump.split_once("<h2>Over steer</h2>").expect("curves");
    let cut = "<p>Cut where they are near infinity: instant centre in the front view y, instant centre in the front view z, \
               swing arm in the front view, instant centre in the side view x, swing arm in the side view. \
               suspension sweep writes all values.</p>";
    assert!(over_bump.contains(cut), "{over_bump}");
    assert!(!over_bump.contains("Left out"), "{over_bump}");
    let chart = "\nswing arm in the front view\n";
    assert!(over_bump.contains(chart), "a curve on both sides");
    assert!(
        !over_steer.contains("swing arm in the front view,"),
        "{over_steer}"
    );
}

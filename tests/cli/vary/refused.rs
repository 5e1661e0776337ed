//! What cannot be varied, and values with which there is no suspension.

use super::super::program::{folder, text};
use super::{arm, compare_with_sweep, corner, parsed, vary};

#[test]
fn what_cannot_be_varied_is_refused_in_a_sentence() {
    let folder = folder();
    for (arguments, expected) in [
        ("rock.z=0:1:3", "did you mean `rack`?"),
        (
            "rack=0:1:3",
            "`rack` is a point, of which one coordinate moves; write rack.x, rack.y or rack.z",
        ),
        (
            "rack.w=0:1:3",
            "`w` is no axis; write rack.x, rack.y or rack.z",
        ),
        (
            "tie_rood=0:1:3",
            "no link and no move of [tune]; did you mean `tie_rod`?",
        ),
        (
            "damper=0:1:3",
            "a.toml: `damper` is a measure, which follows from the points; what can be varied: the links tie_rod, pushrod, ",
        ),
        (
            "bump=0:1:3",
            "a.toml: `bump` is a drive, which moves the suspension and is no part of its design; what can be varied: the links tie_rod, pushrod, ",
        ),
        (
            "banana=0:1:3",
            "`banana` is no coordinate of a point, no link and no move of [tune]; what can be varied: the links tie_rod, pushrod, ",
        ),
        (
            "banana=0:1:3",
            "; x, y or z of the points lower_front, lower_rear, ",
        ),
        ("rack.z=0:1:1001", "COUNT is 1001; at most 1000 are allowed"),
        (
            "rack.z,rack.z=0:1:3",
            "a.toml: `rack.z` is given twice; remove one",
        ),
        ("rack.z=0:1:0", "COUNT is a whole number, at least 2"),
        ("rack.z=1:1:3", "FROM and TO are the same"),
        ("rack.z=0", "rack.z=0 is the design itself"),
        (
            "rack.z",
            "write NAME=FROM:TO:COUNT, as rack.z=-0.006:0.006:5",
        ),
        ("rack.z=0:x:3", "`x` is not a finite number"),
        (
            "rack.z=0.001 --of foo",
            "a.toml: no quantity begins with `foo`",
        ),
        ("rack.z=0.001 --travel -0.1:0.1", "--html"),
        (
            "rack.z=0.001 --html v --csv v",
            "--html and --csv name the same place",
        ),
        ("rack.z=0.001 --csv a.toml", "--csv"),
    ] {
        let arguments: Vec<&str> = arguments.split(' ').collect();
        let output = vary(folder.path(), &corner(""), &arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {output:?}");
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{arguments:?}: {message}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
    }
}

/// The arm turns about a line along x.
#[test]
fn a_coordinate_that_changes_nothing_is_refused() {
    let folder = folder();
    let output = vary(folder.path(), &arm(""), &["front.x=0.001:0.003:3"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "a.toml: front.x changes no quantity at the design position and no derivative";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    // Curves may change where the design position does not: the page says whether they do.
    let drawn = ["front.x=0.001:0.003:3", "--html", "v.html"];
    let output = vary(
        folder.path(),
        &arm("vehicle = { travel = \"damper\" }\n"),
        &drawn,
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("v.html")).expect("a page");
    assert!(page.contains("Alike for all values to the eye, without a chart"));
}

#[test]
fn values_without_a_suspension_are_named_and_the_others_kept() {
    let folder = folder();
    let arguments = ["tie_rod=-0.7:0.0:3", "--csv", "-"];
    let output = vary(folder.path(), &corner(""), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let values: Vec<f64> = parsed(&output.stdout)
        .iter()
        .map(|(value, _)| *value)
        .collect();
    assert_eq!(values, [0.0]);
    let message = text(&output.stderr);
    let expected = "a.toml: no suspension can be assembled with tie_rod -0.7 and -0.35 m from the design: at -0.7: ";
    assert!(message.contains(expected), "{message}");
    let output = vary(folder.path(), &corner(""), &["tie_rod=-0.7"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let expected = "no suspension can be assembled with tie_rod -0.7 m from the design: a length is not positive";
    assert!(text(&output.stderr).contains(expected), "{output:?}");
}

/// One value has no suspension, the others lock within the travel.
#[test]
fn the_last_message_has_values_without_a_suspension_and_a_lock() {
    let folder = folder();
    let arguments = [
        "tie_rod=-0.7:0.002:2",
        "--travel",
        "-0.05:0.6",
        "--html",
        "v.html",
    ];
    let output = vary(folder.path(), &corner(""), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    for expected in [
        "\na.toml: no suspension can be assembled with tie_rod -0.7 m from the design: ",
        "\na.toml: 43 of 61 places are out of reach",
    ] {
        assert!(message.contains(expected), "{message}");
    }
}

#[test]
fn values_in_another_unit_are_noted() {
    let folder = folder();
    let output = vary(
        folder.path(),
        &corner(""),
        &["rack.z=-6:6:5", "--of", "toe"],
    );
    let message = text(&output.stderr);
    assert!(
        message.contains("rack.z changes from -6 to 6 m, more than the size"),
        "{message}"
    );
    assert!(message.contains("is it in another unit?"), "{message}");
}

/// The top mount of a strut is on the line of the damper, which keeps its place on the knuckle.
#[test]
fn points_that_are_assembled_elsewhere_are_noted() {
    let file = |points: &str| {
        format!(
            "linkage = \"macpherson\"\nunit = \"m\"\nangle = \"deg\"\ntime = {{ instants = [0.0] }}\n\
             vehicle = {{ wheel_radius = 0.31 }}\n{points}[drives]\nbump = 0.31\nsteer = 0.32\n"
        )
    };
    let folder = folder();
    let output = vary(folder.path(), &file(""), &["top.y=0.01", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let expected = "note: a.toml: with top.y 0.01 m the points do not satisfy the listing; the suspension is assembled with ";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
    let (_, numbers) = parsed(&output.stdout).remove(1);
    let moved = file("points = { top = [-0.03, 0.585, 0.83] }\n");
    assert!(compare_with_sweep(&numbers, &moved, "bump") > 60);
}

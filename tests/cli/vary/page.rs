//! The page of charts.

use super::super::program::{folder, text};
use super::{arm, corner, vary};

fn page(file: &str, arguments: &[&str], code: i32) -> (String, String) {
    let folder = folder();
    let output = vary(
        folder.path(),
        file,
        &[arguments, &["--html", "v.html"]].concat(),
    );
    assert_eq!(output.status.code(), Some(code), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("v.html")).expect("a page");
    (page, text(&output.stderr).to_owned())
}

#[test]
fn the_page_has_a_curve_for_each_value_and_names_them() {
    let (page, _) = page(&corner(""), &["rack.z=-0.006:0.006:5", "--of", "toe"], 0);
    for name in [
        "></span>-0.006 m</span>",
        "></span>-0.003 m</span>",
        "></span>design</span>",
        "></span>+0.003 m</span>",
        "border-color: rgb(40,50,190); border-top-style: dashed",
        "border-color: rgb(190,25,40); border-top-style: solid",
        "Over bump",
        "Over steer",
    ] {
        assert!(page.contains(name), "{name}");
    }
    assert_eq!(
        page.matches("<svg").count(),
        1,
        "toe over bump; over steer the curves are alike"
    );
    assert!(page.contains("Alike for all values to the eye, without a chart: toe angle."));
    let black = page
        .rfind("stroke=\"#000000\"")
        .expect("the curve of the design");
    assert!(
        page[..black].contains("stroke=\"#2832BE\""),
        "the lowest is drawn before it"
    );
    // A curve, or its dashes: those of the least value, which is below the design, and of the greatest.
    let lines = |colour| page.matches(&format!("stroke=\"{colour}\"")).count();
    assert!(lines("#2832BE") > 10 && lines("#BE1928") == 1);
}

/// Over a damper's length each wheel travels another way: the page has curves over the travel of the wheel too.
#[test]
fn a_drive_that_is_no_height_has_curves_over_wheel_travel_too() {
    let travels = "vehicle = { travel = \"damper\" }\n";
    let (page, _) = page(&arm(travels), &["top.z=-0.02:0.02:3"], 0);
    for heading in ["Over damper upwards", "Over wheel travel (damper upwards)"] {
        assert!(page.contains(heading), "{heading}");
    }
    let folder = folder();
    let output = vary(folder.path(), &arm(""), &["top.z=0.02", "--html", "v.html"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let expected = "a.toml: which drive moves the wheel up and down?";
    assert!(text(&output.stderr).starts_with(expected), "{output:?}");
}

/// The arm is 50 mm long, the usual travel 60 mm.
#[test]
fn a_usual_range_beyond_the_reach_is_told_once() {
    let short = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.0 }\nstatements = \"\"\"\n\
                 fixed: front at [0.2, 0.0, 0.0], rear at [-0.2, 0.0, 0.0], top at [0.0, 0.02, 0.1];\n\
                 free: tip at [0.0, 0.05, 0.0];\nhinge arm: front, rear -> tip;\npoint hub: arm at [0.0, 0.04, 0.0];\n\
                 wheel: hub -> tip;\ndrive bump: tip.z;\nmeasure spring: length(top -> tip);\n\"\"\"\n";
    let (page, message) = page(short, &["top.z=-0.002:0.002:3"], 0);
    assert_eq!(
        message.matches("note: the usual range of bump").count(),
        1,
        "{message}"
    );
    assert_eq!(page.matches("The curves are cut short: ").count(), 3);
    // Three sentences are folded.
    let folded = "<summary>3 sweeps end before the range does, and their curves too.</summary>";
    assert!(page.contains(folded), "{page}");
    assert!(page.contains("a.toml with top.z 0.002 m: 12 of 61 places are out of reach"));
    assert_eq!(
        page.matches("<code>suspension range a.toml</code>").count(),
        3
    );
}

#[test]
fn a_lock_within_the_travel_cuts_the_curves_short() {
    let (page, message) = page(&corner(""), &["rack.z=0.002", "--travel", "-0.05:0.6"], 3);
    assert!(page.contains("The curves are cut short: "), "{message}");
    assert!(page.contains("a.toml with rack.z 0.002 m: "), "{message}");
    let of_design = "\na.toml: 43 of 61 places are out of reach";
    assert!(message.contains(of_design), "{message}");
    assert_eq!(
        message.matches("is it in another unit?").count(),
        0,
        "{message}"
    );
}

/// The pushrod ends the travel, and moves nothing of the wheel.
#[test]
fn curves_that_differ_in_their_ends_alone_have_no_chart() {
    let file = "linkage = \"double_wishbone_rocker\"\nunit = \"m\"\ntime = { instants = [0.0] }\n\
                drives = { bump = 0.3, steer = 0.34 }\n";
    let arguments = ["pushrod_lower.z=-0.02:0.02:3", "--travel", "-0.15:0.2"];
    let of = |name: &str| page(file, &[&arguments[..], &["--of", name]].concat(), 3).0;
    let toe = of("toe");
    let alike = "Alike for all values to the eye, without a chart: toe angle.";
    assert_eq!(
        [toe.matches(alike).count(), toe.matches("<svg").count()],
        [2, 0]
    );
    assert!(toe.contains("sweeps end before the range does"));
    assert!(of("damper").contains("<svg"));
}

/// Each of many curves is no clearer, and makes the page slow.
#[test]
fn of_many_values_the_page_has_the_curves_of_some() {
    let (page, _) = page(
        &corner(""),
        &["rack.z=-0.006:0.006:201", "--of", "toe", "--csv", "v.csv"],
        0,
    );
    let told =
        "The charts have the curves of 1 of 3 values; the table of --csv has the numbers of all.";
    assert!(page.contains(told));
    // Of 201 values every third, the design in the middle, and the last.
    for value in ["-0.006 m<", ">design<", "+0.006 m<"] {
        assert!(page.contains(value), "{value}");
    }
    let named = page.matches("class=\"line\"").count();
    assert_eq!(named, 67 + 2, "{named}");
    let (page, _) = self::page(&corner(""), &["rack.z=-0.006:0.006:99", "--of", "toe"], 0);
    assert!(!page.contains("The charts have"));
    assert_eq!(page.matches("class=\"line\"").count(), 99);
}

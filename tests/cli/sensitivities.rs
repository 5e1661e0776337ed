//! The effects of moving a hardpoint.

mod axle;

use std::collections::BTreeMap;

use suspension_core::linkages::LISTINGS;

use super::program::{CORNER, folder, run, text};

/// Returns the rows of the table, by the changed coordinate or length.
fn table(file: &str) -> BTreeMap<String, BTreeMap<String, f64>> {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sensitivities", "a.toml", "--csv", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let mut reader = csv::Reader::from_reader(output.stdout.as_slice());
    let headings: Vec<String> = reader
        .headers()
        .expect("headings")
        .iter()
        .map(str::to_owned)
        .collect();
    let row = |record: csv::StringRecord| {
        let numbers = headings.iter().zip(record.iter()).skip(1);
        let numbers =
            numbers.map(|(name, number)| (name.clone(), number.parse().expect("a number")));
        (record[0].to_owned(), numbers.collect())
    };
    reader
        .records()
        .map(|record| row(record.expect("a row")))
        .collect()
}

/// Arms that are not parallel in the side view: the instant centre there is not far away.
fn corner(upper_rear_z: f64) -> String {
    format!("{CORNER}[points]\nupper_rear = [-0.15, 0.42, {upper_rear_z:?}]\n")
}

/// A suspension that is moved as a whole along the vehicle has the same kinematics.
#[test]
fn sensitivities_to_x_of_all_points_sum_to_zero() {
    let table = table(&corner(0.36));
    let of_x: Vec<_> = table
        .iter()
        .filter(|(changed, _)| changed.ends_with(".x"))
        .collect();
    assert!(of_x.len() > 15, "{}", of_x.len());
    let mut checked = 0;
    for name in of_x[0].1.keys().filter(|name| !name.ends_with("_x")) {
        let terms: Vec<f64> = of_x.iter().map(|(_, row)| row[name]).collect();
        let largest = terms
            .iter()
            .fold(0.0_f64, |largest, term| largest.max(term.abs()));
        let sum: f64 = terms.iter().sum();
        assert!(
            sum.abs() <= 1e-7 * largest + 1e-9,
            "{name}: {sum:e} of {largest}"
        );
        checked += usize::from(largest > 1e-3);
    }
    assert!(checked > 30, "{checked}");
}

/// Formulas of geometry: camber from the heights of the spin axis, and changes that do not affect it.
#[test]
fn sensitivities_of_camber_match_the_slope_of_the_spin_axis() {
    let table = table(&corner(0.36));
    // The axis is 0.1 m long and level.
    assert!((table["axle.z"]["camber_rad"] - 10.0).abs() < 1e-8);
    assert!((table["wheel_centre.z"]["camber_rad"] + 10.0).abs() < 1e-8);
    assert!(table["damper_inner.y"]["camber_rad"].abs() < 1e-12);
    // The tie rod turns the upright: a longer one turns the front of the wheel inboard.
    assert!(table["length tie_rod"]["toe_rad"].abs() > 1.0);
    assert!(
        !table
            .keys()
            .any(|changed| changed.starts_with("length upright"))
    );
}

/// Bump steer and its like against files with the hardpoint moved.
#[test]
fn sensitivities_agree_with_files_with_the_hardpoint_moved() {
    let table = table(&corner(0.36));
    let row = &table["upper_rear.z"];
    let folder = folder();
    let value = |z: f64, name: &str| -> f64 {
        std::fs::write(folder.path().join("b.toml"), corner(z)).expect("written");
        let output = run(
            folder.path(),
            &["sweep", "b.toml", "--drive", "bump=0.0", "--csv", "-"],
        );
        super::program::rows(&output.stdout)[0][name]
    };
    for name in [
        "toe_rad_per_bump",
        "camber_rad_per_bump",
        "caster_rad_per_bump",
        "damper_m_per_bump",
        "roll_centre_m",
        "side_arm_m",
    ] {
        let step = 2e-4;
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|steps| value(0.36 + steps * step, name));
        let expected = (8.0 * (c - b) - (d - a)) / (12.0 * step);
        let found = row[name];
        assert!(
            (found - expected).abs() <= 1e-6 * (1.0 + expected.abs()),
            "{name}: {found} {expected}"
        );
    }
}

/// The sentence is useless above camber.
#[test]
fn the_note_on_links_built_anew_is_printed_above_toe_alone() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner(0.36)).expect("written");
    let why =
        "\nA point is moved with its links built anew to it: an end of `tie_rod` changes slopes";
    for (of, is_printed) in [
        (&["--of", "camber"][..], false),
        (&["--of", "toe"], true),
        (&["--of", "camber", "--of", "toe per bump"], true),
        (&[], true),
    ] {
        let output = run(folder.path(), &[&["sensitivities", "a.toml"], of].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stdout).contains(why), is_printed, "{output:?}");
    }
}

/// The marker of the spin axis stands among hardpoints; where a joint is the inner point of the axis, nothing is to be said.
#[test]
fn the_note_on_the_spin_axis_is_printed_above_angles_of_the_wheel() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner(0.36)).expect("written");
    let joint = include_str!("../../examples/five_link.toml");
    std::fs::write(folder.path().join("b.toml"), joint).expect("written");
    let what = "\n`axle` is no joint, it states the spin axis: moving it or `wheel_centre` alone sets another camber or toe";
    for (file, of, is_printed) in [
        ("a.toml", "camber", true),
        ("a.toml", "toe", true),
        ("a.toml", "damper", false),
        ("b.toml", "toe", false),
    ] {
        let output = run(folder.path(), &["sensitivities", file, "--of", of]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let report = text(&output.stdout);
        assert_eq!(report.contains(what), is_printed, "{report}");
    }
}

#[test]
fn sensitivities_are_sorted_and_unknown_quantities_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner(0.36)).expect("written");
    let output = run(
        folder.path(),
        &[
            "sensitivities",
            "a.toml",
            "--of",
            "camber",
            "--largest",
            "2",
        ],
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("a.toml: per mm of each hardpoint coordinate and link length (the 2 with the largest effect, see --largest); axes"),
        "{report}"
    );
    assert!(
        report.contains("\ncamber: 0 deg\n  deg per mm: wheel_centre.z -0.573, axle.z 0.573\n"),
        "{report}"
    );
    assert!(!report.contains("\ntoe"), "{report}");
    for (of, expected) in [
        (
            "chamber",
            "a.toml: no quantity begins with `chamber`; did you mean `camber`? Without --of all quantities are printed\n",
        ),
        (
            "Kingpin angle",
            "a.toml: no quantity begins with `Kingpin angle`; did you mean `kingpin`? Without",
        ),
        (
            "camber gain",
            "`camber_gain` is the derivative of `camber` with respect to a drive of travel",
        ),
    ] {
        let output = run(folder.path(), &["sensitivities", "a.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}

#[test]
fn invalid_counts_are_refused_with_their_format() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), corner(0.36)).expect("written");
    for (option, value, wanted) in [
        ("--largest", "0", "COUNT is a whole number, at least 1"),
        ("--largest", "few", "COUNT is a whole number, at least 1"),
        ("--samples", "1", "COUNT is a whole number, at least 2"),
        ("--samples", "-5", "COUNT is a whole number, at least 2"),
        ("--seed", "-1", "NUMBER is a whole number, at least 0"),
    ] {
        let output = run(folder.path(), &["sensitivities", "a.toml", option, value]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(wanted), "{output:?}");
    }
}

#[test]
fn a_quantity_without_derivatives_is_not_reported_as_unchanged() {
    let folder = folder();
    let text_of =
        |(name, text): &(&str, &'static str)| (*name == "double_wishbone").then_some(*text);
    let listing = LISTINGS.iter().find_map(text_of).expect("a layout");
    let parallel = "measure par: angle(lower_front -> lower_rear, upper_front -> upper_rear);\n";
    let write = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).expect("written");
    };
    write("a.linkage", &format!("{listing}\n{parallel}"));
    write(
        "a.toml",
        "listing = 'a.linkage'\nunit = 'm'\ntime = { instants = [0.0] }\ndrives = { bump = 0.3, steer = 0.34 }\n",
    );
    let output = run(folder.path(), &["sensitivities", "a.toml", "--of", "par"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let report = text(&output.stdout);
    assert!(
        report.contains("\npar: 0 deg\n  it has no derivatives here"),
        "{report}"
    );
}

/// No hardpoint changes a quantity that counts from the design position; the message names quantities that hardpoints
/// change, for the intended wheel.
#[test]
fn for_a_quantity_zero_at_the_design_alternatives_are_named() {
    let folder = folder();
    let axle = include_str!("../../examples/steered_axle.toml");
    let axle = axle.replace("[vehicle]", "[vehicle]\nrack_per_turn = 0.052");
    std::fs::write(folder.path().join("axle.toml"), &axle).expect("written");
    let counts = "counts from the design position and is zero there, whatever the hardpoints; name in its place";
    for (of, expected) in [
        (
            "steering_wheel_angle",
            "is set by the drive of steering, whatever the hardpoints; name in its place `left_steering_ratio` or \
             `right_steering_ratio`, which they change"
                .to_owned(),
        ),
        (
            "wheel_travel",
            format!("{counts} `left_centre_z` or `right_centre_z`, which they change"),
        ),
        ("left_recession", format!("{counts} `left_centre_x`, which they change")),
        ("track_change", format!("{counts} `track`, which they change")),
    ] {
        let output = run(folder.path(), &["sensitivities", "axle.toml", "--of", of]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert_eq!(text(&output.stderr), format!("axle.toml: `{of}` {expected}\n"));
        let target = format!(
            "{axle}[tune.moves.ball]\npoints = [\"left_tie_ball\"]\nalong = \"z\"\nby = [-0.01, 0.01]\n\
             [tune.targets.wanted]\nof = \"{of}\"\nvalue = 1.0\nwithin = 0.1\n"
        );
        std::fs::write(folder.path().join("tuned.toml"), target).expect("written");
        let output = run(folder.path(), &["tune", "tuned.toml"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let messages = text(&output.stderr);
        assert!(messages.ends_with(&format!(": `{of}` {expected}\n")), "{messages}");
    }
}

/// Arms that are parallel have no instant centre.
#[test]
fn a_quantity_without_a_value_is_not_reported_as_unknown() {
    let folder = folder();
    let statements = "fixed: lf at [0.2, 0.35, 0.16], lr at [-0.2, 0.35, 0.16], uf at [0.2, 0.35, 0.42], ur at [-0.2, 0.35, 0.42];\n\
                      fixed: rack at [-0.1, 0.35, 0.29];\n\
                      free: lb at [0, 0.7, 0.16], ub at [0, 0.7, 0.42], tb at [-0.1, 0.7, 0.29], wc at [0, 0.75, 0.3];\n\
                      hinge lower: lf, lr -> lb;\nhinge upper: uf, ur -> ub;\nlink tie: rack -> tb;\n\
                      body upright: lb, ub, tb, wc;\npoint axle: upright at [0, 0.65, 0.3];\ndrive bump: wc.z;\nwheel: axle -> wc;\n";
    let file = format!(
        "unit = 'm'\nvehicle = {{ wheel_radius = 0.3 }}\ntime = {{ instants = [0.0] }}\ndrives = {{ bump = 0.3 }}\n\
         statements = '''\n{statements}'''\n"
    );
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(
        folder.path(),
        &["sensitivities", "a.toml", "--of", "front_arm"],
    );
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let messages = text(&output.stderr);
    let expected = "`front_arm` has no value at the design position, and so no sensitivities; ";
    assert!(messages.contains(expected), "{messages}");
}

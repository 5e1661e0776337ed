//! The contents of load cases, and several of them in one file.

use super::super::program::{CORNER, example, folder, rows, run, text};
use super::{GRID, loaded, table};

/// A bar is not a spring that carries a wheel, at any place among the file's springs.
#[test]
fn the_proposed_load_case_names_a_spring_moved_by_the_wheel() {
    let springs = "[springs.bar]\nalong = \"roll_travel\"\nrate = 9000.0\n\
                   [springs.coil]\nalong = \"damper_left\"\nrate = 30000.0\nload = 3000.0\n";
    let folder = folder();
    let file = example("live_axle_panhard.toml") + springs;
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.contains("and bump_left = \"coil\" for the spring to bear"),
        "{message}"
    );
}

#[test]
fn without_a_measure_or_spring_nothing_can_bear_the_load_of_a_drive() {
    let folder = folder();
    let file = CORNER.replace("double_wishbone_pushrod", "double_wishbone");
    let case = "[loads.braking]\nbump = 4000.0\n";
    std::fs::write(folder.path().join("a.toml"), file + case).expect("written");
    let output = run(folder.path(), &["loads", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr).trim_end();
    assert!(
        message.ends_with("; there is no measure or spring yet"),
        "{message}"
    );
}

#[test]
fn an_invalid_load_is_refused_at_its_place() {
    for (case, expected) in [
        ("", "no load case; write [loads.braking]"),
        (
            "[springs.coil]\nalong = \"damper\"\nrate = 60000.0\n",
            "4000.0], and bump = \"coil\" for the spring to bear what the drive would",
        ),
        (
            "[loads]\ncontact = [0.0, 0.0, 4000.0]\n",
            "invalid type: list, expected a load case, which has a name: write its lines under [loads.NAME]",
        ),
        (
            "[loads.a]\ncontakt = [0.0, 0.0, 1.0]\n",
            "unknown place `contakt`; loads act at contact, ",
        ),
        (
            "[loads.a]\nleft.contact = [0.0, 0.0, 1.0]\n",
            "unknown field `contact`; a part of a named wheel or side is written left_contact\n",
        ),
        (
            "[loads.a]\ncontact = { force = [0.0, 0.0, 1.0], momnet = [0.0, 1.0, 0.0] }\n",
            "unknown field `momnet`; did you mean `moment`?",
        ),
        (
            "[loads.a]\ncontact = [0.0, 1.0]\n",
            "3 numbers are wanted here, [x, y, z], not 2; a force is written contact",
        ),
        (
            "[loads.a]\ncontact = { force = [1.0, 2.0, 3.0, 4.0] }\n",
            "3 numbers are wanted here, [x, y, z], not 4",
        ),
        (
            "[loads.a]\ncontact = [0.0, nan, 1.0]\n",
            "load `contact` is not finite",
        ),
        (
            "[loads.a]\ncontact = [0.0, 0.0, 1e308]\n",
            "load `contact` is not finite, or too large to compute with: write forces in N",
        ),
        (
            "[loads.a]\ncontact = 3.0\n",
            "`contact` is a place: write a force [x, y, z] in N",
        ),
        (
            "[loads.a]\ndamper = [0.0, 0.0, 1.0]\n",
            "`damper` is a measure: write one number",
        ),
        (
            "[loads.a]\nlower_front = [0.0, 0.0, 1.0]\n",
            "`lower_front` is a chassis point",
        ),
        (
            "[loads.a]\nrack = { moment = [1.0, 0.0, 0.0] }\n",
            "`rack` is a chassis point",
        ),
        (
            "[loads.a]\nbump = \"dampr\"\n",
            "unknown measure or spring `dampr`; known are damper, bar_arm; did you mean `damper`?",
        ),
        (
            "[loads.a]\nbump = \"damper\"\nsteer = \"damper\"\n",
            "a.toml:10:9: `damper` is to bear the loads of both `bump` and `steer`, but a spring can bear the load of only one drive; name \
             another spring or measure for `steer`",
        ),
        (
            "[loads.a]\nbump = [\"damper\", \"bar_arm\"]\n",
            "a.toml:9:8: `bump` of load case `a` has a list of names, but only one measure or spring can bear the load of a drive; write bump = \
             \"damper\", and for another that acts beside it the force in it, NAME = 500.0, or for a spring with its rate acting = [\"NAME\"]\n",
        ),
        (
            "[loads.a]\nbump = [\"damper\", \"bra_arm\"]\n",
            "unknown measure or spring `bra_arm`; known are damper, bar_arm; did you mean `bar_arm`?",
        ),
        (
            "[loads.a]\ncontact = [\"damper\"]\n",
            "`contact` is a place: write a force [x, y, z] in N",
        ),
        (
            "[loads.a]\ndamper = [\"bump\"]\n",
            "`damper` is a measure: write one number",
        ),
        (
            "[loads.\"../a\"]\ncontact = [0.0, 0.0, 1.0]\n",
            "the name of a load case becomes part of file and column names; leave out `/`",
        ),
        (
            "[loads.a]\nbum = \"damper\"\n",
            "`bum` is not a drive; the drives are bump, steer",
        ),
        (
            "[loads.a]\nlower_ball = { moment = [1.0, 0.0, 0.0] }\n",
            "several bodies join at `lower_ball`",
        ),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), loaded(case)).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        assert_eq!(output.status.code(), Some(2), "{case}: {output:?}");
        assert!(
            text(&output.stderr).contains(expected),
            "{expected}: {output:?}"
        );
    }
}

/// The name of a spring differs from that of the measure along which it acts.
#[test]
fn a_load_case_may_name_the_spring_that_bears_the_load() {
    let springs = "[springs.coil]\nalong = \"damper\"\nrate = 28000.0\nload = 3800.0\n";
    let case = |by: &str| {
        let case = format!("[loads.a]\ncontact = [0.0, 0.0, 4000.0]\nbump = \"{by}\"\n");
        loaded(&format!("{springs}{case}"))
    };
    let by_measure = table(&case("damper"), &GRID);
    assert!(by_measure[0].contains_key("a_damper_N"));
    assert_eq!(by_measure, table(&case("coil"), &GRID));
}

/// Cases differ in the parts that bear their loads, and so do their columns.
#[test]
fn each_load_case_has_its_own_columns() {
    let cases = "[loads.a]\ncontact = [0.0, 0.0, 4000.0]\nbump = \"damper\"\n[loads.b]\ncontact = [0.0, 0.0, 4000.0]\n";
    let row = &table(&loaded(cases), &[])[0];
    assert!(row.contains_key("a_damper_N") && !row.contains_key("b_damper_N"));
    assert!(row["a_bump_N"].abs() < 1e-8 && (row["b_bump_N"] - 4000.0).abs() < 100.0);
    // The pushrod passes the load on to the damper, and has no load if the drive bears it.
    assert!(row["a_pushrod_N"] < -1000.0 && row["b_pushrod_N"].abs() < 1e-8);
}

#[test]
fn a_measure_that_does_not_move_with_a_drive_cannot_bear_its_load() {
    let folder = folder();
    // The bar's arm is joined to the rocker, which steering does not move if the wheel stays.
    let case = "[loads.a]\ncontact = [0.0, 0.0, 4000.0]\nsteer = \"bar_arm\"\nbump = \"damper\"\n";
    std::fs::write(folder.path().join("a.toml"), loaded(case)).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--csv", "a.csv"]);
    let is_reported = text(&output.stderr).contains("load case `a` has no answer");
    assert!(is_reported && output.status.code() == Some(3), "{output:?}");
    assert!(!folder.path().join("a.csv").exists());
    // Other cases have theirs.
    let other = format!("{case}[loads.b]\ncontact = [0.0, 0.0, 4000.0]\n");
    std::fs::write(folder.path().join("a.toml"), loaded(&other)).expect("written");
    let output = run(folder.path(), &["loads", "a.toml", "--csv", "a.csv"]);
    let is_reported = text(&output.stderr).contains("load case `a` has no answer");
    assert!(is_reported && output.status.code() == Some(3), "{output:?}");
    let beyond = [
        "loads",
        "a.toml",
        "--csv",
        "a.csv",
        "--drive",
        "bump=-0.3:0.3:7",
    ];
    let output = run(folder.path(), &beyond);
    let messages = text(&output.stderr);
    assert!(
        messages.contains("load case `a` has no answer") && messages.contains("out of reach"),
        "{messages}"
    );
    let row = &rows(&std::fs::read(folder.path().join("a.csv")).expect("a table"))[0];
    assert!(row.contains_key("b_bump_N") && !row.contains_key("a_bump_N"));
    assert!(text(&output.stdout).contains("tie_rod"), "{output:?}");
}

/// Rows are written immediately. All states of this motion need 40 MB; limits of the shell apply to its children, in kB.
#[cfg(target_os = "linux")]
#[test]
fn loads_of_a_long_motion_take_bounded_memory() {
    let folder = folder();
    let case = "[loads.a]\ncontact = [0.0, 0.0, 4000.0]\n";
    let motion = "time = { start = 0.0, stop = 1.0, step = 2e-4 }";
    let file = loaded(case).replace("time = { instants = [0.0] }", motion);
    assert!(file.contains(motion));
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let program = format!(
        "ulimit -v 40000 && exec '{}' loads a.toml --motion --csv a.csv",
        super::super::PROGRAM
    );
    let output = std::process::Command::new("sh")
        .current_dir(folder.path())
        .args(["-c", &program])
        .output()
        .expect("a shell");
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = rows(&std::fs::read(folder.path().join("a.csv")).expect("a table"));
    assert_eq!(rows.len(), 5_001);
    let report = text(&output.stdout);
    assert!(
        report.contains("least and greatest of 5001 places"),
        "{report}"
    );
}

/// The ground never pulls at a tyre: a vertical force at the contact point that points downwards has the sign of other axes.
#[test]
fn a_wheel_that_the_ground_pulls_down_is_noted() {
    let sae = CORNER
        .replace("unit =", "axes = \"SAE\"\nunit =")
        .replace("bump = 0.3", "bump = -0.3")
        .replace("steer = 0.34", "steer = -0.34");
    for (corner, force, expected) in [
        (CORNER, "4000.0", ""),
        (CORNER, "0.0", ""),
        (
            CORNER,
            "-4000.0",
            "up is positive z in the axes of the file, ISO 8855\n",
        ),
        (&*sae, "-4000.0", ""),
        (
            &sae,
            "4000.0",
            "up is negative z in the axes of the file, SAE\n",
        ),
    ] {
        let folder = folder();
        let file =
            format!("{corner}[loads.a]\ncontact = [0.0, 100.0, {force}]\nbump = \"damper\"\n");
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["loads", "a.toml"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let notes = text(&output.stderr);
        let begins = "a.toml: the force at `contact` in [loads.a] pulls the wheel down: is the sign of its z right?";
        assert_eq!(notes.contains(begins), !expected.is_empty(), "{notes}");
        assert!(notes.contains(expected), "{notes}");
    }
}

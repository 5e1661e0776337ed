//! Tables for vehicle models, against a sweep of the same file.

use std::collections::BTreeMap;

use super::program::{CORNER, Rows, folder, run, table, text};

/// The text that the command prints.
fn tables(file: &str, options: &[&str]) -> String {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(
        folder.path(),
        &[&["tables", "a.toml", "--out", "-", "--as"], options].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    text(&output.stdout).to_owned()
}

pub(super) fn swept(file: &str, drive: &str) -> Rows {
    table(file, &["sweep", "--drive", drive])
}

/// The rows of a table of CarSim: jounce and value.
fn carsim_table(text: &str, keyword: &str) -> Vec<[f64; 2]> {
    let (_, table) = text
        .split_once(&format!("{keyword} SPLINE\n"))
        .expect(keyword);
    let (table, _) = table.split_once("ENDTABLE").expect("an end");
    let row = |line: &str| {
        let (jounce, value) = line.split_once(", ").expect("two numbers");
        [jounce, value].map(|number| number.parse().expect("a number"))
    };
    table.lines().map(row).collect()
}

/// The rows of a suspension of CarMaker: value, per compression, per steering.
fn carmaker_rows(text: &str) -> BTreeMap<String, [f64; 3]> {
    let lines = text.lines().filter_map(|line| line.split_once(" = "));
    let rows = lines.filter_map(|(key, value)| {
        let numbers: Result<Vec<f64>, _> = value.split(' ').map(str::parse).collect();
        let numbers: [f64; 3] = numbers.ok()?.try_into().ok()?;
        Some((key.rsplit('.').next()?.to_owned(), numbers))
    });
    rows.collect()
}

#[test]
fn tables_over_jounce_equal_the_changes_in_a_sweep() {
    let text = tables(CORNER, &["carsim", "--travel", "-0.04:0.05"]);
    let mut swept = swept(CORNER, "bump=-0.04:0.05:61");
    let design = &self::swept(CORNER, "bump=0")[0];
    // Tables have the design position in place of the nearest.
    swept[27] = design.clone();
    assert!(
        text.starts_with("PARSFILE\n") && text.ends_with("END\n"),
        "{text}"
    );
    for (keyword, name, factor) in [
        ("CAMBER_TABLE", "camber_rad", 1_f64.to_degrees()),
        ("TOE_TABLE", "toe_rad", 1_f64.to_degrees()),
        ("SUSP_X_TABLE", "wheel_centre_x", 1e3),
        ("SUSP_LAT_TABLE", "wheel_centre_y", -1e3),
        // Here the kingpin belongs to the carrier, so its caster decreases by the forward rotation of the carrier.
        ("SUSP_DIVE_TABLE", "caster_rad", -1_f64.to_degrees()),
    ] {
        let table = carsim_table(&text, keyword);
        assert_eq!(table.len(), 61, "{keyword}");
        for (row, [jounce, value]) in swept.iter().zip(table) {
            let expected = factor * (row[name] - design[name]);
            let rise = 1e3 * (row["wheel_centre_z"] - design["wheel_centre_z"]);
            assert!((jounce - rise).abs() < 1e-5, "{keyword} {jounce} {rise}");
            // Caster is of a line that leans inboard too.
            let off = if keyword == "SUSP_DIVE_TABLE" {
                0.03
            } else {
                1e-5
            };
            assert!(
                (value - expected).abs() < off,
                "{keyword} at {jounce}: {value} {expected}"
            );
        }
    }
}

/// On both sides, against differences.
#[test]
fn a_linear_suspension_table_agrees_with_differences() {
    const STEP: f64 = 1e-4;
    let upright = "linkage = \"steered_axle\"\nunit = \"m\"\n[time]\ninstants = [0.0]\n[drives]\nbump_left = 0.3\nbump_right = 0.3\nsteer = 0.34\n";
    // With camber and toe at the design position rotations are not angles.
    let leaning = format!(
        "{upright}[points]\nleft_axle = [0.002, 0.65, 0.293]\nright_axle = [0.002, -0.65, 0.293]\n"
    );
    for axle in [upright, &leaning] {
        let around = |drive: &str| {
            let table = swept(axle, &format!("{drive}=-{STEP}:{STEP}:3"));
            move |value: &dyn Fn(&BTreeMap<String, f64>) -> f64| {
                (value(&table[2]) - value(&table[0])) / (2.0 * STEP)
            }
        };
        let (heave, steer) = (around("bump_left,bump_right"), around("steer"));
        for (wheel, side) in [("left", 1.0), ("right", -1.0)] {
            let found = carmaker_rows(&tables(axle, &["carmaker", "--wheel", wheel]));
            let point = |point: &str, axis: &str| format!("{wheel}_{point}_{axis}");
            let spin_axis = |row: &BTreeMap<String, f64>| {
                ["x", "y", "z"].map(|axis| {
                    side * (row[&point("wheel_centre", axis)] - row[&point("axle", axis)])
                })
            };
            let value = |row: &BTreeMap<String, f64>, name: &str| {
                let [x, y, z] = spin_axis(row);
                match name {
                    "rx" => z.atan2(x.hypot(y)),
                    "rz" => (-x).atan2(y),
                    _ => row[&point("wheel_centre", &name[1..])],
                }
            };
            for row in ["tx", "ty", "tz", "rx", "rz"] {
                let [_, per_compression, per_steer] = found[row];
                let value = |place: &BTreeMap<String, f64>| value(place, row);
                let expected = [heave(&value), steer(&value)];
                assert!(
                    (per_compression - expected[0]).abs() < 1e-5,
                    "{wheel} {row}: {found:?} {expected:?}"
                );
                assert!(
                    (per_steer - expected[1]).abs() < 1e-4,
                    "{wheel} {row}: {found:?} {expected:?}"
                );
            }
        }
    }
    let metres = carmaker_rows(&tables(CORNER, &["carmaker"]));
    assert!(
        metres["lDamp"][1] < -0.5 && metres["rz"][2].abs() > 1.0,
        "{metres:?}"
    );
    let left = "linkage = \"twist_beam\"\nunit = \"m\"\n[vehicle]\naxle = \"rear\"\nwheelbase = 2.5\ncg_height = 0.5\n[time]\ninstants = [0.0]\n[drives]\nbump_left = 0.29\nbump_right = 0.29\n";
    assert!(
        tables(left, &["carmaker", "--wheel", "right"]).contains("SuspR.Kin.0.InputSide = right\n")
    );
    let assumed = "\n## SuspF is assumed: the file does not say which axle this is, as axle = \"rear\" under [vehicle] would\n";
    let front = CORNER.replace("0.3 }", "0.3, axle = \"front\" }");
    for (file, is_assumed) in [(CORNER, true), (&front, false), (left, false)] {
        assert_eq!(tables(file, &["carmaker"]).contains(assumed), is_assumed);
    }
}

/// A double wishbone of the catalogue, in three systems of axes: tables are the same, from rebound to bump.
#[test]
fn tables_do_not_depend_on_the_axes_of_the_file() {
    let file = |axes: &str, bump: &str| {
        format!(
            "linkage = \"double_wishbone\"\nunit = \"m\"\naxes = \"{axes}\"\n[time]\ninstants = [0.0]\n[drives]\nbump = {bump}\nsteer = 0.34\n"
        )
    };
    let iso = file("ISO 8855", "0.3");
    let [carsim, carmaker] = ["CarSim", "carmaker"].map(|program| tables(&iso, &[program]));
    for (axes, bump) in [("Adams", "0.3"), ("SAE", "-0.3")] {
        let other = file(axes, bump).replace("steer = 0.34", "steer = -0.34");
        let table = carsim_table(&tables(&other, &["carsim"]), "CAMBER_TABLE");
        for ([jounce, camber], [at, expected]) in
            table.into_iter().zip(carsim_table(&carsim, "CAMBER_TABLE"))
        {
            assert!(
                (jounce - at).abs() < 1e-5 && (camber - expected).abs() < 1e-5,
                "{axes}: {jounce} {camber}"
            );
        }
        let found = carmaker_rows(&tables(&other, &["carmaker"]));
        for (row, expected) in carmaker_rows(&carmaker) {
            let pairs = found[&row].into_iter().zip(expected);
            assert!(
                pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-9),
                "{axes} {row}: {:?} {expected:?}",
                found[&row]
            );
        }
    }
    let car = std::fs::read_to_string(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/examples/front_and_rear_axle.toml"
    ))
    .expect("an example");
    assert!(tables(&car, &["carmaker", "--wheel", "rear_right"]).contains("SuspR.Kin.N = 1\n"));
    assert!(tables(&car, &["carmaker", "--wheel", "front_right"]).contains("SuspF.Kin.N = 1\n"));
}

#[test]
fn invalid_files_and_options_of_tables_are_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let no_wheel = "statements = \"fixed: a at [0.0, 0.0, 0.0]; free: p at [0.0, 0.4, 0.3]; link rod: a -> p; drive x: p.x; drive bump: p.z;\"\n\
                    unit = \"m\"\n[time]\ninstants = [0.0]\n[drives]\nx = 0.0\nbump = 0.3\n";
    std::fs::write(folder.path().join("b.toml"), no_wheel).expect("written");
    let steered = CORNER.replace("0.3 }", "0.3, travel = \"steer\" }");
    std::fs::write(folder.path().join("c.toml"), steered).expect("written");
    for (arguments, expected) in [
        (
            vec!["c.toml", "--as", "carmaker"],
            "travel of the wheel is `steer`, which does not move it up or down: is it another drive?",
        ),
        (
            vec!["a.toml", "--as", "carsim", "--wheel", "left"],
            "a.toml: --wheel: the listing has one wheel, without a name; leave it out",
        ),
        (vec!["a.toml", "--as", "simpack"], "invalid value 'simpack'"),
        (
            vec!["a.toml", "--as", "carsim", "--out", "a.toml"],
            "--out would overwrite",
        ),
        (
            vec!["b.toml", "--as", "carsim"],
            "b.toml: the listing states no wheel",
        ),
    ] {
        let output = run(folder.path(), &[vec!["tables"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(text(&output.stderr).contains(expected), "{output:?}");
    }
}

/// A live axle with unequal sides, by two drives that are named after the wheels, and their values.
pub(crate) fn live_axle([left, right]: [(&str, f64); 2]) -> String {
    format!(
        "unit = \"m\"\nstatements = '''
fixed: fl at [0.55, 0.47, 0.30], fr at [0.60, -0.44, 0.27], fu at [0.33, 0.06, 0.47], pc at [-0.15, -0.50, 0.33],
       tl at [-0.05, 0.45, 0.67], tr at [-0.08, -0.60, 0.65];
free:  al at [0.02, 0.51, 0.23], ar at [0.04, -0.49, 0.25], au at [0.01, -0.03, 0.45], pa at [-0.15, 0.50, 0.32],
       wl at [0.0, 0.75, 0.31], wr at [0.0, -0.75, 0.31], dl at [-0.09, 0.45, 0.21], dr at [-0.07, -0.60, 0.22];
link a: fl -> al; link b: fr -> ar; link c: fu -> au; link panhard: pc -> pa;
body axle: wl, wr, al, ar, au, pa, dl, dr;
drive bump_left:  {};
drive bump_right: {};
measure damper_left:  length(dl -> tl);
measure damper_right: length(dr -> tr);
wheel left:  wr -> wl;
wheel right: wl -> wr;
'''
vehicle = {{ wheel_radius = 0.31 }}
time = {{ instants = [0.0] }}
drives = {{ bump_left = {:?}, bump_right = {:?} }}
",
        left.0, right.0, left.1, right.1
    )
}

pub(crate) const HEAVE_AND_ROLL: [(&str, f64); 2] =
    [("0.5 wl.z + 0.5 wr.z", 0.31), ("wl.z - wr.z", 0.0)];

/// The lengths of the dampers with both wheels at 0.31 m.
pub(crate) const BY_DAMPERS: [(&str, f64); 2] = [
    ("length(dl -> tl)", 0.461_735_855_224_607_9),
    ("length(dr -> tr)", 0.430_116_263_352_131_4),
];

#[test]
fn a_live_axle_in_heave_has_no_lean_for_any_drives() {
    let by_height = live_axle([("wl.z", 0.31), ("wr.z", 0.31)]);
    let heights = tables(&by_height, &["carmaker"]);
    assert!(heights.contains(".ValidSide = left\n"), "{heights}");
    let heights = carmaker_rows(&heights);
    for drives in [BY_DAMPERS, HEAVE_AND_ROLL] {
        let found = carmaker_rows(&tables(&live_axle(drives), &["carmaker"]));
        let [_, leans, _] = found["rx"];
        assert!(leans.abs() < 1e-12, "{leans}");
        for (name, expected) in &heights {
            for (found, expected) in found[name].iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-9,
                    "{name}: {found} {expected}"
                );
            }
        }
    }
    let jounce = |drives| {
        let text = tables(&live_axle(drives), &["carsim"]);
        let [highest, _] = *carsim_table(&text, "CAMBER_TABLE").last().expect("a row");
        highest
    };
    assert!(
        (jounce(HEAVE_AND_ROLL) - 60.0).abs() < 1e-6,
        "travel is that of heave"
    );
}

#[test]
fn only_a_symmetric_axle_has_a_table_valid_for_both_sides() {
    let file = include_str!("../../examples/steered_axle.toml");
    let moved = format!("{file}\n[points]\nleft_lower_ball = [0.005, 0.70, 0.175]\n");
    for (file, valid) in [(file.to_owned(), "left+right"), (moved, "right")] {
        let text = tables(&file, &["carmaker", "--wheel", "right"]);
        assert!(text.contains(&format!(".ValidSide = {valid}\n")), "{text}");
    }
}

#[test]
fn a_comment_in_the_table_names_an_omitted_bar() {
    let file = include_str!("../../examples/double_wishbone_pushrod.toml");
    let text = tables(file, &["carmaker"]);
    assert!(
        text.contains("## no lStabi: `bar_arm` is an angle"),
        "{text}"
    );
    assert!(text.contains(".L.lDamp = "), "{text}");
    assert!(!text.contains("lSpring"), "{text}");
    // A spring with the damper as its measure, whatever the measure is called.
    let sprung = format!("{file}\n[springs.coil]\nalong = \"damper\"\nrate = 30000.0\n");
    assert!(tables(&sprung, &["carmaker"]).contains(".L.lSpring = "));
    let bar = sprung.replace("springs.coil", "springs.anti_roll_bar");
    assert!(!tables(&bar, &["carmaker"]).contains("lSpring"));
}

#[test]
fn tables_of_two_wheels_are_separate_files() {
    let folder = folder();
    let axle = include_str!("../../examples/steered_axle.toml");
    std::fs::write(folder.path().join("axle.toml"), axle).expect("written");
    for wheel in ["left", "right"] {
        let arguments = ["tables", "axle.toml", "--as", "carsim", "--wheel", wheel];
        let output = run(folder.path(), &arguments);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let path = folder.path().join(format!("out/axle_{wheel}_carsim.par"));
        assert!(path.exists(), "{output:?}");
    }
}

/// The usual range is one of heights of the wheel.
#[test]
fn a_range_of_a_scaled_drive_is_noted_by_how_far_the_wheel_rises() {
    let file = "unit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 300.0 }\nstatements = \"\"\"\n\
                fixed: front at [0.2, 0.3, 0.3], rear at [-0.2, 0.3, 0.3];\nfree: hub at [0.0, 0.8, 0.3];\n\
                hinge arm: front, rear -> hub;\npoint axle: arm at [0.0, 0.7, 0.3];\ndrive bump: 1000 hub.z;\n\
                wheel: axle -> hub;\n\"\"\"\n";
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    for (options, note) in [
        (&["carmaker"][..], ""),
        (
            &["carsim"],
            "note: a.toml: over the usual range of bump the wheel rises by 0.00012 m; --travel sets another range\n",
        ),
        (&["carsim", "--travel", "-60:60"], ""),
        (
            &["carsim", "--travel", "-0.06:0.06"],
            "note: a.toml: bump is from -0.06 m to 0.06 m: is it in another unit?\n",
        ),
    ] {
        let tables = ["tables", "a.toml", "--out", "-", "--as"];
        let output = run(folder.path(), &[&tables, options].concat());
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        assert_eq!(text(&output.stderr), note, "{options:?}");
    }
}

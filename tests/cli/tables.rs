//! Tables for vehicle models, against a sweep of the same file.

pub(crate) mod live_axle;
mod usual_range;

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

/// As on a motorcycle: no table says that the wheel is on the left, but for the signs.
#[test]
fn a_wheel_in_the_middle_has_no_side_in_words() {
    let file = "unit = \"m\"\nstatements = \"\"\"\n\
                fixed: near at [0.5, 0.1, 0.35], far at [0.5, -0.1, 0.35];\nfree: hub at [0.0, 0.0, 0.3];\n\
                hinge arm: near, far -> hub;\npoint axle: arm at [0.0, -0.1, 0.3];\ndrive bump: hub.z;\n\
                wheel: axle -> hub;\n\"\"\"\nvehicle = { wheel_radius = 0.3, axle = \"rear\" }\n\
                time = { instants = [0.0] }\ndrives = { bump = 0.3 }\n";
    for program in ["carsim", "carmaker"] {
        let text = tables(file, &[program]);
        let title = "# Kinematics of a, wheel in the middle, of a.toml, by";
        assert!(text.contains(title), "{text}");
        assert!(!text.contains("left wheel"), "{text}");
    }
    let carmaker = tables(file, &["carmaker"]);
    let said = "## The side is that of the signs of ty, rx and rz: the form has none for a wheel in the middle\n\
                SuspR.Kin.N = 1\n";
    assert!(carmaker.contains(said), "{carmaker}");
}

//! Input that is refused.

use super::program::{CORNER, edited, example, folder, run, text};

/// The beginning of a line of the published motion, its replacement, the place of the message and a part of the message.
type Case = (&'static str, &'static str, &'static str, &'static str);

#[rustfmt::skip]
const BAD: [Case; 78] = [
    ("unit", "unit = ", ":7:", "value"),
    ("unit", "unit = \"m\"\nspeed = 3", ":8:1", "speed"),
    ("unit", "unit = \"ft\"", ":7:8", "`m`, `mm`, `in`"),
    ("linkage", "linkage = \"strut\"", ":6:11", "attia2003, five_link"),
    ("p11", "", ":9:", "point `p11` has no position; write p11 = [x, y, z] under [points]"),
    ("p2", "p2 = [-1.301, 0.1168, 0.106]\np12 = [0, 0, 0]", ":14:1", "unknown point `p12`"),
    ("p2", "p2 = [-1.301, 0.1168, 0.106]\np2 = [-1.301, 0.1168, 0.106]", ":14:1", "duplicate key"),
    ("p2", "p2 = [nan, 0.1, 0.1]", ":13:6", "`p2`"),
    ("p2", "p2 = [0.1, inf, 0.1]", ":13:6", "`p2`"),
    ("p2", "p2 = [0.1, 0.1]", ":13:6", "3 numbers are wanted here, [x, y, z], not 2\n"),
    ("p2", "p2 = [0,1, 0,2, 0,3]", ":13:6", "3 numbers are wanted here, [x, y, z], not 6; a decimal separator is a point, as in 0.5\n"),
    ("p2", "p2 = [0.1, 0.2, 0.3, 1.0]", ":13:6", "3 numbers are wanted here, [x, y, z], not 4\n"),
    ("p2", "p2 = [-1.396, -0.025, -0.082]", ":13:6", "same place as point `p1`"),
    ("p2", "p2 = { from = \"p1\", offset = [0, 0, 1] }", ":13:6", "`p2` is not a marker"),
    ("p11", "p11 = { from = \"p99\", offset = [0, 0.1, 0] }", ":26:16", "no point `p99`"),
    ("p11", "p11 = { from = \"p11\", offset = [0, 0.1, 0] }", ":26:16", "relative"),
    ("p11", "p11 = { from = \"p8\", ofset = [0, 0.1, 0] }", ":26:", "ofset"),
    ("p11", "p11 = { from = \"p8\", offset = [0, 0, 0] }", ":26:7", "spin axis"),
    ("d7_2", "d7_2 = 0.0", ":31:8", "`d7_2` is 0"),
    ("d7_2", "d7_2 = -0.3", ":31:8", "`d7_2` is -0.3"),
    ("d7_2", "d7_2 = inf", ":31:8", "`d7_2` is inf"),
    ("d7_2", "", ":28:", "`d7_2` is missing"),
    ("d7_2", "d99 = 0.3", ":31:1", "unknown length `d99`"),
    ("p7", "p7 = [-1.3055, 0.38, 0.0405]", ":20:6", "in line: point `p8`"),
    ("instants", "start = 0\nstop = 1\nstep = 0", ":53:8", "the time step is zero; write its length in seconds, as step = 0.01"),
    ("instants", "start = 0\nstop = 1\nstep = -0.1", ":53:8", "leads away from the stop at 1 s; write step = 0.1, or exchange start and stop"),
    ("instants", "start = 0\nstop = 1\nstep = 10", ":53:8", "longer than the motion from 0 s to 1 s"),
    ("instants", "start = 0\nstop = 1\nstep = 1e-9", ":53:8", "at most"),
    ("instants", "start = 0\nstop = inf\nstep = 1", ":52:8", "finite"),
    ("instants", "start = 0\nstop = 1", ":49:", "[time] needs"),
    ("instants", "instants = []", ":51:12", "the list of instants is empty; write times in seconds, as [0.0, 0.5]"),
    ("instants", "instants = [0.0, 0.5, 0.25]", ":51:23", "increase or decrease throughout"),
    ("instants", "instants = [0.0, 0.0]", ":51:18", "increase or decrease throughout"),
    ("instants", "instants = [nan]", ":51:13", "finite"),
    ("theta = [", "", ":53:", "`theta` is missing; write theta = its value, or [value, rate, ...], under [drives]\n"),
    ("p2", "p2 = [0.1 0.2 0.3]", ":13:7", "a comma is missing behind 0.1; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("p2", "p2 = [-0.1, +.2 0.3 ]", ":13:13", "a comma is missing behind +.2; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("p2", "p2 = [0.1, - 0.2, 0.3]", ":13:12", "`- 0.2` is no number; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("p2", "p2 = [0.1; 0.2; 0.3]", ":13:7", "`0.1; 0.2; 0.3` is no number; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("p2", "p2 = (0.1, 0.2, 0.3)", ":13:", "; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("theta = [", "theta = 0.7 0.5", ":55:9", "a comma is missing behind 0.7; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("theta = [", "theta = 0.7, 0.5", ":55:12", "; several numbers are written [0.1, 0.2, 0.3]\n"),
    ("theta = [", "theta = 0,7", ":55:10", "; a decimal separator is a point, as in 0.5\n"),
    ("theta = [", "bump = [0.7]", ":55:1", "unknown drive `bump`"),
    ("theta = [", "theta = []", ":55:9", "coefficient"),
    ("theta = [", "theta = \"far\"", ":55:9", "a number, coefficients of a polynomial of time as [value, rate, ...]"),
    ("theta = [", "theta = [nan]", ":55:9", "finite"),
    ("theta = [", "theta = { mean = 1.2, amplitude = 0.5 }", ":55:9", "missing field `frequency`; write it in Hz, as frequency = 1.5"),
    ("theta = [", "theta = { mean = 1.2, amplitude = 0.5, frequency = 0 }", ":55:52", "drive `theta` needs a positive frequency"),
    ("theta = [", "theta = { mean = 1.2, amplitude = 0.5, frequency = 1e308 }", ":55:52", "drive `theta` has a frequency that is too large"),
    ("theta = [", "theta = { mean = 1.2, amplitude = inf, frequency = 1 }", ":55:35", "finite"),
    ("theta = [", "theta = { mean = 1.2, amplitude = 0.5, frequenc = 1 }", ":55:40", "did you mean `frequency`"),
    ("theta = 1", "theta = nan", ":47:9", "finite"),
    ("theta = 1", "theta = -1.57", ":47:9", "between 0 and pi"),
    ("theta = [", "theta = [7.0]", ":55:9", "between 0 and pi"),
    ("p6", "p6 = [1e200, 0.4, 0.0]", ":18:6", "`p6`"),
    ("p6", "p6 = [-1e308, 0.4, 0.0]", ":18:6", "`p6`"),
    ("p6", "p6 = [1e400, 0.4, 0.0]", ":18:7", "overflow"),
    ("p6", "p6 = [true, 0.4, 0.0]", ":18:7", "boolean"),
    ("p6", "p6 = 1979-05-27", ":18:6", "`from` or `offset`"),
    ("p11", "p11 = [1e308, 0, 0]", ":26:7", "`p11`"),
    ("p11", "p11 = { from = \"p8\", offset = [0, 1e308, 0] }", ":26:7", "`p11`"),
    ("p11", "p11 = { from = \"p8\", offset = [0, nan, 0] }", ":26:7", "`p11`"),
    ("d7_2", "d7_2 = 1e308", ":31:8", "`d7_2`"),
    ("d7_2", "d7_2 = 1e300", ":31:8", "`d7_2` is 1e300, too large to compute with"),
    ("d7_2", "d7_2 = 5e-324", ":31:8", "`d7_2` is 5e-324, too small to compute with"),
    ("d7_6", "d7_6 = 10", ":28:", "do not close at a point: point `p8`"),
    ("d7_2", "d7_2 = 1\n[lengths]", ":32:2", "duplicate key"),
    ("p2", "\"\\u001b[31m\\n\" = [0, 0, 1]", ":13:", "\\u{1b}[31m\\n"),
    ("instants", "start = 0\nstop = 1.95\nstep = 1.95e-7", ":53:8", "10000001 instants; at most 10000000 are allowed: write a longer step"),
    ("instants", "start = 0\nstop = 1e12\nstep = 1", ":53:8", "gives 1e12 instants"),
    ("instants", "start = -1e308\nstop = 1e308\nstep = 1", ":53:8", "at most"),
    ("instants", "start = 0\nstop = 1\nstep = 5e-324", ":53:8", "at most"),
    ("instants", "start = 0\nstop = 1\nstep = nan", ":53:8", "finite"),
    ("instants", "start = 1e17\nstop = 1.0000000000000002e17\nstep = 1", ":53:8", "the time step 1 s is too small to change a time of 1e17 s"),
    ("instants", "instants = [0.0, -inf]", ":51:18", "finite"),
    ("theta = [", "theta = [1e308, 1e308]", ":55:9", "between 0 and pi"),
    ("theta = [", "theta = [0.7, inf]", ":55:9", "finite"),
];

/// An option without effect is a mistake too.
#[test]
fn options_without_effect_are_refused() {
    let folder = folder();
    let corner = CORNER.replace("double_wishbone_pushrod", "macpherson");
    let arm = "statements = \"\"\"\nfixed: front at [0.2, 0, 0], rear at [-0.2, 0, 0];\nfree: tip at [0, 0.5, 0];\n\
               hinge arm: front, rear -> tip;\ndrive bump: tip.z;\n\"\"\"\nunit = \"m\"\ntime = { instants = [0.0] }\n\
               drives = { bump = 0.0 }\n";
    let loaded = format!("{corner}[loads.a]\ncontact = [0.0, 0.0, 4000.0]\n");
    for (name, file) in [("a", &corner), ("arm", &arm.to_owned()), ("l", &loaded)] {
        std::fs::write(folder.path().join(format!("{name}.toml")), file).expect("written");
    }
    for (arguments, expected) in [
        (
            "sheet arm.toml --steer -0.02:0.02",
            "arm.toml: no drive steers",
        ),
        (
            "compare arm.toml arm.toml --steer -0.02:0.02",
            "arm.toml: no drive steers",
        ),
        ("loads l.toml --absolute", "--drive <NAME=FROM:TO:COUNT>"),
        (
            "sensitivities a.toml --samples 10",
            "for the random changes; the file has none",
        ),
        (
            "sensitivities a.toml --seed 2",
            "for the random changes; the file has none",
        ),
        (
            "sensitivities a.toml --of foo --csv -",
            "a.toml: no quantity begins with `foo`",
        ),
        (
            "sweep a.toml --drive bump=0:0:5",
            "FROM and TO are the same; one value is bump=0",
        ),
        (
            "draw a.toml --wheel-radius -1",
            "'-1' for '--wheel-radius <LENGTH>': LENGTH is a positive number in the unit of the file, as 0.3",
        ),
        (
            "tables a.toml --as carmaker --travel -0.1:0.1",
            "--travel is for CarSim only",
        ),
    ] {
        let output = run(folder.path(), &arguments.split(' ').collect::<Vec<_>>());
        assert_eq!(output.status.code(), Some(2), "{arguments}: {output:?}");
        let messages = text(&output.stderr);
        assert!(messages.contains(expected), "{arguments}: {messages}");
        assert!(output.stdout.is_empty(), "{arguments}");
    }
}

#[test]
fn bad_input_is_refused_in_one_line_with_its_place() {
    let folder = folder();
    let mut wrong = Vec::new();
    for (begins, replacement, place, part) in BAD {
        let content = edited(begins, replacement);
        std::fs::write(folder.path().join("bad.toml"), content).expect("written");
        let output = run(folder.path(), &["motion", "bad.toml", "--csv", "bad.csv"]);
        let message = text(&output.stderr);
        let good = output.status.code() == Some(2)
            && output.stdout.is_empty()
            && message.lines().count() == 1
            && message.starts_with(&format!("bad.toml{place}"))
            && message.contains(part)
            && !folder.path().join("bad.csv").exists();
        if !good {
            wrong.push(format!(
                "{replacement}: {:?} {message}",
                output.status.code()
            ));
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
}

#[test]
fn a_body_with_collinear_points_is_refused_at_its_point() {
    let folder = folder();
    let text_of_file = example("published_five_link.toml")
        .replace("[-1287.0, 345.0, 140.0]", "[-1325.5, 412.5, 48.0]");
    std::fs::write(folder.path().join("bad.toml"), text_of_file).expect("written");
    let output = run(folder.path(), &["motion", "bad.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert!(message.starts_with("bad.toml:16:"), "{message}");
    let expected = "body `knuckle` carry the others, and `lower_front_outer`, `upper_front_outer` and `upper_rear_outer` lie in line; \
                    move one of them off the line\n";
    assert!(message.ends_with(expected), "{message}");
}

/// Points of the catalogue, which are in metres, are no points of a file in millimetres.
#[test]
fn missing_points_of_a_file_in_millimetres_are_named() {
    let folder = folder();
    let file = "linkage = \"trailing_arm\"\nunit = \"mm\"\n[points]\nwheel_centre = [0, 752, 303]\n\
                [time]\ninstants = [0.0]\n[drives]\nbump = 303\n";
    std::fs::write(folder.path().join("arm.toml"), file).expect("written");
    let output = run(folder.path(), &["check", "arm.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let message = text(&output.stderr);
    assert!(
        message.starts_with("arm.toml:1:11: [points] does not state `"),
        "{message}"
    );
    assert!(
        message.contains("`axle`") && !message.contains("`wheel_centre`"),
        "{message}"
    );
}

#[test]
fn an_unreadable_file_is_refused() {
    let folder = folder();
    let output = run(folder.path(), &["motion", "none.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    assert!(
        message.starts_with("none.toml: cannot be read"),
        "{message}"
    );
}

#[test]
fn an_empty_listing_path_is_refused_at_its_key() {
    let folder = folder();
    let file =
        "listing = \"\"\nunit = \"m\"\ntime = { instants = [0.0] }\ndrives = { bump = 0.3 }\n";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["check", "a.toml"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(
        text(&output.stderr),
        "a.toml:1:11: `listing` names no file; write the path of a file of statements, as listing = \"corner.linkage\"\n"
    );
}

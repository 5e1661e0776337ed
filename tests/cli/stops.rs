//! A motion that ends before its last instant.

use suspension_core::linkage::Designed;
use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives, Lengths, Model};
use suspension_core::{Build, Signal};

use super::program::{CORNER, edited, folder, rows, run, text};
use crate::support::Reference;

const TWO_SECONDS: &str = "start = 0.0\nstop = 2.0\nstep = 0.05";

#[test]
fn rows_up_to_a_lock_are_kept() {
    let folder = folder();
    let path = folder.path().join("two.toml");
    std::fs::write(path, edited("instants", TWO_SECONDS)).expect("written");
    let arguments = ["motion", "two.toml", "--csv", "two.csv", "--plots", "."];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr).lines().last().expect("a message");
    for expected in [
        "t = 2 s",
        "theta = 2.2",
        "t = 1.97837 s",
        "theta = 2.17843 rad",
        "the drive `theta` locks at",
        "`suspension range two.toml` shows how far each drive reaches and what limits it",
        "40 rows",
    ] {
        assert!(
            message.contains(expected),
            "{expected} is not in: {message}"
        );
    }
    let table = std::fs::read(folder.path().join("two.csv")).expect("a table");
    assert_eq!(table.last(), Some(&b'\n'));
    let table = rows(&table);
    assert_eq!(table.len(), 40);
    assert_eq!(table[39]["t_s"], 1.95);
    let last = Reference::load().rows.len() - 1;
    let difference = table[39]["p6_z"] - Reference::load().vector(last, "p6_").z;
    assert!(difference.abs() < 5e-15, "{difference:e}");
    let plots = ["height", "toe", "camber", "caster", "kingpin"];
    for file in plots.map(|plot| format!("two_{plot}.svg")) {
        assert!(folder.path().join(file).exists());
    }
    let files = std::fs::read_dir(folder.path()).expect("a folder").count();
    assert_eq!(files, 2 + plots.len(), "nothing temporary is left");
}

#[test]
fn a_first_instant_out_of_reach_gives_exit_code_3() {
    let folder = folder();
    let path = folder.path().join("a.toml");
    std::fs::write(path, edited("theta = [", "theta = [2.2]")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml", "--csv", "a.csv"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    assert!(message.contains("theta = 2.17843"), "{message}");
    assert!(
        message.contains("t = 0 s with theta = 2.2 rad,"),
        "{message}"
    );
}

#[test]
fn times_in_messages_are_rounded() {
    let cases = [
        ("start = 0.0\nstop = 2.0\nstep = 1e-4", "t = 1.9784 s"),
        ("start = 0.0\nstop = 2.0\nstep = 1e-4", "up to t = 1.9783 s"),
        ("instants = [0.0, 1e300]", "t = 1e300 s"),
        ("start = 0.0\nstop = 1e300\nstep = -1.0", "at 1e300 s"),
        ("start = 0.0\nstop = 1.0\nstep = 1e-300", "step 1e-300 s"),
        ("instants = [0.0, 1e300, 0.1]", "follows 1e300 s"),
    ];
    let folder = folder();
    for (time, expected) in cases {
        std::fs::write(folder.path().join("a.toml"), edited("instants", time)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let message = text(&output.stderr);
        assert!(
            message.contains(expected),
            "{expected} is not in: {message}"
        );
    }
}

#[test]
fn the_message_on_points_that_do_not_assemble_mentions_the_unit() {
    let folder = folder();
    let path = folder.path().join("a.toml");
    std::fs::write(path, edited("d6_1", "d6_1 = 445.872")).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert_eq!(message.lines().count(), 1);
    for expected in ["theta = 1.5708 rad", "may not fit together", "unit"] {
        assert!(
            message.contains(expected),
            "{expected} is not in: {message}"
        );
    }
}

const RACK_TOO_FAR: &str = "\
linkage = \"double_wishbone_pushrod\"
unit = \"m\"
time = { instants = [0.0, 1.0] }
[drives]
bump = 0.3
steer = [0.34, RATE]
";

/// The link that a message names, the length that it has, and the length that it would need.
fn misfit(message: &str) -> (&str, f64, f64) {
    let (before, needs) = message
        .split_once(" m and would need ")
        .unwrap_or_else(|| panic!("no link is named: {message}"));
    let (before, has) = before.rsplit_once(": it has ").expect("a length");
    let (before, _) = before.rsplit_once("` is too ").expect("a fault");
    let (_, name) = before.rsplit_once('`').expect("a name");
    let (needs, _) = needs.split_once(" m").expect("a unit");
    let number = |text: &str| text.parse().expect("a number");
    (name, number(has), number(needs))
}

#[test]
fn a_link_that_cannot_reach_is_named_with_the_needed_length() {
    // Just beyond the lock, and far.
    for rate in [0.17, 0.25] {
        assert_the_short_rod_is_named(rate);
    }
}

fn assert_the_short_rod_is_named(rate: f64) {
    let folder = folder();
    let path = folder.path().join("a.toml");
    let motion = RACK_TOO_FAR.replace("RATE", &rate.to_string());
    std::fs::write(path, motion).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let (name, has, needs) = misfit(text(&output.stderr));
    let points = Model::<f64>::design();
    let length = (points.tie_ball - points.rack).norm();
    assert_eq!(name, "tie_rod");
    assert!((has - length).abs() < 1e-6, "{has}");
    let reaches = |tie_rod: f64| {
        let model = Model::new(&points).expect("a regular design");
        let lengths = Lengths {
            tie_rod,
            ..model.lengths()
        };
        let model = model.with_lengths(&lengths).expect("closed bodies");
        let mut corner = Corner::assembled(model, &points).expect("near by");
        let drives = Drives {
            bump: 0.3,
            steer: 0.34 + rate,
        };
        corner.step(1.0, Signal::still(drives)).is_ok()
    };
    // The rack pushes the ball joint to its limit: a shorter rod is needed.
    assert!(!reaches(length), "{has}");
    assert!(!reaches(needs + 1e-6) && reaches(needs - 1e-6), "{needs}");
}

/// A longer link at a driven angle would have another height at that angle: the message names the other link, with the
/// distance from its end to the circle of the first link's end.
#[test]
fn a_link_at_a_driven_angle_is_not_blamed_for_a_lock() {
    let folder = folder();
    let file = "statements = '''
fixed: a at [0.0, 0.0, 0.3], b at [0.3, 0.5, 0.2];
free: p at [0.05, 0.16, 0.42];
link ap: a -> p;
link bp: b -> p;
drive turn: angle(a -> p, z);
'''
unit = \"m\"
time = { instants = [0.0, 1.0] }
[drives]
turn = [0.949505195260471, -0.0516]
";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["motion", "a.toml"]);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let length = (0.05_f64.powi(2) + 0.16_f64.powi(2) + 0.12_f64.powi(2)).sqrt();
    let (sine, cosine) = (0.949_505_195_260_471_f64 - 0.0516).sin_cos();
    let across = 0.3_f64.hypot(0.5) - length * sine;
    let needs = across.hypot(0.3 + length * cosine - 0.2);
    let messages = text(&output.stderr);
    let expected = format!(
        "`bp` is too short: it has 0.47592 m and would need {needs:.6} m at the place asked for"
    );
    assert!(messages.contains(&expected), "{expected}: {messages}");
}

/// No link is too long or too short: the arm that the drive lifts is perpendicular to the axis of its hinge. Like `range`,
/// motions and sweeps name the hinge.
#[test]
fn a_hinge_that_ends_a_motion_is_named_with_its_axis() {
    let folder = folder();
    let file = "statements = '''
fixed: inner at [0.0, 0.2, 0.3], outer at [0.0, 0.4, 0.3];
free: tip at [-0.3, 0.3, 0.35];
hinge arm: inner, outer -> tip;
drive bump: tip.z;
'''
unit = \"m\"
time = { instants = [0.0, 1.0] }
[drives]
bump = [0.35, 0.3]
";
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let sweep = ["sweep", "a.toml", "--drive", "bump=0:0.3:4"];
    for command in [&["motion", "a.toml"][..], &sweep] {
        let output = run(folder.path(), command);
        let messages = text(&output.stderr);
        let expected = "; `arm` on its hinge `inner`, `outer` reaches no further";
        assert!(messages.contains(expected), "{messages}");
    }
}

/// At a lock every drive that moves turns: the one that leads into it is named, with the link that is at its limit. With the other
/// drive held, `range` finds the tie rod's limit 160.9 mm from the design.
#[test]
fn of_several_drives_the_one_that_leads_into_the_lock_is_named() {
    let folder = folder();
    for (bump, steer, expected) in [
        (
            "[0.3, 0.001]",
            "[0.34, 0.9]",
            "the drive `steer` locks at +0.16",
        ),
        (
            "[0.3, 0.9]",
            "[0.34, 0.001]",
            "the drive `bump` locks at +0.13",
        ),
    ] {
        let file = format!(
            "linkage = 'double_wishbone_pushrod'\nunit = 'm'\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.1\n[drives]\nbump = {bump}\n\
             steer = {steer}\n"
        );
        std::fs::write(folder.path().join("a.toml"), file).expect("written");
        let output = run(folder.path(), &["motion", "a.toml"]);
        let message = text(&output.stderr);
        assert!(message.contains(expected), "{message}");
        assert!(message.contains("` is too long: it has"), "{message}");
    }
}

/// With the rack 2 m further the tie rod would have to be longer, but what ends the rack's travel is the same as for 0.2 m.
#[test]
fn a_lock_has_the_same_cause_however_far_the_place_asked_for_is_beyond() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    for (far, lengths) in [("0.2", true), ("2", false)] {
        let drive = format!("steer=0:{far}:2");
        let output = run(folder.path(), &["sweep", "a.toml", "--drive", &drive]);
        let message = text(&output.stderr);
        assert!(message.contains("; `tie_rod` is too long"), "{message}");
        assert_eq!(message.contains("would need"), lengths, "{message}");
    }
}

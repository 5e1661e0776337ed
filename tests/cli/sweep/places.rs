//! The places that a sweep reaches.

use std::collections::BTreeMap;

use super::super::program::{CORNER, folder, rows, run, text};

#[test]
fn places_beyond_a_lock_are_omitted_and_counted() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let arguments = ["sweep", "a.toml", "--drive", "steer=-0.2:0.2:5"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    let lines: Vec<_> = message
        .lines()
        .skip_while(|line| !line.starts_with("a.toml: "))
        .collect();
    let [count, first, other, advice] = lines[..] else {
        panic!("how many, a line for a lock either way, and what to do: {message}");
    };
    assert_eq!(
        count,
        "a.toml: 3 of 5 places are out of reach from the design position; the 2 others were solved:"
    );
    assert!(
        first.starts_with("  the drive `steer` locks at +"),
        "{first}"
    );
    assert!(first.contains("steer = 0.501278 m"), "{first}");
    assert!(
        other.starts_with("  the drive `steer` locks at -"),
        "{other}"
    );
    assert_eq!(
        advice,
        "  `suspension range a.toml` shows how far each drive reaches and what limits it"
    );
    let table = std::fs::read(folder.path().join("out/a_sweep.csv")).expect("a table");
    assert_eq!(rows(&table).len(), 2);
}

#[test]
fn a_sweep_that_reaches_no_place_leaves_an_earlier_table_as_it_is() {
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), CORNER).expect("written");
    let table = folder.path().join("t.csv");
    std::fs::write(&table, "earlier").expect("written");
    let arguments = ["sweep", "a.toml", "--drive", "steer=0.2", "--csv", "t.csv"];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(3), "{output:?}");
    let message = text(&output.stderr);
    assert!(message.contains("is out of reach"), "{message}");
    assert!(!message.contains("wrote"), "{message}");
    assert_eq!(std::fs::read_to_string(&table).expect("a table"), "earlier");
}

/// The tip of two arms reaches places nearer than their sum and farther than their difference; a straight path may pass
/// either limit.
#[test]
fn every_reachable_place_is_reached_in_any_order_of_the_drives() {
    let file = "statements = '''
fixed: o1 at [0, 0, 0], o2 at [0, 0, 0.2];
free: a at [0.25, 0.16583123951777, 0.0], a2 at [0.25, 0.16583123951777, 0.2], b at [0.35, 0.0, 0.0];
hinge arm: o1, o2 -> a, a2;
body fore: a, a2, b;
drive px: b.x;
drive py: b.y;
'''
unit = \"m\"
time = { instants = [0.0] }
drives = { px = 0.35, py = 0.0 }
";
    let folder = folder();
    std::fs::write(folder.path().join("arm.toml"), file).expect("written");
    let (upper, fore) = (0.3_f64, 0.193_649_167_310_370_84_f64);
    let values = || (0..13).map(|step| -0.45 + 0.075 * f64::from(step));
    let all = values().flat_map(|x| values().map(move |y| f64::hypot(x, y)));
    let within = all.filter(|far| (upper - fore..upper + fore).contains(far));
    let expected = within.count();
    let range = "=-0.45:0.45:13";
    for [one, other] in [["px", "py"], ["py", "px"]] {
        let [first, second] = [one, other].map(|drive| format!("{drive}{range}"));
        let grid = ["--drive", &first, "--drive", &second, "--absolute"];
        let output = run(
            folder.path(),
            &[&["sweep", "arm.toml", "--csv", "-"], &grid[..]].concat(),
        );
        assert_eq!(output.status.code(), Some(3), "{output:?}");
        assert_eq!(rows(&output.stdout).len(), expected, "{one} first");
    }
}

/// A platform on three driven lengths changes its assembly round a cusp of its drives, while the determinant keeps its sign.
#[test]
fn no_place_beyond_a_cusp_is_reached_in_another_assembly() {
    let file = "statements = '''
fixed: a1 at [0, 0, 0], a2 at [1.591, 0, 0], a3 at [0, 1, 0];
free: p1 at [-0.8726595331862909, 1.2175669752170042, 0],
      p2 at [0.0666141680120635, -0.20418578607348953, 0],
      p3 at [1.1999999147867941, 1.0004522296838942, 0];
plane l1: p1 on a1, a2, a3;
plane l2: p2 on a1, a2, a3;
plane l3: p3 on a1, a2, a3;
body platform: p1, p2, p3;
drive r1: length(a1 -> p1);
drive r2: length(a2 -> p2);
drive r3: length(a3 -> p3);
'''
unit = \"m\"
time = { instants = [0.0] }
drives = { r1 = 1.498, r2 = 1.538, r3 = 1.2 }
";
    let folder = folder();
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let places = |drives: [&str; 2]| {
        let grid = drives.map(|drive| ["--drive", drive]).concat();
        let sweep = [&["sweep", "a.toml", "--csv", "-"], &grid[..]].concat();
        let table = rows(&run(folder.path(), &sweep).stdout);
        let place = |row: &BTreeMap<String, f64>| {
            let drives = ["r2_m", "r3_m"].map(|drive| (row[drive] * 1e6).round() as i64);
            (drives, row["p1_x"])
        };
        table.iter().map(place).collect::<BTreeMap<_, _>>()
    };
    let (r2, r3) = ("r2=-1.3:1.3:27", "r3=-1.1:1.4:26");
    let [one, other] = [places([r2, r3]), places([r3, r2])];
    assert!(one.len() > 100 && other.len() > 100);
    for (drives, x) in &one {
        let same = other
            .get(drives)
            .is_none_or(|other| (other - x).abs() < 1e-9);
        assert!(same, "{drives:?}");
    }
}

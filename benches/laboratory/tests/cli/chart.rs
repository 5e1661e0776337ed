//! The chart of all methods.

use std::collections::BTreeSet;
use std::path::Path;

use suspension_laboratory::chart::rows::Row;

use super::program::{folder, run, text};

pub(super) fn table(path: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(path).expect("a table");
    let rows = reader.deserialize().collect::<Result<_, _>>();
    rows.expect("rows of the chart")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a file")
}

const METHODS: [&str; 18] = [
    "nalgebra_lu",
    "dense_lu",
    "generated",
    "bounded_1",
    "bounded_2",
    "bounded_3",
    "absolute",
    "relative",
    "series_2",
    "series_3",
    "series_4",
    "series_5",
    "series_6",
    "series_7",
    "series_8",
    "baked_1e-4",
    "baked_1e-6",
    "baked_1e-8",
];

#[test]
fn the_chart_has_all_rows_of_every_method_in_table_and_page() {
    let folder = folder();
    let output = run(folder.path(), &["chart", "--quick", "--rounds", "2"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let rows = table(&folder.path().join("out/chart.csv"));
    let page = read(&folder.path().join("out/chart.html"));
    let named = |row: &Row| (row.method.clone(), row.scalar.clone(), row.lanes);
    let methods: BTreeSet<_> = rows.iter().map(named).collect();
    for method in METHODS {
        for scalar in ["f64", "f32"] {
            assert!(
                methods.contains(&(method.to_owned(), scalar.to_owned(), 1)),
                "{method}"
            );
        }
    }
    for method in &methods {
        if method.2 > 1 || method.0.ends_with("_vector") {
            continue; // Lanes are refused in steps that need more corrections.
        }
        let of_method = rows.iter().filter(|row| named(row) == *method);
        assert_eq!(of_method.count(), 2 * 3, "{method:?}: steps times outputs");
    }
    for row in &rows {
        assert!(
            row.nanoseconds > 0.0 && row.nanoseconds.is_finite(),
            "{row:?}"
        );
        assert!(row.spread_ns >= 0.0, "{row:?}");
        let errors = [
            row.error_position_m,
            row.error_velocity_m_s,
            row.error_acceleration_m_s2,
        ];
        let computed = match row.outputs.as_str() {
            "position" => 1,
            "velocity" => 2,
            _ => 3,
        };
        assert_eq!(errors.iter().flatten().count(), computed, "{row:?}");
        assert!(
            errors
                .iter()
                .flatten()
                .all(|error| (0.0..10.0).contains(error)),
            "{row:?}"
        );
        assert!(page.contains(&row.name()), "{row:?}");
    }
    for drawing in ["chart.svg", "latency.svg"] {
        let svg = read(&folder.path().join("out").join(drawing));
        assert!(svg.starts_with("<svg") && svg.ends_with("</svg>"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
    let elsewhere =
        page.matches("http").count() - page.matches("http://www.w3.org/2000/svg").count();
    assert_eq!(elsewhere, 0, "the page needs no other file");
}

const RIVALS: &str = "\
method,version,flags,quantity,step_s,nanoseconds,spread_ns,error_position_m,error_velocity_m_s,error_acceleration_m_s2,note
A <rival>,1.2,-O3,step,0.005,2490,12,1e-15,1e-12,1e-10,
A <rival>,1.2,-O3,newton,,775,3,,,,one iteration
";

#[test]
fn measurements_of_other_programs_are_added_to_the_page() {
    let folder = folder();
    std::fs::create_dir(folder.path().join("out")).expect("a folder");
    std::fs::write(folder.path().join("out/rivals.csv"), RIVALS).expect("written");
    let arguments = [
        "chart",
        "--quick",
        "--rounds",
        "1",
        "--csv",
        "elsewhere.csv",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(!table(&folder.path().join("elsewhere.csv")).is_empty());
    assert!(!folder.path().join("out/chart.csv").exists());
    let page = read(&folder.path().join("out/chart.html"));
    assert!(page.contains("<title>A &lt;rival&gt;\n1.2\n-O3"));
    assert!(page.contains("one iteration"));
    std::fs::write(folder.path().join("out/rivals.csv"), "method\nA\n").expect("written");
    let output = run(folder.path(), &["chart", "--quick"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(text(&output.stderr).contains("rivals.csv"), "{output:?}");
}

#[cfg(unix)]
#[test]
fn an_interrupt_keeps_the_completed_measurements() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    use super::program::command;

    let endless = ["chart", "--quick", "--rounds", "1000000000"];
    // The duration of the first round depends on the machine.
    for seconds in [2, 4, 8, 16, 32] {
        let folder = folder();
        let child = command(folder.path())
            .args(endless)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program runs");
        std::thread::sleep(Duration::from_secs(seconds));
        let sent = Command::new("kill")
            .args(["-INT", &child.id().to_string()])
            .status();
        assert!(sent.expect("a signal").success());
        let output = child.wait_with_output().expect("the program ends");
        assert_eq!(output.status.code(), Some(130), "{output:?}");
        let rows = table(&folder.path().join("out/chart.csv")).len();
        let kept = format!("interrupted: {rows} rows were kept");
        assert!(text(&output.stderr).contains(&kept), "{output:?}");
        if rows > 0 {
            assert!(folder.path().join("out/chart.html").exists());
            return;
        }
    }
    panic!("nothing was measured in half a minute");
}

#[test]
fn a_motion_without_steps_or_with_too_many_is_refused() {
    use super::program::edited;

    let folder = folder();
    for time in ["instants = [1.0]", "instants = [0.0, 1e300]"] {
        std::fs::write(folder.path().join("a.toml"), edited("instants", time)).expect("written");
        let output = run(folder.path(), &["chart", "a.toml", "--quick"]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        assert!(
            text(&output.stderr).contains("a.toml: a motion from"),
            "{output:?}"
        );
    }
}

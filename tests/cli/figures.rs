//! The kingpin and camber angles that the paper defines, and its Figs. 4 and 5.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use super::program::{Rows, edited, example, folder, rows, run, text};

type Row = BTreeMap<String, f64>;

/// The coordinates that the paper's formulas name.
struct Printed {
    p6: [f64; 2],
    p8: [f64; 2],
    p11: [f64; 2],
}

impl Printed {
    /// From the names of points 6, 8 and 11.
    fn read(row: &Row, names: [&str; 3]) -> Self {
        let [p6, p8, p11] = names.map(|name| ["y", "z"].map(|axis| row[&format!("{name}_{axis}")]));
        Self { p6, p8, p11 }
    }

    /// Kingpin angle: the line of points 6 and 8.
    fn alpha(&self) -> f64 {
        ((self.p8[0] - self.p6[0]) / (self.p8[1] - self.p6[1])).atan()
    }

    /// Camber angle.
    fn beta(&self) -> f64 {
        (-(self.p8[1] - self.p11[1]) / (self.p8[0] - self.p11[0])).atan()
    }

    fn point_8_is_above_point_6(&self) -> bool {
        self.p8[1] > self.p6[1]
    }
}

/// Holds rows a millisecond apart against the formulas as printed.
fn assert_defined_as_printed(rows: &Rows, names: [&str; 3]) {
    assert_eq!(rows.len(), 1951);
    let mut jumps = Vec::new();
    for pair in rows.windows(2) {
        let [before, now] = [&pair[0], &pair[1]].map(|row| Printed::read(row, names));
        let t = pair[1]["t_s"];
        let [earlier, ours] = [&pair[0], &pair[1]].map(|row| -row["kingpin_rad"]);
        assert!((ours - earlier).abs() < 0.02, "ours is continuous, {t} s");
        let turns = (ours - now.alpha()) / PI;
        let off = (turns - turns.round()).abs() * PI;
        assert!(off < 1e-14, "kingpin angle at {t} s: {off:e}");
        assert_eq!(turns.round() == 0.0, now.point_8_is_above_point_6(), "{t}");
        if now.point_8_is_above_point_6() {
            let point_6_in_negative_y = now.p6[0] < now.p8[0];
            assert_eq!(ours > 0.0, point_6_in_negative_y, "{t} s");
        }
        if (now.alpha() - before.alpha()).abs() > 3.0 {
            jumps.push(t);
            assert!(now.point_8_is_above_point_6() && !before.point_8_is_above_point_6());
        }
        let off = (pair[1]["camber_rad"] - now.beta()).abs();
        assert!(off < 1e-14, "camber at {t} s: {off:e}");
        let top_is_outboard = now.p11[1] < now.p8[1];
        assert_eq!(pair[1]["camber_rad"] > 0.0, top_is_outboard, "{t} s");
    }
    assert_eq!(jumps.len(), 1, "{jumps:?}");
    assert!(
        (jumps[0] - 0.06).abs() < 0.005,
        "as the main job says: {jumps:?}"
    );
}

#[test]
fn kingpin_and_camber_of_both_listings_follow_the_paper() {
    let folder = folder();
    let solve = |content: String| {
        std::fs::write(folder.path().join("a.toml"), content).expect("written");
        rows(&run(folder.path(), &["motion", "a.toml", "--csv", "-"]).stdout)
    };
    let fine = "start = 0.0\nstop = 1.95\nstep = 0.001";
    let published = solve(edited("instants", fine));
    assert_defined_as_printed(&published, ["p6", "p8", "p11"]);
    let five_link =
        solve(example("published_five_link.toml").replace("step = 0.05", "step = 0.001"));
    let names = ["lower_front_outer", "upper_rear_outer", "wheel_centre"];
    assert_defined_as_printed(&five_link, names);
}

/// Heights of the marks of a plot, in the order in which they are drawn.
fn marks(svg: &str) -> Vec<f64> {
    let circles = svg.split("<circle ").skip(1);
    circles
        .map(|circle| {
            let (_, rest) = circle.split_once("cy=\"").expect("a height");
            let (height, _) = rest.split_once('"').expect("a number");
            height.parse().expect("a number")
        })
        .collect()
}

/// Asserts that marks are at `values` on an axis that points upwards.
fn assert_drawn(svg: &str, values: &[f64]) {
    let marks = marks(svg);
    assert_eq!(marks.len(), values.len());
    let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
    let low = (0..values.len()).min_by(by_value).expect("marks");
    let high = (0..values.len()).max_by(by_value).expect("marks");
    let scale = (marks[high] - marks[low]) / (values[high] - values[low]);
    assert!(scale < 0.0, "{scale}");
    for (mark, value) in marks.iter().zip(values) {
        let expected = marks[low] + scale * (value - values[low]);
        assert!((mark - expected).abs() <= 2.0, "{mark} for {value}");
    }
}

#[test]
fn the_run_without_arguments_draws_the_figures_of_the_paper() {
    let folder = folder();
    let output = run(folder.path(), &[]);
    let read = |name: &str| std::fs::read(folder.path().join("out").join(name)).expect("a file");
    let rows = rows(&read("attia2003.csv"));
    let printed: Vec<Printed> = (rows.iter())
        .map(|row| Printed::read(row, ["p6", "p8", "p11"]))
        .collect();
    // Only at the first instant point 8 is below point 6: the branch continues that of the others.
    let alpha = printed.iter().map(|at| {
        let branch = if at.point_8_is_above_point_6() {
            0.0
        } else {
            PI
        };
        (at.alpha() - branch).to_degrees()
    });
    let alpha: Vec<f64> = alpha.collect();
    let beta = printed.iter().map(|at| at.beta().to_degrees());
    let angles: Vec<f64> = alpha.iter().copied().chain(beta).collect();
    let heights: Vec<f64> = printed.iter().map(|at| at.p11[1]).collect();
    assert_drawn(text(&read("attia2003_height.svg")), &heights);
    let svg = read("attia2003_angles.svg");
    assert_drawn(text(&svg), &angles);
    assert!(text(&svg).contains("top outboard positive"));
    let report = text(&output.stdout);
    for (t, (alpha, height)) in (rows.iter().map(|row| row["t_s"])).zip(alpha.iter().zip(&heights))
    {
        let line = format!("  {t:5.2} | {height:11.5} | {alpha:11.3}");
        assert!(report.contains(&line), "{line}\n{report}");
    }
    assert!(report.contains("usual kingpin angle"), "{report}");
}

//! The plots: their texts and curves.

use super::program::{edited, example, folder, run};

/// A text of a plot: its anchor, its alignment, and its content.
struct Label {
    x: f64,
    y: f64,
    anchor: String,
    size: f64,
    text: String,
}

impl Label {
    /// Returns the range from left to right, with letters 0.6 as wide as high.
    fn span(&self) -> [f64; 2] {
        let width = 0.6 * self.size * self.text.chars().count() as f64;
        match self.anchor.as_str() {
            "middle" => [self.x - width / 2.0, self.x + width / 2.0],
            "end" => [self.x - width, self.x],
            _ => [self.x, self.x + width],
        }
    }
}

fn labels(svg: &str) -> Vec<Label> {
    let texts = svg.split("<text ").skip(1);
    texts
        .map(|text| {
            let (head, rest) = text.split_once('>').expect("a tag");
            let attribute = |name: &str| {
                let (_, rest) = head.split_once(&format!("{name}=\"")).expect(name);
                rest.split_once('"').expect(name).0
            };
            let number = |name| attribute(name).parse().expect("a number");
            Label {
                x: number("x"),
                y: number("y"),
                anchor: attribute("text-anchor").to_owned(),
                size: number("font-size"),
                text: rest.split_once('<').expect("text").0.trim().to_owned(),
            }
        })
        .collect()
}

/// Numbers along the axes do not run into each other or into the axes' names.
fn assert_readable(svg: &str, what: &str) {
    let all = labels(svg);
    let (names, numbers): (Vec<&Label>, Vec<&Label>) = all
        .iter()
        .partition(|label| label.text.parse::<f64>().is_err());
    let (below, beside): (Vec<&Label>, Vec<&Label>) =
        numbers.iter().partition(|label| label.anchor == "middle");
    assert!(below.len() > 1 && beside.len() > 1, "{what}");
    for pair in below.windows(2) {
        let [left, right] = [pair[0].span(), pair[1].span()];
        assert!(
            left[1] < right[0],
            "{what}: {} {}",
            pair[0].text,
            pair[1].text
        );
    }
    let name = names
        .iter()
        .find(|label| label.text.ends_with(')') && label.x < 400.0);
    let name = name.expect("the name of the vertical axis");
    for number in beside {
        assert!(
            name.x + name.size < number.span()[0],
            "{what}: {}",
            number.text
        );
    }
    let same = |pair: &[&Label]| pair[0].text == pair[1].text && pair[0].y == pair[1].y;
    assert!(!below.windows(2).any(same), "{what}: a number twice");
}

#[test]
fn labels_of_plots_do_not_overlap() {
    let constant = edited("theta = [", "theta = [0.7]");
    let upright = edited("theta = [", "theta = [1.5707963267948966]");
    let cases = [
        ("as published", example("attia2003.toml")),
        ("in millimetres", example("five_link.toml")),
        ("one instant", edited("instants", "instants = [1.95]")),
        ("the first instant", edited("instants", "instants = [0.0]")),
        (
            "a moment",
            edited("instants", "instants = [1.95, 1.950001]"),
        ),
        ("constant", constant),
        ("constant zero", upright),
    ];
    let folder = folder();
    for (what, content) in cases {
        std::fs::write(folder.path().join("a.toml"), content).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--plots", "."]);
        assert_eq!(output.status.code(), Some(0), "{what}: {output:?}");
        for plot in ["a_height.svg", "a_toe.svg", "a_camber.svg", "a_kingpin.svg"] {
            let svg = std::fs::read_to_string(folder.path().join(plot)).expect("a plot");
            assert_readable(&svg, &format!("{what}, {plot}"));
        }
    }
}

#[test]
fn a_wheel_centre_called_wheel_centre_is_labelled_once() {
    let folder = folder();
    for (example_of, name) in [
        ("attia2003.toml", "wheel centre p11"),
        ("five_link.toml", "wheel centre"),
    ] {
        std::fs::write(folder.path().join("a.toml"), example(example_of)).expect("written");
        run(folder.path(), &["motion", "a.toml", "--plots", "."]);
        let svg = std::fs::read_to_string(folder.path().join("a_height.svg")).expect("a plot");
        assert!(
            labels(&svg).iter().any(|label| label.text == name),
            "{name}"
        );
    }
}

/// The title names the only curve; curves of two wheels have a legend.
#[test]
fn the_legend_does_not_repeat_the_title() {
    for (file, legend) in [
        ("five_link.toml", &[][..]),
        (
            "front_and_rear_axle.toml",
            &[
                "front_left toe angle",
                "front_right toe angle",
                "rear_left toe angle",
                "rear_right toe angle",
            ],
        ),
    ] {
        let folder = folder();
        std::fs::write(folder.path().join("a.toml"), example(file)).expect("written");
        let output = run(folder.path(), &["motion", "a.toml", "--plots", "p"]);
        assert_eq!(output.status.code(), Some(0), "{output:?}");
        let svg = std::fs::read_to_string(folder.path().join("p/a_toe.svg")).expect("a plot");
        let texts = labels(&svg).into_iter().map(|label| label.text);
        let named: Vec<String> = texts.filter(|text| text.contains("toe angle")).collect();
        assert_eq!(named, legend, "{file}");
    }
}

/// The angles of two axles: each wheel's curve has its own colour, and names of wheels are not repeated.
#[test]
fn curves_of_the_wheels_of_a_car_have_distinct_colours() {
    let folder = folder();
    let car = example("front_and_rear_axle.toml");
    std::fs::write(folder.path().join("a.toml"), car).expect("written");
    run(folder.path(), &["motion", "a.toml", "--plots", "."]);
    let svg = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("a plot");
    // The wheels of a twist beam have no kingpin and do not steer.
    for (plot, wheels) in [
        ("toe", 4),
        ("camber", 4),
        ("caster", 2),
        ("kingpin", 2),
        ("steer_angle", 2),
    ] {
        let angles = svg(&format!("a_{plot}.svg"));
        let curves = angles.split("<polyline ").skip(1);
        let colours = curves.filter_map(|curve| curve.split_once("stroke=\"")?.1.split('"').next());
        let colours: std::collections::BTreeSet<&str> =
            colours.filter(|colour| *colour != "#000000").collect();
        assert_eq!(colours.len(), wheels, "{plot}: {colours:?}");
    }
    let heights = svg("a_height.svg");
    let mut names = labels(&heights).into_iter().map(|label| label.text);
    assert!(names.any(|name| name == "front_left wheel centre"));
}

/// Both wheels of an axle have the same toe in heave: one curve is drawn wider than the one over it.
#[test]
fn coinciding_curves_have_different_widths() {
    let folder = folder();
    for (right, widths) in [(0.03, ["40", "16"]), (-0.03, ["16", "16"])] {
        let heave = format!(
            "linkage = \"steered_axle\"\nunit = \"m\"\n[time]\nstart = 0.0\nstop = 1.0\nstep = 0.01\n\
             [drives]\nbump_left = [0.3, 0.03]\nbump_right = [0.3, {right}]\nsteer = 0.34\n"
        );
        std::fs::write(folder.path().join("a.toml"), heave).expect("written");
        run(folder.path(), &["motion", "a.toml", "--plots", "."]);
        let svg = std::fs::read_to_string(folder.path().join("a_camber.svg")).expect("a plot");
        let lines = svg.split("<polyline ").skip(1);
        let lines = lines.filter_map(|line| line.split('>').next());
        let curves = lines.filter(|line| !line.contains("stroke=\"#000000\""));
        let drawn =
            curves.filter_map(|curve| curve.split_once("stroke-width=\"")?.1.split('"').next());
        // Each curve comes once on the plane and once in the legend.
        let mut drawn: Vec<&str> = drawn.collect();
        drawn.sort_unstable();
        let mut expected = [widths, widths].concat();
        expected.sort_unstable();
        assert_eq!(drawn, expected, "{right}");
    }
}

/// The name of an axis for roll contains two drives, and some titles are long; letters are assumed half as wide as high.
#[test]
fn titles_and_labels_of_horizontal_axes_stay_on_their_charts() {
    let folder = folder();
    let axles = include_str!("../../examples/front_and_rear_axle.toml");
    std::fs::write(folder.path().join("a.toml"), axles).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    let page = String::from_utf8(output.stdout).expect("text");
    let mut named = 0;
    for svg in page.split("<svg ").skip(1) {
        let (_, size) = svg.split_once("viewBox=\"0 0 ").expect("a size");
        let (width, _) = size.split_once(' ').expect("a width");
        let width: f64 = width.parse().expect("a number");
        let (svg, _) = svg.split_once("</svg>").expect("an end");
        for name in labels(svg) {
            let is_title = name.text.ends_with(", change from design");
            if !is_title && !name.text.starts_with("change of ") {
                continue;
            }
            let half = 0.25 * name.size * name.text.chars().count() as f64;
            assert!(
                name.x - half > 0.0 && name.x + half < width,
                "{}",
                name.text
            );
            named += 1;
        }
    }
    assert!(named > 100, "{named}");
}

/// The title stands clear of the numbers beside the vertical axis, of which the topmost may be at the upper end.
#[test]
fn titles_of_charts_do_not_touch_numbers() {
    let folder = folder();
    let axle = include_str!("../../examples/live_axle_watt.toml");
    std::fs::write(folder.path().join("a.toml"), axle).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    let page = String::from_utf8(output.stdout).expect("text");
    let charts = page.split("<svg ").skip(1);
    let charts: Vec<Vec<Label>> = charts.map(labels).collect();
    let mut titles = charts.iter().filter_map(|texts| texts.first());
    assert!(titles.any(|title| title.text == "swing arm in the front view"));
    for texts in charts {
        let is_number = |label: &&Label| label.text.parse::<f64>().is_ok();
        let beside = texts.iter().filter(|label| label.anchor == "end");
        let numbers = beside.filter(is_number);
        let top = numbers.map(|label| label.y - label.size / 2.0);
        let top = top.fold(f64::INFINITY, f64::min);
        let title = &texts[0];
        assert!(title.y + 1.2 * title.size < top, "{}", title.text);
    }
}

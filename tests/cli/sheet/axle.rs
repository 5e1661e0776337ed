//! The page of an axle, whose wheels share charts.

use super::super::program::{folder, run, text};

/// The page of a front axle whose wheels reach 87 mm down and 142 mm up, and the messages.
fn sheet(options: &[&str]) -> (String, String) {
    let folder = imported();
    let arguments = [&["sheet", "a.toml", "--out", "-"], options].concat();
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let [page, messages] = [&output.stdout, &output.stderr].map(|bytes| text(bytes).to_owned());
    (page, messages)
}

/// A folder with the motion file of the imported axle, `a.toml`.
fn imported() -> tempfile::TempDir {
    let folder = folder();
    let path = folder.path();
    let table = include_str!("../../../examples/hardpoints.csv");
    std::fs::write(path.join("a.csv"), table).expect("written");
    let output = run(path, &["import", "a.csv", "--axle", "--out", "a.toml"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let motion = std::fs::read_to_string(path.join("a.toml")).expect("a motion file");
    let motion = motion.replace(
        "# wheelbase = ",
        "rack_per_turn = 80.0\nwheelbase = 1550.0 ",
    );
    std::fs::write(path.join("a.toml"), motion).expect("written");
    folder
}

/// The part of a page below a heading.
fn section<'a>(page: &'a str, heading: &str) -> &'a str {
    let heading = format!("<h2>{heading}</h2>");
    let (_, section) = page
        .split_once(&heading)
        .unwrap_or_else(|| panic!("no {heading}"));
    section.split("<h2>").next().expect("a section")
}

/// The texts of an SVG.
fn texts(svg: &str) -> impl Iterator<Item = &str> {
    let texts = svg.split("<text ").skip(1);
    texts.filter_map(|text| Some(text.split_once('>')?.1.split_once('<')?.0.trim()))
}

/// The titles of the charts of a section.
fn titles(section: &str) -> Vec<&str> {
    let charts = section.split("<svg").skip(1);
    charts.filter_map(|chart| texts(chart).next()).collect()
}

/// The numbers at the axes of a chart.
fn numbers(section: &str, title: &str) -> Vec<f64> {
    let mut charts = section.split("<svg").skip(1);
    let chart = charts.find(|chart| texts(chart).next() == Some(title));
    let texts = texts(chart.unwrap_or_else(|| panic!("no {title}")));
    texts.filter_map(|text| text.parse().ok()).collect()
}

#[test]
fn roll_stays_within_the_travel_that_is_asked_for() {
    let (page, messages) = sheet(&["--travel", "-80:130"]);
    let note = "he curves over roll are from -80 to 80, as one wheel moves down as far as the other moves up, and neither leaves --travel";
    assert!(
        messages.contains(&format!("note: a.toml: t{note}\n")),
        "{messages}"
    );
    assert!(page.contains(&format!("<p>T{note}.</p>")), "{page}");
    assert!(!page.contains("The curves are cut short"));
    let greatest = |way: &str| {
        let numbers = numbers(section(&page, way), "total toe").into_iter();
        numbers.fold(0.0, f64::max)
    };
    assert!((100.0..=130.0).contains(&greatest("Over heave")), "{page}");
    assert!((60.0..=80.0).contains(&greatest("Over roll")), "{page}");
}

#[test]
fn a_travel_to_one_side_of_the_design_has_no_roll() {
    let (page, messages) = sheet(&["--travel", "10:50"]);
    let note = "there are no curves over roll, as within --travel no wheel moves both up and down";
    assert!(messages.contains(note), "{messages}");
    assert!(!page.contains("<h2>Over roll</h2>"));
    let (_, messages) = sheet(&["--travel", "-50:50"]);
    assert!(!messages.contains("roll"), "{messages}");
}

#[test]
fn charts_that_would_show_nothing_are_left_out_or_show_the_change() {
    let (page, _) = sheet(&[]);
    let [heave, roll, steer] =
        ["Over heave", "Over roll", "Over steer"].map(|way| section(&page, way));
    let zero = "angle of the steering wheel";
    for section in [heave, roll] {
        let begins = "<p>Zero throughout, without a chart: ";
        let (_, note) = section.split_once(begins).expect("a note");
        let (note, _) = note.split_once(".</p>").expect("its end");
        assert!(note.split(", ").any(|name| name == zero), "{note}");
        assert!(!titles(section).contains(&zero));
        for title in ["wheel centre y", "contact point y"] {
            let title = format!("{title}, change from design");
            let numbers = numbers(section, &title);
            // Those across are up to 60 mm.
            assert!(
                !numbers.is_empty() && numbers.iter().all(|number| number.abs() <= 100.0),
                "{numbers:?}"
            );
        }
        assert!(
            titles(section).contains(&"roll camber"),
            "{:?}",
            titles(section)
        );
    }
    assert!(titles(steer).contains(&zero));
    let of_wheels = "height of the roll centre above the ground";
    assert!(titles(heave).contains(&of_wheels));
    assert!(!titles(roll).contains(&of_wheels));
    assert!(titles(roll).contains(&"roll centre of the axle z"));
}

/// The wheels of a twist beam keep their y in heave.
#[test]
fn charts_of_constants_are_left_out() {
    let folder = folder();
    let file = include_str!("../../../examples/twist_beam.toml");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let heave = section(text(&output.stdout), "Over heave");
    let begins = "<p>Constant throughout, without a chart: ";
    let (_, note) = heave.split_once(begins).expect("a note");
    let (note, _) = note.split_once(".</p>").expect("its end");
    let constant: Vec<&str> = note.split(", ").collect();
    for title in ["wheel centre y", "contact point y", "track"] {
        assert!(constant.contains(&title), "{note}");
        let mut titles = titles(heave).into_iter();
        assert!(!titles.any(|drawn| drawn.starts_with(title)), "{title}");
    }
    assert!(titles(heave).contains(&"wheel centre x"));
}

/// The left wheel's curve of this height passes through infinity between two places with small values, the right one's does
/// not: both are cut and drawn.
#[test]
fn curves_of_both_wheels_with_a_pole_are_cut() {
    let folder = folder();
    let file = include_str!("../../../examples/live_axle_panhard.toml");
    std::fs::write(folder.path().join("a.toml"), file).expect("written");
    let output = run(folder.path(), &["sheet", "a.toml", "--out", "-"]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let heave = section(text(&output.stdout), "Over heave");
    let note = "<p>Cut where they are near infinity: instant centre in the side view x, instant centre in the side view z, \
                swing arm in the side view. ";
    assert!(heave.contains(note), "{heave}");
    assert!(!heave.contains("Left out"), "{heave}");
    let mut charts = heave.split("<svg").skip(1);
    let title = "instant centre in the side view z";
    let chart = charts.find(|chart| texts(chart).any(|text| text == title));
    let names: Vec<&str> = texts(chart.expect("a chart")).collect();
    assert!(names.ends_with(&["left", "right"]), "{names:?}");
}

/// Static toe of 0.2 deg makes the percentage run to hundreds at small steer angles.
#[test]
fn the_ackermann_percentage_is_drawn_from_five_degrees_of_steer() {
    let (page, _) = sheet(&[]);
    let steer = section(&page, "Over steer");
    let note = "<p>Ackermann percentage: left out where a wheel is steered by less than 5 deg, as static toe determines it there. \
                suspension sweep writes all values.</p>";
    assert!(steer.contains(note), "{steer}");
    let numbers = numbers(steer, "Ackermann percentage");
    assert!(numbers.len() > 5, "{numbers:?}");
    assert!(
        numbers.iter().all(|number| number.abs() < 200.0),
        "{numbers:?}"
    );
    assert!(!section(&page, "Over heave").contains(note));
}

#[test]
fn compare_says_what_its_curves_leave_out() {
    let folder = imported();
    let arguments = [
        "compare", "a.toml", "a.toml", "--travel", "-80:130", "--html", "c.html",
    ];
    let output = run(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let page = std::fs::read_to_string(folder.path().join("c.html")).expect("a page");
    for note in [
        "Ackermann percentage: left out where a wheel is steered by less than 5 deg",
        "the curves over roll are from -80 to 80, as one wheel moves down as far as the other moves up",
    ] {
        assert!(text(&output.stdout).contains(note), "{output:?}");
        assert!(page.contains(note), "{page}");
    }
}

#[test]
fn the_dampers_of_both_wheels_share_a_chart_and_a_row() {
    let (page, _) = sheet(&[]);
    for way in ["heave", "roll"] {
        let section = section(&page, &format!("Over {way}"));
        for title in ["damper", &format!("motion ratio: damper per {way}")] {
            let mut charts = section.split("<svg").skip(1);
            let chart = charts.find(|chart| texts(chart).next() == Some(title));
            let chart = chart.unwrap_or_else(|| panic!("no {title}"));
            for wheel in ["left", "right"] {
                assert_eq!(texts(chart).filter(|text| *text == wheel).count(), 1);
            }
        }
        let alone = titles(section);
        assert!(!alone.iter().any(|title| title.contains("_damper")));
    }
    assert!(
        page.contains("<td rowspan=\"2\">damper</td><td>left</td>"),
        "{page}"
    );
}

#[test]
fn the_charts_that_are_looked_at_first_stand_first() {
    let (page, _) = sheet(&[]);
    let heave = titles(section(&page, "Over heave"));
    let expected = [
        "camber angle (bump camber)",
        "toe angle (bump steer)",
        "height of the roll centre above the ground",
        "roll centre of the axle z",
        "motion ratio: damper per heave",
        "damper",
    ];
    assert_eq!(heave[..expected.len()], expected);
    let steer = titles(section(&page, "Over steer"));
    let expected = ["camber angle", "toe angle", "Ackermann percentage"];
    assert_eq!(steer[..3], expected);
}

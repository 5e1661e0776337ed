//! Tests of drawings.

use super::*;

fn corner() -> Drawing {
    let points = [
        ("lower_front", [0.2, 0.35, 0.16]),
        ("lower_rear", [-0.2, 0.35, 0.16]),
        ("lower_ball", [0.0, 0.70, 0.17]),
        ("upper_ball", [-0.01, 0.66, 0.44]),
    ];
    Drawing {
        names: points.map(|(name, _)| name.to_owned()).into(),
        points: points.map(|(_, at)| Vector3::from(at)).into(),
        axes: Axes::Iso,
        chassis: 2,
        links: vec![[0, 2], [1, 2]],
        racks: vec![Rack {
            ends: [0, 1],
            beyond: Vector3::zeros(),
        }],
        slides: vec![[2, 3, 0]],
        lengths: vec![[1, 3]],
        bars: vec![[0, 3]],
        bodies: vec![vec![2, 3, 1]],
        wheels: vec![Wheel {
            axis: [0, 2],
            kingpin: Some([2, 3]),
            radius: 0.3,
        }],
        others: Vec::new(),
        forces: None,
        unit: "m",
    }
}

fn svg(drawing: &Drawing) -> String {
    drawing.svg(Seen::Oblique, SIZE).expect("points")
}

#[test]
fn a_drawing_names_each_point_once() {
    let svg = svg(&corner());
    for name in corner().names {
        assert_eq!(svg.matches(&name).count(), 1, "{name}");
    }
    assert_eq!(
        svg.matches("<rect").count(),
        1 + 2 + 1,
        "background, two chassis points and the legend"
    );
}

#[test]
fn measured_lengths_are_drawn_dashed() {
    let solid = Drawing {
        lengths: Vec::new(),
        ..corner()
    };
    let lines = |drawing: &Drawing| svg(drawing).matches("<polyline").count();
    assert!(lines(&corner()) > lines(&solid) + 5);
}

#[test]
fn the_legend_of_the_oblique_view_has_what_appears() {
    let bare = Drawing {
        lengths: Vec::new(),
        bars: Vec::new(),
        racks: Vec::new(),
        slides: Vec::new(),
        wheels: Vec::new(),
        ..corner()
    };
    for (name, is_of_bare) in [
        ("chassis point", true),
        ("moving point", true),
        ("link", true),
        ("body", true),
        ("steering rack", false),
        ("slide", false),
        ("measured or driven length", false),
        ("bar or measured angle", false),
        ("kingpin or spin axis", false),
    ] {
        let has = |drawing: &Drawing| svg(drawing).contains(&format!("\n{name}\n"));
        assert!(has(&corner()), "{name}");
        assert_eq!(has(&bare), is_of_bare, "{name}");
        let flat = corner().svg(Seen::Front, SIZE).expect("points");
        assert!(!flat.contains(name), "{name}");
    }
    assert!(!svg(&corner()).contains("\nload\n"));
}

#[test]
fn flat_views_have_axes_and_the_oblique_view_a_scale() {
    for (seen, expected) in [
        (Seen::Oblique, "0.2 m"),
        (Seen::Front, "y (m)"),
        (Seen::Side, "x (m)"),
        (Seen::Top, "x (m)"),
    ] {
        let svg = corner().svg(seen, SIZE).expect("points");
        assert!(svg.contains(expected), "{expected}");
    }
}

#[test]
fn other_positions_of_the_motion_are_drawn() {
    let with_others = Drawing {
        others: vec![corner().points],
        ..corner()
    };
    let lines = |drawing: &Drawing| svg(drawing).matches("<polyline").count();
    assert!(lines(&with_others) > lines(&corner()) + 5);
}

#[test]
fn a_mechanism_without_points_has_no_drawing() {
    assert!(Drawing::default().svg(Seen::Oblique, SIZE).is_none());
}

/// A small pressure was a red line on the wider blue one of the link.
#[test]
fn a_line_with_a_force_has_the_colour_of_the_force_alone() {
    let force = |ends, tension| InLink { ends, tension };
    let loaded = Drawing {
        slides: Vec::new(),
        forces: Some(Forces {
            title: ["load case", "at a place"].map(str::to_owned),
            links: vec![
                force([0, 2], -4.0),
                force([1, 2], -4000.0),
                force([1, 3], -4000.0),
            ],
            acting: Vec::new(),
        }),
        ..corner()
    };
    let svg = svg(&loaded);
    let mut lines = svg.lines().filter(|line| !line.contains("<circle"));
    let own = ["#1F5AA0", "#288246"];
    assert_eq!(
        lines.find(|line| own.iter().any(|own| line.contains(own))),
        None
    );
}

/// A number may overlap a thick bar.
#[test]
fn force_numbers_are_drawn_over_their_bars_in_a_darker_colour() {
    let loaded = Drawing {
        forces: Some(Forces {
            title: ["load case", "at a place"].map(str::to_owned),
            links: vec![InLink {
                ends: [0, 2],
                tension: -4000.0,
            }],
            acting: Vec::new(),
        }),
        ..corner()
    };
    let svg = svg(&loaded);
    let [bar, number] = ["#BE2828", "#5F1414"].map(|colour| svg.find(colour).expect(colour));
    assert_eq!(svg.matches("#5F1414").count(), 1);
    for later in ["lower_front", "lower_ball", "<circle"] {
        let place = svg.find(later).expect(later);
        assert!(bar < place && place < number, "{later}");
    }
}

use super::*;

#[test]
fn labels_of_neighbouring_points_do_not_overlap() {
    let points = [(100, 100), (120, 100), (100, 120)];
    let mut labels = Labels::new(&points, Vec::new(), (300, 300), 1);
    for point in points {
        labels.put("upper_front", point);
    }
    let [a, b, c] = &labels.taken[3..] else {
        panic!("three names")
    };
    assert_eq!([common(a, b), common(a, c), common(b, c)], [0; 3]);
}

/// Without a leader it could be the name of the other point.
#[test]
fn a_label_near_another_point_has_a_leader() {
    let points = [(100, 100), (118, 108)];
    // Lines at the left and above leave only the side of the other point.
    let left = [(40, 60), (98, 100), (40, 140)].map(|end| [(99, 100), end]);
    let lines = [left.as_slice(), &[[(90, 85), (200, 85)]]].concat();
    let mut labels = Labels::new(&points, lines, (300, 300), 1);
    for (name, point) in [("lower_ball", points[0]), ("pushrod_lower", points[1])] {
        let leader = labels.put(name, point).leader;
        let place = *labels.taken.last().expect("a name");
        assert!(
            leader.is_some() || !labels.is_beside_another(&place, point),
            "{name}"
        );
    }
}

#[test]
fn numbers_side_by_side_do_not_overlap_in_a_wide_font() {
    let places = [(100, 100), (150, 100)];
    let mut labels = Labels::new(&[], Vec::new(), (300, 300), 1);
    let left = places.map(|place| {
        labels.put("-2331 N", place);
        labels.taken.last().expect("a number")[0]
    });
    // The width of the text in DejaVu Sans.
    let wide = 3.97 * f64::from(FONT_SIZE);
    let taken = &labels.taken;
    assert!(taken[0][1] != taken[1][1] || f64::from(left[1] - left[0]) >= wide);
}

#[test]
fn labels_of_points_at_the_edges_stay_on_the_sheet() {
    // Outside the sheet the name collides with no other.
    let crowd = |column: i32| (0..20).map(move |row| (60 + 12 * column, 15 * row));
    let mut points: Vec<_> = (0..9).flat_map(crowd).collect();
    points.extend([(10, 100), (290, 100), (10, 120), (290, 120)]);
    let mut labels = Labels::new(&points, Vec::new(), (300, 300), 1);
    for point in points.iter().rev().take(4).chain([&(60, 105)]) {
        labels.put("upper_front", *point);
    }
    let names = &labels.taken[points.len()..];
    assert_eq!(names.len(), 5);
    assert!(
        names
            .iter()
            .all(|[left, _, right, _]| *left >= 0 && *right <= 300)
    );
}

#[test]
fn a_label_does_not_cover_the_link_at_its_point() {
    let point = (150, 150);
    for end in [(300, 150), (0, 150), (150, 300), (300, 300), (290, 140)] {
        let line = [point, end];
        let mut labels = Labels::new(&[point], vec![line], (300, 300), 1);
        labels.put("ball", point);
        let place = labels.taken.last().expect("a name");
        assert_eq!(inside(&line, place), 0.0, "{end:?}");
    }
}

#[test]
fn length_of_a_line_within_a_box_is_its_clipped_length() {
    let square = [0, 0, 10, 10];
    for (line, expected) in [
        ([(-5, 5), (15, 5)], 10.0),
        ([(2, 2), (5, 6)], 5.0),
        ([(-5, 11), (15, 11)], 0.0),
        ([(0, 0), (10, 10)], 200_f64.sqrt()),
        ([(20, 0), (30, 10)], 0.0),
    ] {
        assert!(
            (inside(&line, &square) - expected).abs() < 1e-12,
            "{line:?}"
        );
    }
}

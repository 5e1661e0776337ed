use super::*;

#[test]
fn labels_of_neighbouring_points_do_not_overlap() {
    let points = [(100, 100), (120, 100), (100, 120)];
    let mut labels = Labels::new(&points, Vec::new(), (300, 300), 1);
    for point in points {
        labels.put("upper_front", point);
    }
    let [a, b, c] = [0, 1, 2].map(|name| labels.names[name].place);
    assert_eq!([common(&a, &b), common(&a, &c), common(&b, &c)], [0; 3]);
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
        let Boxed { leader, place, .. } = labels.put(name, point);
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
    let [a, b] = places.map(|place| labels.put("-2331 N", place).place);
    // The width of the text in DejaVu Sans.
    let wide = 3.97 * f64::from(FONT_SIZE);
    assert!(a[1] != b[1] || f64::from(b[0] - a[0]) >= wide);
}

#[test]
fn labels_of_points_at_the_edges_stay_on_the_sheet() {
    // Outside the sheet the name collides with no other.
    let crowd = |column: i32| (0..20).map(move |row| (60 + 12 * column, 15 * row));
    let mut points: Vec<_> = (0..9).flat_map(crowd).collect();
    points.extend([(10, 100), (290, 100), (10, 120), (290, 120)]);
    let mut labels = Labels::new(&points, Vec::new(), (300, 300), 1);
    for point in points.iter().rev().take(4).chain([&(60, 105)]) {
        let [left, _, right, _] = labels.put("upper_front", *point).place;
        assert!(left >= 0 && right <= 300, "{left} to {right}");
    }
}

#[test]
fn a_label_does_not_cover_the_link_at_its_point() {
    let point = (150, 150);
    for end in [(300, 150), (0, 150), (150, 300), (300, 300), (290, 140)] {
        let line = [point, end];
        let mut labels = Labels::new(&[point], vec![line], (300, 300), 1);
        let place = labels.put("ball", point).place;
        assert_eq!(inside(&line, &place), 0.0, "{end:?}");
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

/// The first name has the free place of the second, which has no other.
#[test]
fn a_name_makes_room_for_a_later_one() {
    let points = [(100, 100), (100, 130)];
    // Lines leave the second point only the place above it.
    let lines = vec![
        [(0, 130), (90, 130)],
        [(110, 125), (200, 125)],
        [(0, 145), (200, 145)],
    ];
    let names = ["first", "second"].map(str::to_owned);
    let names: Vec<_> = names.into_iter().zip(points).collect();
    let mut labels = Labels::new(&points, lines, (300, 300), 1);
    let [first, second] = &labels.put_all(&names)[..] else {
        panic!("two names")
    };
    assert_eq!(common(&first.place, &second.place), 0);
}

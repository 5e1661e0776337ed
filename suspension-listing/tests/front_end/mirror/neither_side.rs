//! Messages about parts that belong to one side of the vehicle but are named for neither.

use super::mistakes::{mistakes, only_mistake};

/// A corner of two wishbones, all of it named `left`.
const CORNER: &str = "mirror: left -> right;
fixed: left_low_front, left_low_rear, left_up_front, left_up_rear, left_rack;
free: left_low, left_up, left_tie, left_centre;
hinge left_low_arm: left_low_front, left_low_rear -> left_low;
hinge left_up_arm: left_up_front, left_up_rear -> left_up;
link left_tie_rod: left_rack -> left_tie;
body left_upright: left_low, left_up, left_tie, left_centre;
point left_axle: left_upright;
drive left_bump: left_centre.z;
wheel left: left_axle -> left_centre;";

/// One message begins with the statement that has no image, at its place.
#[test]
fn a_statement_without_an_image_is_named_as_the_cause() {
    for (name, kind, beside, line, symptom) in [
        (
            "left_upright",
            "body",
            "left_low",
            7,
            "no body carries both `right_axle` and `right_centre`; ",
        ),
        (
            "left_axle",
            "marker",
            "left_upright",
            8,
            "no body carries both `axle` and `right_centre`; ",
        ),
        (
            "left_up_arm",
            "hinge",
            "left_up_front",
            5,
            "nothing depends on chassis point `right_up_front`; ",
        ),
        (
            "left_tie_rod",
            "link",
            "left_rack",
            6,
            "nothing depends on chassis point `right_rack`; ",
        ),
        (
            "left_bump",
            "drive",
            "left_centre",
            9,
            "23 equations for 24 unknowns: ",
        ),
    ] {
        let neither = name.replace("left_", "");
        let of = |name: &str| CORNER.replace(name, &neither);
        let mistake = only_mistake(&of(name));
        let expected = format!(
            "{kind} `{neither}` is named for neither side, and `mirror` makes no image of it: name it `{name}`, as `{beside}` is; as it is, \
             {symptom}"
        );
        assert!(
            mistake.message.starts_with(&expected),
            "{}",
            mistake.message
        );
        assert_eq!(mistake.line, line, "{}", mistake.message);
    }
}

/// It would be the only wheel of the axle.
#[test]
fn a_wheel_of_the_mirrored_side_without_a_name_is_refused() {
    let mistake = only_mistake(&CORNER.replace("wheel left:", "wheel:"));
    assert_eq!(
        mistake.message,
        "`wheel` has no name, and `mirror` makes no image of it: name it, and its kingpin, `left`, as in `wheel left: ...`"
    );
    assert_eq!([mistake.line, mistake.column], [10, 1]);
}

/// An image of the same points repeats the statement.
#[test]
fn a_statement_that_is_its_own_image_names_points_of_neither_side() {
    for (points, expected, line) in [
        (
            &["left_rack"][..],
            "drive `left_steer` and its image `right_steer` are of the same point, `rack`, which is named for neither side: name it \
             `left_rack` for each side to have its own, or name the drive without `left` for both sides to share one",
            11,
        ),
        (
            &["left_low", "left_up", "left_tie"],
            "body `left_upright` and its image `right_upright` are of the same points, `low`, `up`, `tie`, which are named for neither side: \
             name them as `left_low` for each side to have its own, or name the body without `left` for both sides to share one",
            7,
        ),
        (
            &["left_rack", "left_tie"],
            "link `left_tie_rod` and its image `right_tie_rod` are of the same points, `rack`, `tie`, which are named for neither side: name \
             them as `left_rack` for each side to have its own, or name the link without `left` for both sides to share one",
            6,
        ),
    ] {
        let text = format!("{CORNER}\ndrive left_steer: left_rack.y;");
        let words = |text: &str, point: &str| {
            let neither = point.replace("left_", "");
            let ends = [",", ";", ":", " ", "."];
            let named = ends.iter().fold(text.to_owned(), |text, end| {
                text.replace(&format!(" {point}{end}"), &format!(" {neither}{end}"))
            });
            named.replace(&format!(" {point}.y"), &format!(" {neither}.y"))
        };
        let text = points.iter().fold(text, |text, point| words(&text, point));
        let reported = mistakes(&text);
        let mistake = reported.iter().find(|mistake| mistake.message == expected);
        assert_eq!(
            mistake.map(|mistake| mistake.line),
            Some(line),
            "{reported:#?}"
        );
    }
}

/// Each end of a link across the vehicle belongs to one side.
#[test]
fn a_link_between_both_sides_is_not_reported_as_of_neither_side() {
    let reported = mistakes(&format!("{CORNER}\nlink left_bar: left_tie -> right_tie;"));
    let messages: Vec<&str> = reported
        .iter()
        .map(|mistake| mistake.message.as_str())
        .collect();
    assert!(
        messages
            .iter()
            .all(|message| !message.contains("neither side:")),
        "{messages:#?}"
    );
    assert!(
        messages[0].starts_with("`left_bar` joins two points whose distance"),
        "{messages:#?}"
    );
}

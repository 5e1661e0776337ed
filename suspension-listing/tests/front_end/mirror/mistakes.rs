//! Messages about mistakes in mirrored listings.

use suspension_listing::include::NoIncludes;
use suspension_listing::text::{self, Mistake};

use super::HALF;

pub(super) fn mistakes(text: &str) -> Vec<Mistake> {
    let read = text::parse(text, "axle", &NoIncludes);
    read.expect_err("no axle").mistakes
}

pub(super) fn only_mistake(text: &str) -> Mistake {
    let mistakes = mistakes(text);
    let [mistake] = mistakes.as_slice() else {
        panic!("{mistakes:?}")
    };
    mistake.clone()
}

#[test]
fn two_sides_of_one_name_are_refused() {
    let mistake = only_mistake(&HALF.replace("left -> right", "left -> left"));
    assert_eq!(
        mistake.message,
        "both sides are named `left`; name the other side by another word, as in `mirror: left -> right;`"
    );
}

/// A mistake on one side is reported once, at its place.
#[test]
fn a_mistake_on_one_side_is_reported_once_at_its_place() {
    let replaced = |from: &str, to: &str| HALF.replace(from, to);
    for (text, line, expected) in [
        (
            replaced("middle -> left_hub", "middle -> left_hob"),
            11,
            "there is no point `left_hob`; ",
        ),
        (
            replaced("middle -> left_hub", "middle -> hub"),
            11,
            "there is no point `hub`; ",
        ),
        (
            format!("{HALF}\nlink left_far: left -> right_hob;"),
            18,
            "there is no point `right_hob`; ",
        ),
        (
            format!("{HALF}\nwheel left: left_hub -> left;"),
            18,
            "`wheel left` is stated twice; ",
        ),
        (
            format!("{HALF}\nbody left_rod_end: bar, left;\npoint left_eye: left_rod_end;"),
            18,
            "body `left_rod_end` has two points, `bar` and `left`, and needs a third",
        ),
        (
            replaced(
                "drive left_bump: left along",
                "drive left_bump: left_front along",
            ),
            8,
            "`left_front` is one of two chassis points of body `arm_left`",
        ),
    ] {
        let mistake = only_mistake(&text);
        assert!(mistake.message.starts_with(expected), "{}", mistake.message);
        assert_eq!(mistake.line, line, "{}", mistake.message);
    }
}

/// The message about a mistake of the image alone says which statement makes the image.
#[test]
fn a_mistake_of_an_image_names_the_mirrored_statement() {
    for (statement, expected) in [
        (
            "fixed: panhard_left at [0.0, 0.5, 0.4];\nlink panhard: panhard_left -> bar;",
            "nothing depends on chassis point `panhard_right`; join it by a link or a body, or remove it; `mirror` makes `panhard_right`, as \
             the image of `panhard_left`: write `left` in the names of parts that both sides have, and neither `left` nor `right` in those of parts that only one side has",
        ),
        (
            "free: right_far at [0.0, -0.5, 0.4];\nlink left_reach: left -> right_far;",
            "there is no point `left_far`; declare it under `fixed:` or `free:`; did you mean `left_rear`? `mirror` makes `left_far`, as the image of `right_far`: \
             write `left` in the names of parts that both sides have, and neither `left` nor `right` in those of parts that only one side has",
        ),
    ] {
        let text = format!("{HALF}\n{statement}");
        let mistakes = mistakes(&text);
        let messages: Vec<&str> = mistakes
            .iter()
            .map(|mistake| mistake.message.as_str())
            .collect();
        assert!(messages.contains(&expected), "{messages:#?}");
    }
}

/// The image of `y = z` is `-y = z`; the exchange of names would make `y = z` of it.
#[test]
fn a_word_of_statements_is_refused_as_the_name_of_a_side() {
    for word in ["x", "z", "at", "length"] {
        let text = format!("mirror: left -> {word};\nfixed: left_a;\n");
        let message = text::parse(&text, "axle", &NoIncludes)
            .unwrap_err()
            .to_string();
        let expected =
            format!("axle:1:17: `{word}` is a word of statements; name the sides by other words");
        assert!(message.contains(&expected), "{message}");
    }
}

#[test]
fn a_sum_of_y_with_other_coordinates_has_no_image() {
    for statement in [
        "couple left_wedge: left.y = tie_left.z;",
        "measure left_sum: 0.5 left_hub.x - left_inner.y;",
    ] {
        let text = format!("{HALF}\n{statement}");
        let mistake = only_mistake(&text);
        let expected =
            "`mirror` makes no image of a sum of y with x or z, whose y would change its sign; ";
        assert!(mistake.message.starts_with(expected), "{}", mistake.message);
        assert_eq!(mistake.line, text.lines().count());
    }
}

/// Its image would be pi minus the angle, with the opposite derivatives.
#[test]
fn an_angle_from_y_has_no_image() {
    let of_drive = HALF.replace(
        "left_bump: left along [0.0, 0.6, 0.8]",
        "left_bump: angle(left_front -> left, y)",
    );
    let of_measure = HALF.replace("length(middle -> left_hub)", "angle(middle -> left_hub, y)");
    for (text, line) in [(of_drive, 8), (of_measure, 11)] {
        let mistake = only_mistake(&text);
        let expected = "`mirror` makes no image of an angle from y, which would become pi minus the angle; state it for each side, ";
        assert!(mistake.message.starts_with(expected), "{}", mistake.message);
        assert_eq!(mistake.line, line);
    }
    let stated = HALF.replace(
        "measure left_spring: length(middle -> left_hub);",
        "measure lean: angle(middle -> left_hub, y);\nmeasure other_lean: angle(right_hub -> middle, y);\n\
         measure left_turn: angle(middle -> left_hub, z);",
    );
    text::parse(&stated, "axle", &NoIncludes).expect("an image of the angle from z alone");
}

/// Statements that name other images are not blamed for these being missing.
#[test]
fn a_statement_that_repeats_an_image_is_the_only_mistake() {
    let statements = [
        "free: right at [0.0, -0.7, 0.2];",
        "measure stance: length(left_hub -> right_hub);",
        "measure base: length(left_front -> right_front);",
    ];
    let text = format!("{HALF}\n{}", statements.join("\n"));
    let mistakes = text::parse(&text, "axle", &NoIncludes)
        .expect_err("stated beside its image")
        .mistakes;
    let messages: Vec<&str> = mistakes
        .iter()
        .map(|mistake| mistake.message.as_str())
        .collect();
    let expected =
        "`mirror` makes `right`, as the image of `left`; remove it here, or give it another name";
    assert_eq!(messages, [expected]);
}

/// Each point that is an image's too gets one message.
#[test]
fn every_point_that_repeats_an_image_is_reported_once() {
    let stated = "fixed: right_front at [0.2, -0.3, 0.2], right_rear at [-0.2, -0.3, 0.0];";
    let mistakes = text::parse(&format!("{HALF}\n{stated}"), "axle", &NoIncludes)
        .expect_err("stated beside their images")
        .mistakes;
    let messages: Vec<String> = mistakes
        .into_iter()
        .map(|mistake| mistake.message)
        .collect();
    let expected = ["front", "rear"].map(|place| {
        format!(
            "`mirror` makes `right_{place}`, as the image of `left_{place}`; remove it here, or give it another name"
        )
    });
    assert_eq!(messages, expected);
}

/// Each statement that is an image's too gets one message, at its place, which says what makes the image.
#[test]
fn a_statement_that_repeats_an_image_names_the_original() {
    for (statement, image, original) in [
        (
            "drive right_bump: right along [0.0, -0.6, 0.8];",
            "drive right_bump",
            "drive left_bump",
        ),
        (
            "link right_rod: rack_right -> bar;",
            "link right_rod",
            "link left_rod",
        ),
        (
            "measure right_spring: length(middle -> right_hub);",
            "measure right_spring",
            "measure left_spring",
        ),
        (
            "link right_spring: middle -> right;",
            "link right_spring",
            "measure left_spring",
        ),
        (
            "wheel right: right_hub -> right;",
            "wheel right",
            "wheel left",
        ),
        (
            "kingpin right: middle -> right;",
            "kingpin right",
            "kingpin left",
        ),
    ] {
        let text = format!("{HALF}\n{statement}");
        let mistake = only_mistake(&text);
        let expected = format!(
            "`mirror` makes `{image}` already, as the image of `{original}`; remove this one, or, where the sides differ, state both under \
             names without `left` and `right`"
        );
        assert_eq!(mistake.message, expected);
        assert_eq!(mistake.line, text.lines().count());
    }
}

/// The message about a statement that does under another name what an image does stands at its own place.
#[test]
fn a_statement_equivalent_to_an_image_is_refused_with_its_removal() {
    for (statement, expected) in [
        (
            "drive other_bump: right.z;",
            "`mirror` makes drive `right_bump`, which prescribes what `other_bump` does; remove `other_bump`",
        ),
        (
            "link spare: bar -> rack_right;",
            "`spare` joins two points whose distance `right_rod` keeps, which `mirror` makes; remove `spare`",
        ),
        (
            "drive other_bump: right along [0.0, 0.6, 0.8];",
            "`mirror` makes drive `right_bump`, which moves `right` too, and a point driven along a direction can have only one drive; remove \
             `other_bump`, or write both as coordinates",
        ),
        (
            "link spare: right_front -> right;",
            "`spare` joins two points whose distance `arm_right` keeps, which `mirror` makes; remove `spare`",
        ),
    ] {
        let half = HALF.replace("left along [0.0, 0.6, 0.8]", "left.z");
        let text = format!("{half}\n{statement}");
        let mistake = only_mistake(&text);
        assert_eq!(mistake.message, expected);
        assert_eq!(mistake.line, text.lines().count());
    }
}

#[test]
fn a_point_with_the_name_of_an_image_names_the_original() {
    let text = format!("{HALF}\nfree: right_rod at [0.0, -0.5, 0.4];");
    let mistake = only_mistake(&text);
    assert_eq!(
        mistake.message,
        "`mirror` makes `link right_rod`, as the image of `link left_rod`; give the point another name"
    );
    assert_eq!([mistake.line, mistake.column], [18, 7]);
}

/// A drive beside its image along the same direction is one mistake.
#[test]
fn a_drive_equal_to_an_image_gives_one_message() {
    let text = format!("{HALF}\ndrive other_bump: right along [0.0, -0.6, 0.8];");
    let mistake = only_mistake(&text);
    assert_eq!(
        mistake.message,
        "`mirror` makes drive `right_bump`, which prescribes what `other_bump` does; remove `other_bump`"
    );
}

#[test]
fn for_a_surplus_equation_beside_a_mirror_the_naming_is_explained() {
    let text = HALF.replace("link stay: middle", "link left_stay: left_front");
    let mistake = only_mistake(&text);
    let expected = "1 too many: remove a link or a drive; `mirror` makes an image of every part with `left` in its name: write `left` in the \
                    names of parts that both sides have, and neither `left` nor `right` in those of parts that only one side has, such as a \
                    Panhard rod";
    assert!(mistake.message.contains(expected), "{}", mistake.message);
}

/// A drag link's ball, named for neither side, holds both knuckles to each other.
#[test]
fn for_a_surplus_equation_a_point_shared_with_the_image_is_named() {
    let text = "mirror: left -> right;
        fixed: left_low, left_high, pitman;
        free: left_end, left_tip, ball;
        hinge left_arm: left_low, left_high -> left_end;
        body left_blade: left_low, left_end, left_tip, ball;
        link drag: pitman -> ball;
        link left_stay: left_high -> left_tip;
        drive left_turn: left_end.z;";
    let mistake = only_mistake(text);
    let expected = "too many: `ball` joins body `left_blade` to its image `right_blade`: name it `left_ball`, and each side has its own";
    assert!(mistake.message.contains(expected), "{}", mistake.message);
}

/// A body in the middle lists the left wheel centre alone; the image of the marker is on it all the same.
#[test]
fn an_image_wheel_without_a_carrier_names_the_body() {
    let text = "mirror: left -> right;
        fixed: left_hanger, front, frame;
        free: left_end, rear, side, left_centre;
        link left_arm: left_hanger -> left_end;
        link rod: front -> rear;
        link panhard: frame -> side;
        body axle: left_end, right_end, rear, side, left_centre;
        point left_hub: axle;
        drive left_bump: left_end.z;
        wheel left: left_hub -> left_centre;";
    let mistakes = mistakes(text);
    let expected = "no body carries both `right_hub` and `right_centre`; `axle` has `right_hub`: list `right_centre` there too, or declare it \
                    as its marker: `point right_centre: axle;`";
    let is_expected = |mistake: &Mistake| mistake.message.starts_with(expected);
    assert!(mistakes.iter().any(is_expected), "{mistakes:?}");
}

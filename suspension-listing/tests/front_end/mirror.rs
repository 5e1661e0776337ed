//! A mirrored listing is the one that states both sides.

use std::collections::BTreeMap;

use suspension_listing::form::Form;
use suspension_listing::include_source::NoIncludes;
use suspension_listing::system::{Point, System};
use suspension_listing::text::{self, Mistake};

use super::catalogue_system;

fn mistakes(text: &str) -> Vec<Mistake> {
    let read = text::parse(text, "axle", &NoIncludes);
    read.expect_err("no axle").mistakes
}

const HALF: &str = "
mirror: left -> right;
fixed: left_front at [0.2, 0.35, 0.16], left_rear at [-0.2, 0.35, -0.0], rack_left, middle at [0.0, 0.0, 0.5];
free:  left at [0.0, 0.7, 0.2], tie_left at [0.1, -0.1, 0.2], bar;
hinge arm_left: left_front, left_rear -> left, tie_left;
link left_rod: rack_left -> bar;
link stay: middle -> bar;
drive left_bump: left along [0.0, 0.6, 0.8];
drive steer: rack_left.y;
/// The length of a spring.
measure left_spring: length(middle -> left_hub);
point left_hub: arm_left at [0.0, 0.8, 0.3];
point left_inner: arm_left at [0.1, -0.2, 0.3];
measure left_skew: left along [0.1, -0.9, 0.2];
wheel left: left_hub -> left;
kingpin left: middle -> left;
";

const WHOLE: &str = "
fixed: left_front at [0.2, 0.35, 0.16], left_rear at [-0.2, 0.35, -0.0], rack_left, middle at [0.0, 0.0, 0.5];
fixed: right_front at [0.2, -0.35, 0.16], right_rear at [-0.2, -0.35, -0.0], rack_right;
free:  left at [0.0, 0.7, 0.2], tie_left at [0.1, -0.1, 0.2], bar;
free:  right at [0.0, -0.7, 0.2], tie_right at [0.1, 0.1, 0.2];
hinge arm_left: left_front, left_rear -> left, tie_left;
hinge arm_right: right_front, right_rear -> right, tie_right;
link left_rod: rack_left -> bar;
link right_rod: rack_right -> bar;
link stay: middle -> bar;
drive left_bump: left along [0.0, 0.6, 0.8];
drive right_bump: right along [0.0, -0.6, 0.8];
drive steer: rack_left.y;
measure left_spring: length(middle -> left_hub);
measure right_spring: length(middle -> right_hub);
measure left_skew: left along [0.1, -0.9, 0.2];
measure right_skew: right along [0.1, 0.9, 0.2];
point left_hub: arm_left at [0.0, 0.8, 0.3];
point right_hub: arm_right at [0.0, -0.8, 0.3];
point left_inner: arm_left at [0.1, -0.2, 0.3];
point right_inner: arm_right at [0.1, 0.2, 0.3];
wheel left: left_hub -> left;
wheel right: right_hub -> right;
kingpin right: middle -> right;
kingpin left: middle -> left;
";

fn positions(points: &[Point]) -> BTreeMap<String, Option<[f64; 3]>> {
    let each = points.iter();
    each.map(|point| (point.named.name.to_string(), point.at))
        .collect()
}

/// What each equation, drive and measure is, by its name.
fn parts(system: &System) -> BTreeMap<String, String> {
    let points = |form: &Form| {
        let sites = form.equations().sites().into_iter();
        sites.map(|site| site.name.to_string()).collect::<Vec<_>>()
    };
    let equations = system.equations.iter().map(|equation| {
        let name = equation.named.name.to_string();
        (name, format!("{:?}", points(&equation.form)))
    });
    let drives = system.drives.iter();
    let drives = drives.map(|drive| {
        (
            format!("drive {}", drive.named.name),
            format!("{:?}", drive.quantity),
        )
    });
    let measures = system.measures.iter();
    let measures = measures.map(|measure| {
        (
            format!("measure {}", measure.named.name),
            format!("{:?}", measure.quantity),
        )
    });
    let markers = system.markers.iter();
    let markers = markers.map(|marker| {
        (
            format!("marker {}", marker.named.name),
            format!("{:?}", marker.at),
        )
    });
    let wheels = system.wheels.iter();
    let wheels = wheels.map(|wheel| {
        let name = wheel.name.as_ref().map(ToString::to_string);
        let points = (&wheel.axis, &wheel.carrier, &wheel.kingpin);
        (
            format!("wheel {}", name.unwrap_or_default()),
            format!("{points:?}"),
        )
    });
    equations
        .chain(wheels)
        .chain(drives)
        .chain(measures)
        .chain(markers)
        .collect()
}

#[test]
fn the_other_side_is_the_image() {
    let [half, whole] =
        [HALF, WHOLE].map(|text| text::parse(text, "axle", &NoIncludes).expect("an axle"));
    assert_eq!(positions(&half.fixed), positions(&whole.fixed));
    assert_eq!(positions(&half.free), positions(&whole.free));
    assert_eq!(parts(&half), parts(&whole));
    let markers = |system: &System| -> BTreeMap<String, Option<[f64; 3]>> {
        let each = system.markers.iter();
        each.map(|marker| (marker.named.name.to_string(), marker.at))
            .collect()
    };
    assert_eq!(markers(&half), markers(&whole));
    let springs = half.measures.iter();
    let springs = springs.filter(|measure| measure.named.name.to_string().ends_with("spring"));
    let springs = springs.map(|measure| &measure.named.docs);
    assert!(
        springs.clone().count() == 2
            && springs
                .into_iter()
                .all(|docs| docs == &[" The length of a spring."])
    );
}

#[test]
fn an_axle_of_the_catalogue_has_both_sides() {
    let axle = catalogue_system("steered_axle");
    let drives = axle.drives.iter().map(|drive| drive.named.name.to_string());
    assert_eq!(
        drives.collect::<Vec<_>>(),
        ["steer", "bump_left", "bump_right"]
    );
    assert_eq!(axle.size(), 32);
}

/// A mistake on one side is reported once, at its place.
#[test]
fn mistakes_are_told_of_what_is_mirrored() {
    let replaced = |from: &str, to: &str| HALF.replace(from, to);
    for (text, line, expected) in [
        (
            replaced("middle -> left_hub", "middle -> left_hob"),
            11,
            "there is no point `left_hob`; ",
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
        let mistakes = mistakes(&text);
        let [mistake] = mistakes.as_slice() else {
            panic!("{mistakes:?}")
        };
        assert!(mistake.message.starts_with(expected), "{}", mistake.message);
        assert_eq!(mistake.line, line, "{}", mistake.message);
    }
}

/// What is wrong with the image alone is told with what makes it.
#[test]
fn a_mistake_of_an_image_alone_says_what_it_is_the_image_of() {
    for (statement, expected) in [
        (
            "fixed: panhard_left at [0.0, 0.5, 0.4];\nlink panhard: panhard_left -> bar;",
            "nothing depends on chassis point `panhard_right`; join it by a link or a body, or remove it; `mirror` makes `panhard_right`, as \
             the image of `panhard_left`: what one side alone has is named without `left` and `right`",
        ),
        (
            "free: right_far at [0.0, -0.5, 0.4];\nlink left_reach: left -> right_far;",
            "there is no point `left_far`; declare it under `fixed:` or `free:`; did you mean `left_rear`? `mirror` makes `left_far`, as the image of `right_far`: \
             what one side alone has is named without `left` and `right`",
        ),
    ] {
        let text = format!("{HALF}\n{statement}");
        let mistakes = mistakes(&text);
        let told: Vec<&str> = mistakes
            .iter()
            .map(|mistake| mistake.message.as_str())
            .collect();
        assert!(told.contains(&expected), "{told:#?}");
    }
}

/// The image of `y = z` is `-y = z`; the exchange of names would make `y = z` of it.
#[test]
fn sides_are_no_words_of_statements() {
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
        let mistakes = text::parse(&text, "axle", &NoIncludes)
            .expect_err("no image")
            .mistakes;
        let [mistake] = mistakes.as_slice() else {
            panic!("{mistakes:?}")
        };
        let expected =
            "`mirror` makes no image of a sum of y with x or z, whose y would change its sign; ";
        assert!(mistake.message.starts_with(expected), "{}", mistake.message);
        assert_eq!(mistake.line, text.lines().count());
    }
}

/// Statements that name other images are not blamed for these being missing.
#[test]
fn an_image_that_is_stated_too_is_the_only_mistake() {
    let statements = [
        "free: right at [0.0, -0.7, 0.2];",
        "measure stance: length(left_hub -> right_hub);",
        "measure base: length(left_front -> right_front);",
    ];
    let text = format!("{HALF}\n{}", statements.join("\n"));
    let mistakes = text::parse(&text, "axle", &NoIncludes)
        .expect_err("stated beside its image")
        .mistakes;
    let told: Vec<&str> = mistakes
        .iter()
        .map(|mistake| mistake.message.as_str())
        .collect();
    let expected =
        "`mirror` makes `right`, as the image of `left`; remove it here, or give it another name";
    assert_eq!(told, [expected]);
}

/// Each statement that is an image's too gets one message, at its place, which says what makes the image.
#[test]
fn a_statement_that_is_stated_beside_its_image_is_told_what_makes_it() {
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
        let mistakes = text::parse(&text, "axle", &NoIncludes)
            .expect_err("stated beside its image")
            .mistakes;
        let [mistake] = mistakes.as_slice() else {
            panic!("{mistakes:?}")
        };
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
fn a_statement_that_does_what_an_image_does_is_told_to_go() {
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
            "`mirror` makes drive `right_bump`, which moves `right` too, and a point driven along a direction takes one drive alone; remove \
             `other_bump`, or write both as coordinates",
        ),
        (
            "link spare: right_front -> right;",
            "`spare` joins two points whose distance `arm_right` keeps, which `mirror` makes; remove `spare`",
        ),
    ] {
        let half = HALF.replace("left along [0.0, 0.6, 0.8]", "left.z");
        let text = format!("{half}\n{statement}");
        let mistakes = text::parse(&text, "axle", &NoIncludes)
            .expect_err("done twice")
            .mistakes;
        let [mistake] = mistakes.as_slice() else {
            panic!("{mistakes:?}")
        };
        assert_eq!(mistake.message, expected);
        assert_eq!(mistake.line, text.lines().count());
    }
}

#[test]
fn a_point_with_the_name_of_an_image_is_told_what_makes_it() {
    let text = format!("{HALF}\nfree: right_rod at [0.0, -0.5, 0.4];");
    let mistakes = mistakes(&text);
    let [mistake] = mistakes.as_slice() else {
        panic!("{mistakes:?}")
    };
    assert_eq!(
        mistake.message,
        "`mirror` makes `link right_rod`, as the image of `link left_rod`; give the point another name"
    );
    assert_eq!([mistake.line, mistake.column], [18, 7]);
}

/// A drive beside its image along the same direction is one mistake.
#[test]
fn a_second_drive_along_a_direction_gets_one_message() {
    let text = format!("{HALF}\ndrive other_bump: right along [0.0, -0.6, 0.8];");
    let mistakes = mistakes(&text);
    let [mistake] = mistakes.as_slice() else {
        panic!("{mistakes:?}")
    };
    assert_eq!(
        mistake.message,
        "`mirror` makes drive `right_bump`, which prescribes what `other_bump` does; remove `other_bump`"
    );
}

#[test]
fn an_equation_too_many_beside_a_mirror_tells_how_one_side_is_named() {
    let text = HALF.replace("link stay: middle", "link left_stay: left_front");
    let mistakes = mistakes(&text);
    let [mistake] = mistakes.as_slice() else {
        panic!("{mistakes:?}")
    };
    let expected = "1 too many: remove a link or a drive; `mirror` makes an image of all that is named `left`: what one side alone has is \
                    named without `left` and `right`, as a Panhard rod";
    assert!(mistake.message.contains(expected), "{}", mistake.message);
}

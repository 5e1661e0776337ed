//! Included statements equal the same statements written by hand.

use std::path::Path;

use suspension_listing::include::{IncludeSource, Wanted};
use suspension_listing::text;

const CORNER: &str = "\
//! A corner, whose rack is the listing's around.
fixed: front at [0.2, 0.35, 0.16], rear at [-0.2, 0.35, 0.16];
free:  /// The end of an arm.
       ball at [0.0, 0.7, 0.2], hub at [0.0, 0.8, 0.3];
hinge arm: front, rear -> ball, hub;
drive bump: ball along [0.0, 0.6, 0.8];
measure z: angle(middle -> ball, z);
point centre: arm at [0.0, 0.75, 0.3];
wheel: centre -> hub;
kingpin: front -> ball;
";

const AXLE: &str = "\
fixed: middle at [0.0, 0.0, 0.5];
mirror: left -> right;
include left: \"corner\";
";

/// The axle, each name written out, moved backwards by 2.5.
const REAR: &str = "\
fixed: rear_middle at [-2.5, 0.0, 0.5];
fixed: rear_left_front at [-2.3, 0.35, 0.16], rear_left_rear at [-2.7, 0.35, 0.16];
free:  /// The end of an arm.
       rear_left_ball at [-2.5, 0.7, 0.2], rear_left_hub at [-2.5, 0.8, 0.3];
fixed: rear_right_front at [-2.3, -0.35, 0.16], rear_right_rear at [-2.7, -0.35, 0.16];
free:  /// The end of an arm.
       rear_right_ball at [-2.5, -0.7, 0.2], rear_right_hub at [-2.5, -0.8, 0.3];
hinge rear_left_arm: rear_left_front, rear_left_rear -> rear_left_ball, rear_left_hub;
drive rear_left_bump: rear_left_ball along [0.0, 0.6, 0.8];
measure rear_left_z: angle(rear_middle -> rear_left_ball, z);
point rear_left_centre: rear_left_arm at [-2.5, 0.75, 0.3];
wheel rear_left: rear_left_centre -> rear_left_hub;
kingpin rear_left: rear_left_front -> rear_left_ball;
hinge rear_right_arm: rear_right_front, rear_right_rear -> rear_right_ball, rear_right_hub;
drive rear_right_bump: rear_right_ball along [0.0, -0.6, 0.8];
measure rear_right_z: angle(rear_middle -> rear_right_ball, z);
point rear_right_centre: rear_right_arm at [-2.5, -0.75, 0.3];
wheel rear_right: rear_right_centre -> rear_right_hub;
kingpin rear_right: rear_right_front -> rear_right_ball;
";

/// Files by name; `axle` in a folder.
struct Files;

impl IncludeSource for Files {
    fn text(&self, wanted: Wanted<'_>) -> Result<String, String> {
        let Wanted::File(path) = wanted else {
            return Err("no catalogue".to_owned());
        };
        let files = [
            ("axles/axle", AXLE),
            ("axles/corner", CORNER),
            ("corner", CORNER),
            ("wrong", "fixed: a;\nlink rod a -> b;\n"),
            (
                "mirrored",
                "mirror: left -> right;\nfixed: left_front, left_rear;\nfree: left_ball;\nhinge left_arm: left_front, left_rear -> left_ball;\n\
                 drive left_bump: left_ball.z;\nlink spare: right_front -> right_ball;\n",
            ),
            (
                "circle",
                "include again: \"circle\"; include more: \"circle\";",
            ),
            ("words", "free: on;"),
            ("about", "free: about;"),
            (
                "raw",
                "fixed: r#type;\nfree: b;\nlink rod: r#type -> b;\ndrive x: b.x;\ndrive y: b.y;",
            ),
            (
                "unknown",
                "fixed: a;\nfree: b;\nlink rod:\n    a -> nowhere;\n",
            ),
            ("outer", "\n include inner: \"unknown\";"),
            (
                "unused",
                "fixed: a,\n  lonely;\nfree: b;\nlink rod: a -> b;\ndrive x: b.x;\ndrive y: b.y;",
            ),
            (
                "typo",
                "fixed: a at [0.2, 0.35, 0.16]; free: hub at [0.0, 0.7, 0.3];\nlink arm: a -> hub;\nmeasure far: length(hubb -> a);\n",
            ),
        ];
        let found = files.iter().find(|(name, _)| Path::new(name) == path);
        found.map_or_else(
            || Err(format!("cannot read {}", path.display())),
            |(_, text)| Ok((*text).to_owned()),
        )
    }
}

fn read(text: &str) -> Result<String, String> {
    let system = text::parse(text, "vehicle", &Files).map_err(|mistakes| mistakes.to_string())?;
    Ok(format!("{system:#?}"))
}

#[test]
fn nested_includes_equal_the_same_statements_written_by_hand() {
    let included = read("include rear: \"axles/axle\" at [-2.5, 0.0, 0.0];").expect("an axle");
    let by_hand = read(REAR).expect("an axle");
    let lines = included.lines().zip(by_hand.lines());
    let unlike: Vec<_> = lines.filter(|(one, other)| one != other).collect();
    assert_eq!(unlike, []);
    assert_eq!(included.len(), by_hand.len());
}

/// A keyword of Rust that follows the prefix of an include is no keyword any more.
#[test]
fn included_raw_identifiers_lose_their_mark() {
    let included = read("include r#fn: \"raw\";").expect("a point");
    let by_hand = "fixed: fn_type; free: fn_b; link fn_rod: fn_type -> fn_b; drive fn_x: fn_b.x; drive fn_y: fn_b.y;";
    assert_eq!(included, read(by_hand).expect("a point"));
}

#[test]
fn a_failed_include_is_refused_at_its_statement() {
    for (text, expected) in [
        ("include left: \"none\";", "vehicle:1:15: cannot read none"),
        (
            "include left: \"no\nn\u{1b}[31me\";",
            "vehicle:1:15: cannot read no\\nn\\u{1b}[31me",
        ),
        ("include left: axle;", "vehicle:1:15: no catalogue"),
        (
            "include left: corner.linkage;",
            "vehicle:1:15: a file stands in quotes, as in `include left: \"corner.linkage\";`",
        ),
        (
            "include left: \"wrong\";",
            "vehicle:1:15: wrong:2:10: expected `:`; a `link` is written `link rod: a -> c;`",
        ),
        (
            "include left: \"circle\";",
            "check whether a listing includes itself",
        ),
        (
            "include front: \"mirrored\";",
            "vehicle:1:16: mirrored:6:6: `front_spare` joins two points whose distance `front_right_arm` keeps, which `mirror` makes; remove \
             `front_spare`",
        ),
        (
            "include left: \"words\";",
            "vehicle:1:9: `words` uses `on`, a word of statements, as a name; choose another name in that file to include it",
        ),
        (
            "include left: \"about\";",
            "`about` uses `about`, a word of statements",
        ),
        (
            "include left \"words\";",
            "vehicle:1:14: expected `:`; an `include` is written",
        ),
        (
            "fixed: middle, left_rear; include left: \"corner\";",
            "vehicle:1:41: corner:2:36: the name `left_rear` is already taken by a chassis point; choose another",
        ),
        (
            "include left: \"unknown\";",
            "vehicle:1:15: unknown:4:10: there is no point `nowhere`",
        ),
        (
            "include far: \"outer\";",
            "vehicle:1:14: outer:2:17: unknown:4:10: there is no point `nowhere`",
        ),
        (
            "include left: \"unused\"; include right: \"unused\";",
            "vehicle:1:40: unused:2:3: nothing depends on chassis point `right_lonely`",
        ),
    ] {
        let message = read(text).expect_err(text);
        assert!(message.contains(expected), "{text}: {message}");
    }
}

#[test]
fn two_includes_of_one_name_give_one_message() {
    let message = read("fixed: middle; include left: \"corner\"; include left: \"corner\";");
    assert_eq!(
        message.expect_err("one name"),
        "vehicle:1:48: the name `left` is already taken by an include; choose another"
    );
}

/// There are sixteen ways down to the depth at which it is refused.
#[test]
fn a_listing_that_includes_itself_twice_gives_one_message() {
    let message = read("include left: \"circle\";").expect_err("a circle");
    assert_eq!(message.matches("includes itself").count(), 1, "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
}

#[test]
fn a_failed_include_gives_no_message_about_its_mirror() {
    let message = read("include left: \"none\"; mirror: left -> right;");
    let message = message.expect_err("no such file");
    assert!(
        message.starts_with("vehicle:1:15: cannot read none"),
        "{message}"
    );
    assert!(
        !message.contains("mirror") && !message.contains("no point"),
        "{message}"
    );
}

#[test]
fn a_wrong_count_of_equations_is_reported_at_the_include() {
    let message = read("fixed: middle; include left: \"corner\"; link more: middle -> left_ball;");
    let message = message.expect_err("a drive too many");
    assert!(
        message.starts_with("vehicle:1:24: 7 equations for 6 unknowns"),
        "{message}"
    );
}

#[test]
fn a_mistake_in_a_mirrored_include_is_reported_once() {
    let message = read("include left: \"typo\"; mirror: left -> right;").expect_err("a typo");
    assert_eq!(
        message.matches("there is no point `hubb`").count(),
        1,
        "{message}"
    );
}

//! The remedies that messages give.

use suspension_listing::include::NoIncludes;
use suspension_listing::text;

use super::texts::{mistakes, only_message};

#[test]
fn for_a_mistyped_name_the_intended_name_is_suggested() {
    let listing = "fixed: lca_front, lca_rear;\nfree: ball, hub, tie;\nlink fore: lca_front -> ball;\n\
                   link aft: lca_rear -> ball;\nbody upright: ball, hub, tie;\ndrive bump: ball.z;\n";
    for (from, to, expected) in [
        (
            "lca_rear ->",
            "lca_reer ->",
            "there is no point `lca_reer`; declare it under `fixed:` or `free:`; did you mean `lca_rear`?",
        ),
        ("link aft", "lnik aft", "`include`; did you mean `link`?"),
        (
            "ball.z",
            "lenght(ball -> lca_rear)",
            "`length(p -> q)`; did you mean `length`?",
        ),
        (
            "drive bump",
            "point axle: uprihgt;\ndrive bump",
            "to carry `axle`; state it as a `body` or a `hinge`, or name three points that carry `axle`; did you mean `upright`?",
        ),
    ] {
        let message = only_message(&listing.replace(from, to));
        assert!(message.ends_with(expected), "{message}");
    }
}

/// A missing point may be a marker if the statement takes markers.
#[test]
fn for_a_missing_point_all_ways_of_declaration_are_listed() {
    let text = "fixed: a;\nfree: p;\nlink rod: a -> p;\ndrive x: p.x; drive y: p.y;\nmeasure far: length(a -> hub);\n";
    assert_eq!(
        only_message(text),
        "there is no point `hub`; declare it under `fixed:` or `free:`, or as a marker by `point hub: BODY;`"
    );
    let text = text.replace("measure far: length(a -> hub)", "link other: a -> hub");
    assert_eq!(
        only_message(&text),
        "there is no point `hub`; declare it under `fixed:` or `free:`"
    );
}

/// The cross of a universal joint whose arms meet in its centre.
#[test]
fn for_an_angle_of_lines_that_meet_the_link_is_given() {
    for lines in ["m -> p, m -> q", "p -> m, m -> q", "m -> p, q -> m"] {
        let text = format!(
            "fixed: a at [0, 0, 0], m at [1, 0, 0], b at [2, 0, 1];\nfree: p at [1, 1, 0], q at [1.5, 0, -0.5];\n\
             hinge one: a, m -> p;\nhinge two: m, b -> q;\nangle cross: {lines};\ndrive turn: p.z;"
        );
        assert_eq!(
            only_message(&text),
            "the lines of `cross` meet in `m`, where a link between their other ends keeps the angle; in place of it write \
             `link cross: p -> q;`"
        );
        let text = text.replace(&format!("angle cross: {lines}"), "link cross: p -> q");
        assert!(text::parse(&text, "corner.linkage", &NoIncludes).is_ok());
    }
}

#[test]
fn for_an_angle_of_an_axis_about_a_line_the_syntax_is_given() {
    let text = "fixed: a, b;\nfree: p;\nlink rod: a -> p;\ndrive y: p.y;\ndrive z: p.z;\n\
                measure turn: angle(a -> p, z about a -> b);";
    let message = only_message(text);
    assert!(
        message.starts_with("an angle about a line must be between two lines; "),
        "{message}"
    );
}

#[test]
fn a_keyword_of_rust_is_refused_as_a_name() {
    for text in [
        "fixed: a;\nfree: box;\n",
        "fixed: a;\nfree: p;\nlink rod: box -> p;\ndrive y: p.y; drive z: p.z;",
        "fixed: a;\nfree: p;\nlink box: a -> p;\ndrive y: p.y; drive z: p.z;",
    ] {
        assert_eq!(
            only_message(text),
            "`box` is a keyword of Rust and cannot be a name; choose another, for example `box_`"
        );
    }
    let renamed =
        "fixed: a, b;\nfree: box_;\nlink one: a -> box_;\nlink two: b -> box_;\ndrive z: box_.z;";
    let read = text::parse(renamed, "corner.linkage", &NoIncludes);
    assert_eq!(read.err().map(|mistakes| mistakes.to_string()), None);
    let text = "fixed: gen, b, c;\nfree: p;\nlink one: gen -> p;\nlink two: b -> p;\ndrive z: p.z;";
    assert!(only_message(text).starts_with("the name `gen` is used by the generated code; "));
}

#[test]
fn for_a_point_on_a_link_a_slide_and_a_link_are_proposed() {
    let link = "fixed: a, b, c;\nfree: p, q;\nlink one: b -> p;\nlink two: c -> p;\nlink rod: a -> p;\ndrive z: q.z;\n";
    let rest = "link up: a -> q;\nlink down: b -> q;\n";
    assert_eq!(
        only_message(&format!("{link}{rest}point seat: rod;")),
        "`rod` is a link, which carries no point; declare `seat` under `free:`, and write \
         `slide seat_on_rod: seat on a -> p;` and `link seat_from_a: a -> seat;`; the position of `seat` must lie on the line of the link"
    );
    let free = format!(
        "{link}{rest}free: seat;\nslide seat_on_rod: seat on a -> p;\nlink seat_from_a: a -> seat;"
    );
    let read = text::parse(&free, "corner.linkage", &NoIncludes);
    assert_eq!(read.err().map(|mistakes| mistakes.to_string()), None);
}

#[test]
fn for_a_missing_equation_a_collinear_body_is_named_as_spinning() {
    let rod = |middle: &str| {
        format!(
            "fixed: a at [0, 0, 0], b at [0, 1, 0];\nfree: p at [0, 0, 1], q at [0, 1, 1], r at {middle};\nbody rod: p, q, r;\n\
             link one: a -> p;\nlink two: b -> q;\nlink three: b -> p;\ndrive y: q.y;\ndrive x: p.x;"
        )
    };
    let message = only_message(&rod("[0, 0.5, 1]"));
    let expected = "; the points of body `rod` lie on one line, about which the body can rotate: in place of the body write `link NAME: p -> q;`, unless another \
                    body keeps these, and for each other point `slide NAME: r on p -> q;` and `link NAME: p -> r;`";
    assert!(message.ends_with(expected), "{message}");
}

#[test]
fn for_a_missing_equation_a_body_on_two_joints_is_named_as_spinning() {
    let with = |statements: &str| {
        format!(
            "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0, 0];\nfree: p at [0, 0, 1], seat at [0.1, 0.5, 1];\n\
             body rod: a, p, seat;\nlink one: b -> p;\ndrive x: p.x;\n{statements}"
        )
    };
    let message = only_message(&with("measure far: length(seat -> c);"));
    let expected = "1 more needed: add a link, a drive, or list a point in its body; body `rod` is held only at `a` and `p` and can \
                    rotate about the line through them: an `angle` or a third attachment prevents that";
    assert!(message.ends_with(expected), "{message}");
    for stops in ["angle still: a -> seat, b -> c;", "link third: c -> seat;"] {
        let read = text::parse(&with(stops), "corner.linkage", &NoIncludes);
        assert_eq!(read.err().map(|mistakes| mistakes.to_string()), None);
    }
    let arm = "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0, 0];\nfree: p at [0, 0, 1], q at [1, 1, 1];\nhinge arm: a, b -> p;\nlink one: c -> q;\n\
               drive y: q.y;\ndrive z: q.z;";
    let message = only_message(arm);
    assert!(!message.contains("spins"), "{message}");
    let loose = with("free: q at [1, 0, 1];\nlink two: c -> q;\nlink three: seat -> q;");
    let message = only_message(&loose);
    let expected = "or list a point in its body; body `rod` can rotate about the line through `a` and `p`: an `angle` or a `plane` for \
                    another of its points prevents that";
    assert!(message.ends_with(expected), "{message}");
}

/// `.5`, `+0.2` and `0x10` are numbers elsewhere; `--0.5` is more likely -0.5 than 0.5.
#[test]
fn a_number_that_begins_otherwise_is_refused_with_how_it_begins() {
    for (text, column) in [
        ("fixed: a at [.5, 0, 0];", 14),
        ("fixed: a at [+0.5, 0, 0];", 14),
        ("fixed: a at [--0.5, 0, 0];", 15),
        ("drive x: p.x - -2 q.x;", 16),
        ("fixed: a at [0x10, 0, 0];", 14),
        ("fixed: a at [-0b1, 0, 0];", 15),
    ] {
        let [mistake, ..] = &mistakes(text)[..] else {
            panic!("{text}: no mistake");
        };
        assert_eq!(
            mistake.message,
            "a coordinate or a factor must be a finite decimal number that begins with a digit or `-`, for example `0.5` or `-1.25`",
            "{text}"
        );
        assert_eq!([mistake.line, mistake.column], [1, column], "{text}");
    }
}

/// Not `identifier`, which is a word of programmers, but how a name is written.
#[test]
fn what_is_no_name_is_refused_with_how_names_are_written() {
    for (text, column) in [
        ("free: 2nd_ball at [0.1, 0.7, 0.2];", 7),
        ("link \"tie rod\": a -> p;", 6),
        ("hinge: a, b -> p;", 6),
    ] {
        let reported = mistakes(text);
        let expected =
            "expected a name, of letters, digits and `_`, that does not begin with a digit; ";
        let found = reported
            .iter()
            .find(|mistake| mistake.message.starts_with(expected));
        let found = found.unwrap_or_else(|| panic!("{text}: {reported:?}"));
        assert_eq!(found.column, column, "{text}");
    }
}

/// As in tables of hardpoints; a `-` between numbers or coordinates is a sign.
#[test]
fn a_dash_in_a_name_is_refused_with_how_names_are_written() {
    for (text, column) in [
        ("fixed: lower-front at [0.1, 0.3, 0.2];", 13),
        ("link tie-rod: a -> p;", 9),
        ("link tie_rod: a -> tie-ball;", 23),
        ("body upright: lower-ball, hub, tie;", 20),
        ("drive bump: wheel-centre.z;", 18),
    ] {
        let [mistake, ..] = &mistakes(text)[..] else {
            panic!("no mistake in {text}");
        };
        let expected = "; a name has `_` where others have `-`";
        assert!(mistake.message.ends_with(expected), "{mistake:?}");
        assert_eq!(mistake.column, column, "{text}");
    }
    let mistyped = &mistakes("link tie_rod: a = p;")[0].message;
    assert!(!mistyped.contains("a name has"), "{mistyped}");
}

#[test]
fn a_missing_word_is_named() {
    let [mistake, ..] = &mistakes("slide s: c, a -> b;")[..] else {
        panic!("no mistake");
    };
    assert_eq!(
        mistake.message,
        "expected `on`; a `slide` is written `slide strut: top on low -> high;`"
    );
    assert_eq!([mistake.line, mistake.column], [1, 11]);
}

/// A drive of a chassis point moves it by the coordinate itself.
#[test]
fn for_a_factor_of_a_driven_chassis_point_the_coordinate_without_it_is_given() {
    let text = "fixed: rack, pivot;\nfree: p;\nlink rod: rack -> p;\nlink arm: pivot -> p;\ndrive lift: p.z;\n";
    for (drive, expected) in [
        (
            "-rack.y",
            "drive `steer` moves chassis point `rack`, whose coordinate takes no factor; to count it the other way write \
             `rack along [0, -1, 0]`",
        ),
        (
            "2 rack.z",
            "drive `steer` moves chassis point `rack`, whose coordinate takes no factor; write `rack.z`",
        ),
    ] {
        assert_eq!(
            only_message(&format!("{text}drive steer: {drive};")),
            expected
        );
    }
    let turned = format!("{text}drive steer: rack along [0, -1, 0];");
    text::parse(&turned, "", &NoIncludes).expect("the drive that the message gives");
}

/// Its distance from other chassis points changes.
#[test]
fn for_a_line_to_a_driven_chassis_point_the_drive_is_named_as_the_cause() {
    let text = "fixed: a, b, pivot;\nfree: p;\nslide rail: p on a -> b;\nlink arm: pivot -> p;\ndrive shift: b.y;\n";
    assert_eq!(
        only_message(text),
        "a line to slide on needs two points at a constant distance, and a drive moves chassis point `b`; name one that no drive moves, \
         or declare both under `free:` in one body"
    );
}

#[test]
fn a_name_of_an_angle_is_taken_by_an_angle() {
    let text = "fixed: a, b;\nfree: p, q;\nhinge left: a, b -> p;\nhinge right: a, b -> q;\nangle cross: a -> p, b -> q;\n\
                measure cross: p.z;\ndrive z: p.z;\n";
    assert_eq!(
        only_message(text),
        "the name `cross` is already taken by an angle; choose another"
    );
}

/// Its angle about the axis is that of a line without length.
#[test]
fn for_a_driven_angle_of_a_line_along_its_axis_a_line_off_the_axis_is_asked_for() {
    let text = |ahead: &str| {
        format!(
            "fixed: a at [0, 0, 0], b at [0, 1, 0], ahead at {ahead};\nfree: p at [0.5, 0.5, 0];\nhinge arm: a, b -> p;\n\
             drive turn: angle(a -> ahead, a -> p about a -> b);\n"
        )
    };
    assert_eq!(
        only_message(&text("[0, 2, 0]")),
        "the line `a -> ahead` lies along the axis `a -> b` at the design position, where its angle about the axis is not determined; \
         name a line off the axis"
    );
    text::parse(&text("[0.001, 2, 0]"), "", &NoIncludes).expect("a line off the axis");
}

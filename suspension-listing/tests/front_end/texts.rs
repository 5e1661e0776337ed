//! Listings as text: what is told of mistakes, and what is refused.

use suspension_listing::include_source::NoIncludes;
use suspension_listing::system::System;
use suspension_listing::text::{self, LONGEST_NUMBER, MOST_BYTES, Mistake};

use super::catalogue_text;

fn mistakes(text: &str) -> Vec<Mistake> {
    let found = text::parse(text, "corner.linkage", &NoIncludes).map(|_| ());
    found.expect_err("a mistake").mistakes
}

/// Where each mistake is: line, column, length.
pub(super) fn places(text: &str) -> Vec<[usize; 3]> {
    let places = mistakes(text).into_iter();
    places
        .map(|mistake| [mistake.line, mistake.column, mistake.length])
        .collect()
}

pub(super) fn only_message(text: &str) -> String {
    let mistakes = mistakes(text);
    let [mistake] = mistakes.as_slice() else {
        panic!("one mistake: {mistakes:?}");
    };
    mistake.message.clone()
}

#[test]
fn a_system_can_be_sent() {
    fn sent<T: Send + Sync>() {}
    sent::<System>();
    sent::<text::Mistakes>();
}

#[test]
fn all_mistakes_are_told_with_their_places() {
    let text = "\
fixed: a, b;
free: p;
// A comment, and a name with other letters: \u{e9}.
link rod: a -> r\u{e9}p;
link rod: b => p;
drive y: p.up;
drive z: p.z;
";
    assert_eq!(places(text), [[5, 13, 1], [6, 12, 2]]);
    let named = "fixed: a;\nfree: p;\nlink rod: a -> q;\ndrive y: p.up; drive z: p.z;";
    assert_eq!(places(named), [[3, 16, 1], [4, 12, 2]]);
    let printed = text::parse(named, "corner.linkage", &NoIncludes).map(|_| ());
    assert_eq!(
        printed.expect_err("two mistakes").to_string(),
        "corner.linkage:3:16: there is no point `q`; declare it under `fixed:` or `free:`\n\
         corner.linkage:4:12: there is no axis `up`; write `x`, `y` or `z`"
    );
}

#[test]
fn a_list_of_points_goes_on_or_ends() {
    let message = only_message("fixed: a at [0, 0, 0]\nfree: p;\nlink rod: a -> p;");
    assert!(
        message.starts_with("expected `,` or `;`; a `fixed` is written"),
        "{message}"
    );
    let message = only_message("fixed: a\nfree: p;\nlink rod: a -> p;");
    assert_eq!(
        message,
        "unexpected `free`; write `,` or `;`, or a design position: `at [x, y, z]`"
    );
}

/// Not where the next statement begins, lines below it may be.
#[test]
fn a_missing_semicolon_is_told_at_the_end_of_its_statement() {
    for (text, expected) in [
        (
            "fixed: a;\nfree: p;\nlink rod: a -> p\n\n// Of the wheel.\ndrive lift: p.z;",
            [3, 17],
        ),
        (
            "fixed: a at [0, 0, 0]\nfree: p;\nlink rod: a -> p;",
            [1, 22],
        ),
        ("fixed: a;\nfree: p;\nlink rod: a -> p q;", [3, 17]),
        (
            "fixed: a;\nfree: p;\nlink rod: a -> p\n// The end.\n",
            [3, 17],
        ),
    ] {
        let told = mistakes(text);
        let mistake = &told[0];
        assert!(mistake.message.contains("`;`; a "), "{mistake:?}");
        let place = [mistake.line, mistake.column, mistake.length];
        assert_eq!(place, [expected[0], expected[1], 0], "{text}");
    }
}

#[test]
fn what_is_missing_at_the_end_is_told_there() {
    let [mistake] = &mistakes("fixed: a;\nfree: p;\nlink rod: a -> p")[..] else {
        panic!("one mistake");
    };
    assert_eq!([mistake.line, mistake.column, mistake.length], [3, 17, 0]);
    assert!(mistake.message.contains("expected `;`"), "{mistake:?}");
    assert!(!mistakes("").is_empty());
}

/// What stands in millimetres in a listing in metres would be taken for a thousand times as far.
#[test]
fn a_number_with_its_unit_is_refused() {
    for (text, number, unit) in [
        ("fixed: a at [700mm, 0, 0];", "700", "mm"),
        ("fixed: a at [0, -0.7m, 0];", "0.7", "m"),
        ("fixed: a at [0, 1.5e3f64, 0];", "1.5e3", "f64"),
        ("fixed: a;\nfree: p;\ndrive y: 2in p.y;", "2", "in"),
    ] {
        let told = mistakes(text);
        let expected = format!(
            "a number has no unit; write `{number}` in place of `{number}{unit}`: all lengths of a listing are in one unit"
        );
        let found = told.iter().find(|mistake| mistake.message == expected);
        let found = found.unwrap_or_else(|| panic!("{text}: {told:?}"));
        assert_eq!(found.length, number.len() + unit.len(), "{text}");
    }
}

#[test]
fn what_is_no_token_is_told() {
    for (text, message) in [
        ("fixed: a at [0, 1, 2;", "`[` is not closed; close it"),
        ("fixed: a];", "`]` closes nothing; remove it"),
        (
            "fixed: a; \u{a7}",
            "what begins with `\u{a7}` cannot be read; remove it",
        ),
        ("/* fixed: a;", "`/*` is not closed; close it by `*/`"),
        ("include b: \"b.linkage;", "`\"` is not closed; close it"),
        (
            "fixed: \0a;",
            "the character '\\0' cannot be read; remove it",
        ),
        ("fixed: a;\n# a rack", "a comment begins with `//`"),
        (
            "fixed: a;\n//! a rack",
            "`//!` may stand above the first statement alone; begin the line with `//`",
        ),
        (
            "include b: \"\";",
            "`b` includes no file; write the path of one of statements, as `include b: \"corner.linkage\";`",
        ),
        (
            "// the rack\rfixed: a;\r\nfree: p;",
            "a line ends by a carriage return alone; end each by a line feed, with or without a carriage return before it",
        ),
    ] {
        assert_eq!(only_message(text), message);
    }
}

#[test]
fn what_is_too_large_is_refused() {
    let long = format!("// {}", "x".repeat(MOST_BYTES));
    assert!(only_message(&long).contains("bytes long; at most 65536 are allowed"));
    let deep = "[".repeat(9) + &"]".repeat(9);
    assert_eq!(
        only_message(&format!("fixed: a at {deep};")),
        "more than 8 brackets within each other"
    );
    let points = |count: usize| {
        let names = (0..count)
            .map(|index| format!("p{index}"))
            .collect::<Vec<_>>();
        names.join(", ")
    };
    let many = format!("fixed: {};\nfree: p;", points(128));
    assert!(only_message(&many).starts_with("129 points; at most 128 are allowed"));
    let unknowns = format!("fixed: a;\nfree: {};", points(21));
    assert_eq!(
        only_message(&unknowns),
        "63 unknowns; at most 60 are allowed in a listing read at run time: state parts that do not meet, as two corners or two \
         axles, in listings of their own, or write it with `linkage!`, which has no such limit"
    );
    let names = format!("fixed: a; free: p; body long: {};", points(129));
    assert!(only_message(&names).starts_with("129 names in one statement"));
    let statements = format!("fixed: a; free: p; {}", "link rod: a -> p;".repeat(257));
    assert!(only_message(&statements).starts_with("257 statements"));
}

/// Points that a body carries and nothing else holds need no unknowns; what a link, a drive or a marker needs stays.
#[test]
fn where_unknowns_are_too_many_points_that_may_be_markers_are_named() {
    let text = |body: &str| {
        let names: Vec<String> = (0..17).map(|index| format!("p{index}")).collect();
        format!(
            "fixed: a;\nfree: b, c, d, e, {};\nlink rod: a -> b;\n{body}\npoint tip: c, b, p0;\n\
             measure gauge: length(a -> d);",
            names.join(", ")
        )
    };
    let said = |body: &str| only_message(&text(body));
    let carried = said("body plate: b, c, d, e, p1;\ndrive bump: p1.z;");
    let way_out = ": `d`, `e` need none where `point d: plate at [x, y, z];` states them, and not `free` and the body; or state parts";
    assert!(carried.contains(way_out), "{carried}");
    // Three points hold the body.
    let few = said("body plate: b, d, e;");
    assert!(few.contains("time: state parts"), "{few}");
    let held = said("body plate: b, c, d, e;\nlink other: a -> d;");
    assert!(
        held.contains(": `e` needs none where `point e: plate"),
        "{held}"
    );
}

// The time that numbers take to read grows with the square of their length.
#[test]
fn a_number_that_would_take_long_is_refused() {
    for digits in [LONGEST_NUMBER + 1, MOST_BYTES - 100] {
        let number = "9".repeat(digits);
        let text = format!("fixed: a at [0.0, {number}, 0.0]; free: b;");
        let all = mistakes(&text);
        let told = all.iter().map(|mistake| mistake.message.as_str());
        assert_eq!(
            told.collect::<Vec<_>>(),
            ["a number of more than 100 characters"]
        );
        assert_eq!((all[0].column, all[0].length), (19, digits));
    }
}

#[test]
fn any_depth_is_refused_without_descending() {
    for bracket in ["(", "[", "{"] {
        assert!(!mistakes(&bracket.repeat(MOST_BYTES)).is_empty());
    }
    let half = MOST_BYTES / 2;
    assert!(!mistakes(&("(".repeat(half) + &")".repeat(half))).is_empty());
}

/// Prefixes of a listing, and listings without one of their characters, are read or refused.
#[test]
fn a_damaged_listing_is_no_danger() {
    let text = catalogue_text("five_link");
    for (index, letter) in text.char_indices().step_by(7) {
        let (before, rest) = text.split_at(index);
        let _ = text::parse(before, "five_link", &NoIncludes);
        let _ = text::parse(
            &[before, &rest[letter.len_utf8()..]].concat(),
            "five_link",
            &NoIncludes,
        );
    }
}

#[test]
fn a_mistyped_name_is_told_the_one_that_was_meant() {
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
            "to carry `axle`; did you mean `upright`?",
        ),
    ] {
        let told = only_message(&listing.replace(from, to));
        assert!(told.ends_with(expected), "{told}");
    }
}

/// Where markers will do, a point that is missing may be one.
#[test]
fn a_missing_point_is_told_all_ways_to_declare_it() {
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

#[test]
fn an_angle_of_an_axis_about_a_line_is_told_how_it_is_written() {
    let text = "fixed: a, b;\nfree: p;\nlink rod: a -> p;\ndrive y: p.y;\ndrive z: p.z;\n\
                measure turn: angle(a -> p, z about a -> b);";
    let message = only_message(text);
    assert!(
        message.starts_with("an angle about a line is one between two lines; "),
        "{message}"
    );
}

#[test]
fn words_that_rust_keeps_to_itself_are_no_names() {
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
fn a_point_on_a_link_is_told_how_it_is_written() {
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
fn a_body_in_line_is_said_to_spin_where_an_equation_is_missing() {
    let rod = |middle: &str| {
        format!(
            "fixed: a at [0, 0, 0], b at [0, 1, 0];\nfree: p at [0, 0, 1], q at [0, 1, 1], r at {middle};\nbody rod: p, q, r;\n\
             link one: a -> p;\nlink two: b -> q;\nlink three: b -> p;\ndrive y: q.y;\ndrive x: p.x;"
        )
    };
    let said = only_message(&rod("[0, 0.5, 1]"));
    let expected = "; the points of body `rod` lie in line, about which it spins: in its place write `link NAME: p -> q;`, unless another \
                    body keeps these, and for each other point `slide NAME: r on p -> q;` and `link NAME: p -> r;`";
    assert!(said.ends_with(expected), "{said}");
}

#[test]
fn a_body_on_two_ball_joints_is_said_to_spin_where_an_equation_is_missing() {
    let with = |statements: &str| {
        format!(
            "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0, 0];\nfree: p at [0, 0, 1], seat at [0.1, 0.5, 1];\n\
             body rod: a, p, seat;\nlink one: b -> p;\ndrive x: p.x;\n{statements}"
        )
    };
    let said = only_message(&with("measure far: length(seat -> c);"));
    let expected = "1 more needed: add a link, a drive, or list a point in its body; body `rod` is held at `a` and `p` alone and spins \
                    about the line through them: an `angle` or a third attachment stops it";
    assert!(said.ends_with(expected), "{said}");
    for stops in ["angle still: a -> seat, b -> c;", "link third: c -> seat;"] {
        let read = text::parse(&with(stops), "corner.linkage", &NoIncludes);
        assert_eq!(read.err().map(|mistakes| mistakes.to_string()), None);
    }
    let arm = "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0, 0];\nfree: p at [0, 0, 1], q at [1, 1, 1];\nhinge arm: a, b -> p;\nlink one: c -> q;\n\
               drive y: q.y;\ndrive z: q.z;";
    let said = only_message(arm);
    assert!(!said.contains("spins"), "{said}");
    let loose = with("free: q at [1, 0, 1];\nlink two: c -> q;\nlink three: seat -> q;");
    let said = only_message(&loose);
    assert!(said.ends_with("or list a point in its body"), "{said}");
}

//! Listings as text: messages about mistakes, and their places.

use suspension_listing::include::NoIncludes;
use suspension_listing::system::System;
use suspension_listing::text::{self, Mistake};

use super::catalogue_text;

pub(super) fn mistakes(text: &str) -> Vec<Mistake> {
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
fn parsed_systems_and_mistakes_are_send_and_sync() {
    fn sent<T: Send + Sync>() {}
    sent::<System>();
    sent::<text::Mistakes>();
}

#[test]
fn all_mistakes_are_reported_with_line_and_column() {
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

/// Statements that cannot be read are mistakes; that two equations do not determine three unknowns is not looked for.
#[test]
fn declared_names_come_from_statements_alone() {
    let read = |text| text::declared(text, "corner.linkage", &NoIncludes);
    let names = read("fixed: a;\nlink rod: a -> p;\nfree: p;\ndrive z: p.z;").expect("names");
    let names = names.iter().map(|(name, kind)| format!("{kind} {name}"));
    assert_eq!(
        names.collect::<Vec<_>>().join(", "),
        "chassis point a, free point p, link rod, drive z"
    );
    let refused = read("fixed: a;\nlink rod: a => p;").map(|_| ());
    let message = refused.expect_err("a mistake").to_string();
    assert!(message.starts_with("corner.linkage:2:13: "), "{message}");
}

#[test]
fn after_a_point_of_a_list_a_comma_or_semicolon_is_expected() {
    let message = only_message("fixed: a at [0, 0, 0] b;\nfree: p;\nlink rod: a -> p;");
    assert!(
        message.starts_with("expected `,` or `;`; a `fixed` is written"),
        "{message}"
    );
    let message = only_message("fixed: a b;\nfree: p;\nlink rod: a -> p;");
    assert_eq!(
        message,
        "unexpected `b`; write `,` or `;`, or a design position: `at [x, y, z]`"
    );
}

/// The statement before the next one is whole, with its points and their images, and the next one is read too.
#[test]
fn mistakes_below_a_missing_semicolon_are_reported() {
    for statement in [
        "fixed: left_b at [0, 0, 0]",
        "fixed: left_b",
        "fixed: left_d, left_b",
        "fixed: left_b;\nlink left_c: left_b -> left_p",
    ] {
        for (next, expected) in [
            (
                "link left_rod: left_b -> left_q;",
                "there is no point `left_q`",
            ),
            (
                "/// A rod.\nlnik left_rod: left_b -> left_p;",
                "unknown statement `lnik`",
            ),
            (
                "free: left_e;\nlink left_rod: left_b -> left_q;",
                "there is no point `left_q`",
            ),
            (
                "wheel left: left_p -> left_q;",
                "there is no point `left_q`",
            ),
        ] {
            let text = format!(
                "mirror: left -> right;\nfixed: left_a;\nfree: left_p;\n{statement}\n{next}\ndrive left_z: left_p.z;\n\
                 link cross: left_p -> right_b;"
            );
            let found = mistakes(&text);
            let [missing, other] = &found[..] else {
                panic!("{text}\n{found:#?}");
            };
            assert!(missing.message.starts_with("expected `;`; "), "{found:#?}");
            assert!(other.message.starts_with(expected), "{found:#?}");
        }
    }
}

/// A statement that cannot be read ends at the next one, if that comes before a semicolon.
#[test]
fn a_statement_that_cannot_be_read_ends_at_the_next_one() {
    let text = "fixed: a;\nfree: p;\nlink rod: a => p\nlink strut: a => p;\nwheel: p => a;";
    let lines: Vec<usize> = mistakes(text).iter().map(|it| it.line).collect();
    assert_eq!(lines, [3, 4, 5]);
}

/// The word of the next statement is then read as a name.
#[test]
fn a_statement_that_ends_too_early_has_one_message() {
    for statement in [
        "fixed: b,",
        "body plate: a, p,",
        "link rod: a ->",
        "mirror: left ->",
    ] {
        for next in ["link strut: a -> p;", "free: q;"] {
            only_message(&format!(
                "fixed: a;\nfree: p;\n{statement}\n{next}\ndrive z: p.z;"
            ));
        }
    }
}

/// A name is no statement, even if it is the word of one.
#[test]
fn a_mistyped_statement_has_one_message() {
    let text = "fixed: a;\nfree: p, q;\nbody plate: a, p, q;\nwheel: p -> q;\nlnik wheel: a -> p;";
    let message = only_message(text);
    assert!(message.starts_with("unknown statement `lnik`"), "{message}");
}

/// The next statement may begin several lines below.
#[test]
fn a_missing_semicolon_is_reported_at_the_end_of_its_statement() {
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
        let reported = mistakes(text);
        let mistake = &reported[0];
        assert!(mistake.message.contains("`;`; a "), "{mistake:?}");
        let place = [mistake.line, mistake.column, mistake.length];
        assert_eq!(place, [expected[0], expected[1], 0], "{text}");
    }
}

#[test]
fn a_semicolon_missing_at_the_end_of_the_text_is_reported_there() {
    let text =
        "fixed: a;\nfree: p;\nlink strut: a -> q;\ndrive y: p.y; drive z: p.z;\nlink rod: a -> p";
    let [mistake, other] = &mistakes(text)[..] else {
        panic!("two mistakes");
    };
    assert!(other.message.contains("no point `q`"), "{other:?}");
    assert_eq!([mistake.line, mistake.column, mistake.length], [5, 17, 0]);
    assert!(mistake.message.contains("expected `;`"), "{mistake:?}");
    assert!(!mistakes("").is_empty());
}

/// Millimetres in a listing in metres would be taken for a thousand times the length.
#[test]
fn a_number_with_a_unit_is_refused() {
    for (text, number, unit) in [
        ("fixed: a at [700mm, 0, 0];", "700", "mm"),
        ("fixed: a at [0, -0.7m, 0];", "0.7", "m"),
        ("fixed: a at [0, 1.5e3f64, 0];", "1.5e3", "f64"),
        ("fixed: a;\nfree: p;\ndrive y: 2in p.y;", "2", "in"),
    ] {
        let reported = mistakes(text);
        let expected = format!(
            "a number may not have a unit; write `{number}` in place of `{number}{unit}`: all lengths of a listing are in one unit"
        );
        let found = reported.iter().find(|mistake| mistake.message == expected);
        let found = found.unwrap_or_else(|| panic!("{text}: {reported:?}"));
        assert_eq!(found.length, number.len() + unit.len(), "{text}");
    }
}

#[test]
fn a_unit_or_a_comma_within_coordinates_is_refused_with_what_to_write() {
    for (position, expected) in [
        (
            "[700 mm, 0, 0]",
            "a number may not have a unit; write `700` in place of `700 mm`: all lengths of a listing are in one unit",
        ),
        (
            "[0,7, 0,1, 0,2]",
            "a design position has three coordinates, 6 are given; write `[x, y, z]`; a decimal separator is a point, as in 0.5",
        ),
        (
            "[0.2, 0,35, 0.16]",
            "a design position has three coordinates, 4 are given; write `[x, y, z]`; a decimal separator is a point, as in 0.5",
        ),
    ] {
        let reported = mistakes(&format!("fixed: a at {position};"));
        let mut messages = reported.iter().map(|mistake| mistake.message.as_str());
        assert!(messages.any(|message| message == expected), "{reported:?}");
    }
}

#[test]
fn a_link_that_is_stated_twice_gives_one_message() {
    let link = "link rod: a -> c;";
    let reported = mistakes(&format!("fixed: a, b; free: c; {link} {link}"));
    let messages = reported.iter().map(|mistake| mistake.message.as_str());
    let of_rod = messages.filter(|message| message.contains("`rod`"));
    assert_eq!(
        of_rod.collect::<Vec<_>>(),
        ["the name `rod` is already taken by a link; choose another"]
    );
}

#[test]
fn for_a_part_that_is_no_statement_one_that_states_it_is_given() {
    for (word, syntax) in [
        ("wishbone", "hinge arm: a, b -> c, d;"),
        ("upright", "body plate: c, d, e;"),
        ("spring", "measure gauge: length(a -> hub);"),
    ] {
        let reported = mistakes(&format!("fixed: a;\nfree: p;\n{word} one: a -> p;"));
        let expected = format!("; a part like this is stated as `{syntax}`");
        let mut messages = reported.iter().map(|mistake| mistake.message.as_str());
        assert!(
            messages.any(|message| message.ends_with(&expected)),
            "{reported:?}"
        );
    }
}

#[test]
fn an_invalid_token_is_reported() {
    for (text, message) in [
        ("fixed: a at [0, 1, 2;", "`[` is not closed; close it"),
        ("fixed: a];", "`]` has no opening bracket; remove it"),
        (
            "fixed: a; \u{a7}",
            "unexpected `\u{a7}` (U+00A7); remove it",
        ),
        (
            "fixed: a\u{200b};",
            "unexpected `\u{200b}` (U+200B); remove it",
        ),
        (
            "fixed: a at [0, \u{2212}1, 2];",
            "unexpected `\u{2212}` (U+2212); write `-`",
        ),
        (
            "link a: b \u{2192} c;",
            "unexpected `\u{2192}` (U+2192); write `->`",
        ),
        (
            "fixed\u{ff1a} a;",
            "unexpected `\u{ff1a}` (U+FF1A); write `:`",
        ),
        ("/* fixed: a;", "`/*` is not closed; close it with `*/`"),
        ("include b: \"b.linkage;", "`\"` is not closed; close it"),
        (
            "fixed: \0a;",
            "the character '\\0' is not allowed; remove it",
        ),
        ("fixed: a;\n# a rack", "a comment begins with `//`"),
        (
            "fixed: a;\n//! a rack",
            "`//!` is allowed only above the first statement; begin the line with `//`",
        ),
        (
            "include b: \"\";",
            "`b` names no file; write the path of a file of statements, for example `include b: \"corner.linkage\";`",
        ),
        (
            "// the rack\rfixed: a;\r\nfree: p;",
            "a line ends with a carriage return alone; end each line with a line feed, with or without a carriage return before it",
        ),
    ] {
        assert_eq!(only_message(text), message);
    }
}

/// Prefixes of a listing, and listings without one of their characters, are read or refused.
#[test]
fn damaged_listings_are_read_or_refused_without_a_panic() {
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

//! How large a listing that is read as text may be.

use suspension_listing::text::{LONGEST_NUMBER, MOST_BYTES};

use super::texts::{mistakes, only_message};

#[test]
fn a_listing_beyond_the_limits_of_size_is_refused() {
    let long = format!("// {}", "x".repeat(MOST_BYTES));
    assert!(only_message(&long).contains("bytes long; at most 65536 are allowed"));
    let deep = "[".repeat(9) + &"]".repeat(9);
    assert_eq!(
        only_message(&format!("fixed: a at {deep};")),
        "brackets are nested more than 8 deep"
    );
    let points = |count: usize| {
        let names = (0..count)
            .map(|index| format!("p{index}"))
            .collect::<Vec<_>>();
        names.join(", ")
    };
    let many = format!("fixed: {};\nfree: p;", points(128));
    assert!(only_message(&many).starts_with("129 points; at most 128 are allowed"));
    let unknowns = format!("fixed: a;\nfree: {};", points(41));
    assert_eq!(
        only_message(&unknowns),
        "at least 123 unknowns; at most 120 are allowed in a listing read at run time: state parts that do not meet, as two corners or two \
         axles, in listings of their own, or write it with `linkage!`, which has no such limit"
    );
    let names = format!("fixed: a; free: p; body long: {};", points(129));
    assert!(only_message(&names).starts_with("129 names in one statement"));
    let statements = format!("fixed: a; free: p; {}", "link rod: a -> p;".repeat(257));
    assert!(only_message(&statements).starts_with("257 statements"));
}

/// Points that a body carries and nothing else holds need no unknowns; what a link, a drive or a marker needs stays.
#[test]
fn for_too_many_unknowns_points_that_may_be_markers_are_named() {
    let text = |body: &str| {
        let names: Vec<String> = (0..37).map(|index| format!("p{index}")).collect();
        format!(
            "fixed: a;\nfree: b, c, d, e, {};\nlink rod: a -> b;\n{body}\npoint tip: c, b, p0;\n\
             measure gauge: length(a -> d);",
            names.join(", ")
        )
    };
    let message_of = |body: &str| only_message(&text(body));
    let carried = message_of("body plate: b, c, d, e, p1;\ndrive bump: p1.z;");
    let way_out = ": `d`, `e` need none where `point d: plate at [x, y, z];` states them, and not `free` and the body; or state parts";
    assert!(carried.contains(way_out), "{carried}");
    // Three points hold the body.
    let few = message_of("body plate: b, d, e;");
    assert!(few.contains("time: state parts"), "{few}");
    let held = message_of("body plate: b, c, d, e;\nlink other: a -> d;");
    assert!(
        held.contains(": `e` needs none where `point e: plate"),
        "{held}"
    );
}

// The time that numbers take to read grows with the square of their length.
#[test]
fn a_number_of_more_than_100_characters_is_refused() {
    for digits in [LONGEST_NUMBER + 1, MOST_BYTES - 100] {
        let number = "9".repeat(digits);
        let text = format!("fixed: a at [0.0, {number}, 0.0]; free: b;");
        let all = mistakes(&text);
        let messages = all.iter().map(|mistake| mistake.message.as_str());
        assert_eq!(
            messages.collect::<Vec<_>>(),
            ["a number has more than 100 characters"]
        );
        assert_eq!((all[0].column, all[0].length), (19, digits));
    }
}

#[test]
fn deeply_nested_brackets_are_refused_without_recursion() {
    for bracket in ["(", "[", "{"] {
        assert!(!mistakes(&bracket.repeat(MOST_BYTES)).is_empty());
    }
    let half = MOST_BYTES / 2;
    assert!(!mistakes(&("(".repeat(half) + &")".repeat(half))).is_empty());
}

//! Bodies with too few points or too few equations.

use nalgebra::Vector3;
use suspension_core::model::constraint::Frame;
use suspension_core::model::parts;
use suspension_listing::include::NoIncludes;
use suspension_listing::text;

use super::texts::{only_message, places};

/// A body of two points that another body has too adds no equation, as a link there would be one too many.
#[test]
fn a_body_whose_distance_is_kept_already_is_refused() {
    let begins = "fixed: a, b;\nfree: p, q, r;\n";
    let rest = "body plate: p, q, r;\nlink one: a -> p; link two: b -> p; link three: a -> q;\n\
                drive x: q.x; drive y: q.y; drive z: r.z;\n";
    for (text, place) in [
        (format!("{begins}body bar: q, p;\n{rest}"), [3, 6, 3]),
        (format!("{begins}{rest}body bar: q, p;\n"), [6, 6, 3]),
    ] {
        assert_eq!(
            only_message(&text),
            "body `bar` has two points, whose distance body `plate` keeps already, and adds nothing; remove it, or list its third point"
        );
        assert_eq!(places(&text), [place]);
    }
}

/// The message is about the third point that the body lacks, not about its marker or its wheel.
#[test]
fn a_body_with_two_points_and_a_marker_needs_a_third_point() {
    let text = "fixed: a, b;\nfree: p, q;\nbody upright: p, q;\nlink one: a -> p; link two: b -> p; link three: a -> q; link four: b -> q;\n\
                drive z: q.z;\npoint axle: upright;\npoint rim: upright;\nwheel: axle -> q;\n";
    assert_eq!(
        only_message(text),
        "body `upright` has two points, `p` and `q`, and needs a third, not in line with these, to carry `axle`; list it"
    );
    assert_eq!(places(text), [[3, 6, 7]]);
}

/// One message gives every remedy for a link to a marker on a body whose points are collinear.
#[test]
fn for_a_marker_in_line_with_its_body_a_slide_is_proposed() {
    let listing = |middle: &str| {
        format!(
            "fixed: a at [0.3, 0.2, 0.2];\nfree: p at [0.0, 0.5, 0.2], q at [0.0, 0.5, 0.4], r at [0.0, 0.5, 0.5]{middle}\n\
             link rod: a -> m;\ndrive x: p.x; drive y: p.y; drive z: p.z; drive turn: q.x;\n"
        )
    };
    for (points, at, is_in_line) in [
        ("p, q, r", " at [0.0, 0.5, 0.3]", true),
        ("p, q, r", " at [0.1, 0.5, 0.3]", false),
        ("p, q, r", "", false),
    ] {
        let marker = listing(&format!(";\nbody strut: {points};\npoint m: strut{at};"));
        assert_eq!(
            only_message(&marker),
            if is_in_line {
                "`m` is a marker and has no unknowns, and lies in line with the points of its body `strut`, about which a body spins: declare \
                 `m` under `free:`, and in place of the body write `link strut: p -> q;` and for each other point, as for `m`, \
                 `slide m_on_strut: m on p -> q;` and `link m_from_p: p -> m;`"
            } else {
                "`m` is a marker and has no unknowns; declare it under `free:` and list it in its body"
            }
        );
    }
    let mended = listing(
        ", m at [0.0, 0.5, 0.3];\nlink strut: p -> q; slide m_on_strut: m on p -> q; link m_from_p: p -> m;\n\
         slide r_on_strut: r on p -> q; link r_from_p: p -> r;",
    );
    text::parse(&mended, "mended", &NoIncludes).expect("nothing else to mend");
}

/// That nothing holds the ends of its line at a constant distance would be a consequence.
#[test]
fn for_a_marker_at_the_end_of_a_line_to_slide_on_there_is_one_message() {
    let text = "fixed: a, b, top;\nfree: p, q, r;\nbody knuckle: p, q, r;\npoint axle: knuckle;\n\
                link one: a -> p; link two: b -> p; link three: a -> q;\nslide strut: top on axle -> q;\ndrive z: q.z;\n";
    let expected =
        "`axle` is a marker and has no unknowns; declare it under `free:` and list it in its body";
    assert_eq!(only_message(text), expected);
}

/// A body of two points may be a link beside a point that slides on it.
#[test]
fn for_a_marker_in_line_with_two_points_a_slide_is_proposed() {
    let text = "fixed: a, b;\nfree: p at [0.0, 0.5, 0.2], q at [0.0, 0.5, 0.4];\nbody strut: p, q;\nlink one: a -> p; link two: b -> p;\n\
                drive z: q.z; drive x: q.x;\npoint m: strut at [0.0, 0.5, 0.3];\nmeasure height: m.z;\n";
    assert_eq!(
        only_message(text),
        "body `strut` has two points, `p` and `q`, and needs a third, not in line with these, to carry `m`; list it, or, as `m` is in line with \
         them, declare `m` under `free:` and write `link strut: p -> q;` in place of the body, \
         `slide m_on_strut: m on p -> q;` and `link m_from_p: p -> m;`"
    );
}

#[test]
fn for_a_hinge_about_free_points_a_body_is_proposed() {
    let text = "fixed: low, high; free: inner, outer, hub; hinge casing: low, high -> inner, outer;\n\
                hinge arm: inner, outer -> hub; drive bump: hub.z; drive steer: outer.y;";
    let expected = "a hinge turns about chassis points, and `inner` is a free point; write `body arm: inner, outer, hub;`, which turns about the \
                    two points that it shares with another body";
    assert_eq!(only_message(text), expected);
}

/// The front end calls a marker in line with its body up to the sine up to which the core refuses the three points as a frame.
#[test]
fn front_end_and_core_agree_on_when_a_marker_is_in_line() {
    for (off, is_in_line) in [(0.99e-3, true), (1.01e-3, false)] {
        let text = format!(
            "fixed: a at [0.3, 0.2, 0.2];\nfree: p at [0.0, 0.5, 0.2], q at [0.0, 0.5, 0.4], r at [0.0, 0.5, 0.5];\nbody strut: p, q, r;\n\
             point m: strut at [{off}, 0.5, 0.3];\nlink rod: a -> m;\ndrive x: p.x; drive y: p.y; drive z: p.z; drive turn: q.x;\n"
        );
        assert_eq!(only_message(&text).contains("lies in line"), is_in_line);
        let [p, q, m] = [[0.0, 0.5, 0.2], [0.0, 0.5, 0.4], [off, 0.5, 0.3]].map(Vector3::from);
        assert_eq!(parts::frame(0, Frame::new(p, q, m)).is_err(), is_in_line);
    }
}

/// An arm on two short links, each of which is stated as a hinge: a listing without links has no link to remove.
#[test]
fn for_surplus_equations_without_links_a_link_replaces_a_hinge() {
    let text = "fixed: bush, a, b, c, d; free: front, ball, hub; hinge short: a, b -> front; hinge upper: c, d -> ball;\n\
                body arm: bush, front, ball, hub; drive bump: hub.z;";
    let message = only_message(text);
    let expected = "2 too many: remove a drive, or write a `link`, which is one equation, in place of a `hinge`, which is two for its first point";
    assert!(message.ends_with(expected), "{message}");
}

/// A carriage that should slide without turning has three equations more than one point of it on the line.
#[test]
fn for_missing_equations_a_body_on_one_slide_is_named_as_turning() {
    let with = |slides: &str| {
        format!(
            "fixed: low at [0, 0, 0], high at [0, 0, 1], side at [0, 1, 0];\n\
             free: a at [0, 0, 0.4], b at [0, 0, 0.6], hub at [0, 0.3, 0.5];\nbody carriage: a, b, hub;\n\
             slide guide: a on low -> high;\ndrive bump: hub.z;\n{slides}"
        )
    };
    let message = only_message(&with("measure far: length(hub -> side);"));
    let expected = "3 more needed: add a link, a drive, or list a point in its body; slide `guide` alone holds body `carriage`, which can still \
                    rotate about the sliding point: a second `slide` on the same line leaves only the rotation about the line, and a `plane` for a third point prevents that too";
    assert!(message.ends_with(expected), "{message}");
    let second = "slide upper: b on low -> high;\n";
    let message = only_message(&with(&format!("{second}measure far: length(hub -> side);")));
    assert!(!message.contains("alone holds"), "{message}");
    let stopped = with(&format!("{second}plane slot: hub on low, high, side;"));
    let read = text::parse(&stopped, "corner.linkage", &NoIncludes);
    assert_eq!(read.err().map(|mistakes| mistakes.to_string()), None);
}

/// Such a wheel stands still whatever the drives do.
#[test]
fn a_wheel_on_chassis_points_is_refused() {
    let text = "fixed: a, b;\nfree: p;\nhinge arm: a, b -> p;\ndrive bump: p.z;\nwheel: a -> b;\n";
    assert_eq!(
        only_message(text),
        "the wheel's points `a` and `b` are chassis points, which no drive moves; name points of the body that carries the wheel"
    );
    text::parse(
        &text.replace("wheel: a -> b", "wheel: a -> p"),
        "",
        &NoIncludes,
    )
    .expect("a wheel that moves");
}

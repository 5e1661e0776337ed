//! Bodies with too few points.

use super::texts::{only_message, places};

/// A body of two points that another body has too adds no equation, as a link there would be one too many.
#[test]
fn a_body_that_adds_nothing_is_refused() {
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

/// The message is about what the body lacks, not about what it carries or the wheel beyond.
#[test]
fn a_body_that_lacks_its_third_point_is_told_so() {
    let text = "fixed: a, b;\nfree: p, q;\nbody upright: p, q;\nlink one: a -> p; link two: b -> p; link three: a -> q; link four: b -> q;\n\
                drive z: q.z;\npoint axle: upright;\npoint rim: upright;\nwheel: axle -> q;\n";
    assert_eq!(
        only_message(text),
        "body `upright` has two points, `p` and `q`, and needs a third, not in line with these, to carry `axle`; list it"
    );
    assert_eq!(places(text), [[3, 6, 7]]);
}

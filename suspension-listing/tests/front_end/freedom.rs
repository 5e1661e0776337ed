//! What messages say about the freedom of a listing at its design position.

use super::texts::{mistakes, only_message};

/// A parallelogram of two cranks on pitman and idler, and a relay rod: its third ball is off the line of the other two.
fn relay(third: &str, statements: &str) -> String {
    format!(
        "fixed: pitman at [0, 0.4, 0], pitman_top at [0, 0.4, 0.1], idler at [0, -0.4, 0], idler_top at [0, -0.4, 0.1], low at [0.3, 0.6, 0],\n\
         high at [0.3, 0.6, 0.2];\n\
         free: left at [0.2, 0.4, 0], right at [0.2, -0.4, 0], inner at {third}, knuckle at [0.15, 0.6, 0];\n\
         hinge pitman_arm: pitman, pitman_top -> left;\nhinge idler_arm: idler, idler_top -> right;\n\
         body rod: left, right, inner;\nlink tie: inner -> knuckle;\nhinge hub: low, high -> knuckle;\n\
         drive steer: left.y;\n{statements}"
    )
}

/// The tie rod holds the rod of the relay, but its knuckle turns with it.
#[test]
fn a_rod_that_carries_another_rod_beside_its_line_is_named_as_turning() {
    let message = only_message(&relay("[0.15, 0.3, 0]", ""));
    let expected = "1 more needed: add a link, a drive, or list a point in its body; body `rod` can rotate about the line through `left` \
                    and `right`: an `angle` or a `plane` for another of its points prevents that";
    assert!(message.ends_with(expected), "{message}");
}

#[test]
fn points_that_can_still_move_are_named_the_farthest_first() {
    let text = "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0, 0];\nfree: p at [0, 0, 1], near at [0, 0, 0.5], q at [1, 0, 1];\n\
                hinge arm: a, b -> p, near;\nlink stay: c -> q;\ndrive x: q.x;\ndrive y: q.y;";
    let message = only_message(text);
    let expected = "1 more needed: add a link, a drive, or list a point in its body; at the design position these points can still move: \
                    `p`, `near`";
    assert!(message.ends_with(expected), "{message}");
}

/// Along x and y three equations hold the point, along z one.
#[test]
fn statements_of_which_one_is_redundant_are_named() {
    let text = "fixed: a at [0, 0, 0], b at [0, 1, 0], c at [1, 0.5, 1];\nfree: p at [1, 0.5, 0];\n\
                link one: a -> p;\nlink two: b -> p;\nlink three: c -> p;\ndrive x: p.x;";
    let message = only_message(text);
    let expected =
        "1 too many: remove a link or a drive; at the design position one of these is redundant: ";
    let (_, names) = message.split_once(expected).expect("the statements");
    let mut names: Vec<&str> = names.split(", ").collect();
    names.sort_unstable();
    assert_eq!(names, ["`one`", "`two`", "`x`"]);
}

/// A bar between `d` and `p` that can spin, and the equations of `p` beside it.
const BAR: &str = "fixed: a at [0, 0, 0], b at [0, 1, 0], d at [0, 1, 1];\nfree: p at [1, 0.5, 0], q at [0.5, 0.7, 0.6];\n\
                   link one: a -> p;\nlink two: b -> p;\nbody bar: d, p, q;\ndrive x: p.x;";

const SPINS: &str = "body `bar` is held only at `d` and `p` and can rotate about the line through them: an `angle` or a third \
                     attachment prevents that";

/// There are as many equations as unknowns: a drive too many hides that the bar spins.
#[test]
fn a_redundant_drive_beside_a_spinning_body_is_named_with_its_alternatives() {
    let all = mistakes(BAR);
    let [redundant, loose] = all.as_slice() else {
        panic!("two mistakes: {all:?}");
    };
    let expected = "; at the design position one of these is redundant: ";
    let (_, names) = redundant
        .message
        .split_once(expected)
        .expect("the statements");
    let mut names: Vec<&str> = names.split(", ").collect();
    names.sort_unstable();
    assert_eq!(names, ["`one`", "`two`", "`x`"]);
    assert!(loose.message.ends_with(SPINS), "{}", loose.message);
}

/// One equation too many in all, but two of five beside the bar, which still spins.
#[test]
fn what_can_move_is_named_although_there_are_too_many_equations() {
    let message = only_message(&format!("{BAR}\ndrive z: p.z;"));
    let (count, rest) = message
        .split_once("; at the design position ")
        .expect("more");
    assert!(
        count.ends_with("1 too many: remove a link or a drive"),
        "{message}"
    );
    assert!(rest.starts_with("2 of these are redundant: "), "{message}");
    let expected = "; body `bar` can rotate about the line through `d` and `p`: an `angle` or a `plane` for another of its points \
                    prevents that";
    assert!(rest.ends_with(expected), "{message}");
}

/// Without positions nothing is known of the motion.
#[test]
fn a_listing_without_positions_gets_the_count_alone() {
    let text = "fixed: a, b, c;\nfree: p;\nlink one: a -> p;\nlink two: b -> p;\nlink three: c -> p;\ndrive x: p.x;";
    assert!(only_message(text).ends_with("1 too many: remove a link or a drive"));
}

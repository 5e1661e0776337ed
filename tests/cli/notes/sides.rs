//! Notes on points that are named for neither side of the vehicle.

use super::notes;

/// An axle of trailing arms, on `arms`, with more statements.
fn axle(arms: &str, statements: &str) -> String {
    format!(
        "unit = 'm'\ntime = {{ instants = [0.0] }}\ndrives = {{ left_bump = 0.3, right_bump = 0.3 }}\nstatements = '''\n\
         mirror: left -> right;\nfixed: {arms};\nfree: left_wheel_centre at [0.0, 0.7, 0.3];\n\
         {statements}\ndrive left_bump: left_wheel_centre.z;\n'''\n"
    )
}

/// Points in ISO 8855 under other axes, or the other way round.
#[test]
fn a_wheel_on_the_side_opposite_to_its_name_is_noted() {
    let arms = "left_outer at [0.4, 0.65, 0.3], left_inner at [0.3, 0.35, 0.3]";
    let statements = "hinge left_arm: left_outer, left_inner -> left_wheel_centre;\n\
                      point left_axle: left_arm at [0.0, 0.6, 0.3];\nwheel left: left_axle -> left_wheel_centre;";
    let file = axle(arms, statements);
    assert_eq!(notes(&file), "");
    assert_eq!(
        notes(&format!("axes = 'Adams'\n{file}")),
        "note: a.toml: the wheel `left` is on the left by its name, and on the right by the y of `left_wheel_centre` in axes of Adams: x rearward, \
         y right, z up: are the axes right?\n"
    );
}

/// A chassis point adds no unknowns, so the counts of equations and unknowns are the same with one point and with two.
#[test]
fn a_point_of_neither_side_shared_by_both_sides_is_noted() {
    let hinge = "hinge left_arm: OUTER, left_inner -> left_wheel_centre;";
    let links = "link left_fore: OUTER -> left_wheel_centre;\nlink left_aft: left_inner -> left_wheel_centre;";
    for (statements, part) in [(hinge, "arm"), (links, "fore")] {
        let named = |outer: &str, y: &str| {
            let points = format!("{outer} at [0.4, {y}, 0.3], left_inner at [0.3, 0.35, 0.3]");
            notes(&axle(&points, &statements.replace("OUTER", outer)))
        };
        assert_eq!(
            named("outer", "0.65"),
            format!(
                "note: a.toml: `outer` is named for neither side and lies 0.65 m off the middle of the vehicle: `left_{part}` and `right_{part}` \
                 both join it, one of them across the vehicle; name it `left_outer` where each side has its own\n"
            )
        );
        assert_eq!(named("left_outer", "0.65"), "");
        assert_eq!(named("outer", "0.0"), "");
    }
}

/// Balls of pitman arm and idler arm, on whose line both tie rods end.
#[test]
fn a_relay_rod_between_points_of_neither_side_is_not_noted() {
    let arms = "left_outer at [0.4, 0.65, 0.3], left_inner at [0.3, 0.35, 0.3], low at [0.2, 0.3, 0.2], high at [0.2, 0.3, 0.4], \
                idler_low at [0.2, -0.3, 0.2], idler_high at [0.2, -0.3, 0.4]";
    let statements = "free: pitman at [0.1, 0.3, 0.3], idler at [0.1, -0.3, 0.3], left_ball at [0.1, 0.2, 0.3];\n\
                      hinge left_arm: left_outer, left_inner -> left_wheel_centre;\nhinge pitman_arm: low, high -> pitman;\n\
                      hinge idler_arm: idler_low, idler_high -> idler;\nlink relay: pitman -> idler;\n\
                      slide left_place: left_ball on pitman -> idler;\nlink near: pitman -> left_ball;\nlink far: pitman -> right_ball;\n\
                      drive steer: pitman.y;";
    let file = axle(arms, statements).replace("drives = {", "drives = { steer = 0.3,");
    assert_eq!(notes(&file), "");
}

/// The image of a point has its position of the listing, although the file moves the point.
#[test]
fn a_point_moved_without_its_mirror_image_is_noted() {
    let statements = "hinge left_arm: left_outer, left_inner -> left_wheel_centre;";
    let arms = "left_outer at [0.4, 0.65, 0.3], left_inner at [0.3, 0.35, 0.3]";
    let of = |points: &str| notes(&format!("{}[points]\n{points}\n", axle(arms, statements)));
    let [left, right] = [
        "left_outer = [0.4, 0.65, 0.32]",
        "right_outer = [0.4, -0.65, 0.32]",
    ];
    let note = |moved: &str, image: &str, state: &str| {
        format!(
            "note: a.toml: [points] moves `{moved}` and not its image `{image}`: the two sides of the vehicle are no longer alike; state \
             {state} too if they should be\n"
        )
    };
    assert_eq!(of(left), note("left_outer", "right_outer", right));
    assert_eq!(of(right), note("right_outer", "left_outer", left));
    let both = format!("{left}\nleft_inner = [0.3, 0.36, 0.3]");
    let message = of(&both);
    assert!(
        message.contains(
            "[points] moves `left_outer`, `left_inner` and not their images `right_outer`, `right_inner`: the two sides of the vehicle are no \
             longer alike; state them too, as right_outer = [0.4, -0.65, 0.32], if they should be\n"
        ),
        "{message}"
    );
    assert_eq!(of(&format!("{left}\n{right}")), "");
    assert_eq!(
        of(&format!("{left}\nright_outer = [0.4, -0.65, 0.3]")),
        "",
        "stated as it is"
    );
    assert_eq!(of("left_outer = [0.4, 0.65, 0.3]"), "", "not moved");
}

/// A twin I-beam turns about a pivot beyond the middle and the bush of its radius arm; a wishbone does not.
#[test]
fn a_pivot_beyond_the_middle_is_noted_unless_its_hinge_line_is_long() {
    for (pivot, is_noted) in [
        (
            "left_pivot at [0.0, -0.2, 0.3], left_radius at [-0.95, 0.42, 0.36]",
            false,
        ),
        (
            "left_pivot at [0.2, -0.35, 0.3], left_radius at [-0.2, 0.35, 0.3]",
            true,
        ),
    ] {
        let statements = "hinge left_beam: left_pivot, left_radius -> left_wheel_centre;\n\
                          point left_axle: left_beam at [0.0, 0.6, 0.3];\nwheel left: left_axle -> left_wheel_centre;";
        let noted = notes(&axle(pivot, statements));
        let question = "`left_pivot` is on the other side of the vehicle than `left_wheel_centre`: is the sign of its y right?";
        assert_eq!(noted.contains(question), is_noted, "{noted}");
        assert_eq!(noted.is_empty(), !is_noted, "{noted}");
    }
}

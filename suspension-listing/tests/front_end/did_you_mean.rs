//! Suggestions for mistyped names.

use suspension_listing::did_you_mean::{did_you_mean, nearest, unknown};

#[test]
fn a_suggested_name_differs_in_one_or_two_letters_or_shares_a_word() {
    let known = ["linkage", "drives", "unit", "wheel_radius", "bump"];
    for (wanted, expected) in [
        ("drive", "; did you mean `drives`?"),
        ("lnikage", "; did you mean `linkage`?"),
        ("inkagee", "; did you mean `linkage`?"),
        ("bumb", "; did you mean `bump`?"),
        ("tyre_radius", "; did you mean `wheel_radius`?"),
        ("points", ""),
        ("pumb", ""),
        ("m", ""),
        ("bump", ""),
        ("", ""),
    ] {
        assert_eq!(did_you_mean(wanted, known), expected, "{wanted}");
    }
}

#[test]
fn the_same_name_with_capitals_blanks_or_hyphens_is_suggested() {
    let known = ["double_wishbone", "double_wishbone_pushrod", "rack"];
    for wanted in ["Double Wishbone", "double-wishbone", "DOUBLE_WISHBONE"] {
        assert_eq!(nearest(wanted, known), Some("double_wishbone"));
    }
    assert_eq!(nearest("RACK", known), Some("rack"));
}

#[test]
fn an_unknown_name_of_a_kind_without_names_lists_none() {
    assert_eq!(
        unknown("measure", "damper", &[]),
        "unknown measure `damper`; the listing states none"
    );
}

#[test]
fn the_nearest_name_is_suggested_and_a_word_of_several_names_none() {
    let known = ["lower_rear", "lower_read", "lower_front"];
    assert_eq!(nearest("lower_reat", known), Some("lower_rear"));
    assert_eq!(nearest("lower_fr0nt", known), Some("lower_front"));
    assert_eq!(nearest("lower_ball", known), None);
}

/// Names of the two ends of a part under which another layout has it.
#[test]
fn two_names_with_the_same_first_word_are_both_suggested() {
    let known = [
        "rack",
        "damper_upper",
        "lower_ball",
        "damper_lower",
        "lower_a",
        "lower_b",
    ];
    let both = "; did you mean `damper_upper` or `damper_lower`?";
    assert_eq!(did_you_mean("damper_inner", known), both);
    assert_eq!(did_you_mean("lower_outer", known), "");
    assert_eq!(did_you_mean("spring_inner", known), "");
}

#[test]
fn the_names_of_both_sides_are_suggested() {
    let known = [
        "rack_housing",
        "left_rack",
        "left_tie_ball",
        "right_rack",
        "right_tie_ball",
    ];
    for wanted in ["rack", "tie_ball"] {
        let both = format!("; did you mean `left_{wanted}` or `right_{wanted}`?");
        assert_eq!(did_you_mean(wanted, known), both);
    }
    assert_eq!(did_you_mean("housings", known), "");
}

#[test]
fn exchanged_letters_count_as_one_mistake() {
    let is_near = |wanted, known| nearest(wanted, [known]).is_some();
    // One letter in names of four, two in names of five.
    assert!(is_near("link", "lnik") && is_near("link", "lik") && is_near("lik", "link"));
    assert!(is_near("link", "lin") && is_near("link", "lint"));
    assert!(!is_near("link", "lnki") && is_near("links", "lnkis"));
    assert!(!is_near("links", "lnkit"));
}

#[test]
fn for_a_name_with_a_surplus_word_the_shorter_name_is_suggested() {
    let known = [
        "camber",
        "camber_to_ground",
        "toe",
        "total_toe",
        "roll_centre",
    ];
    assert_eq!(nearest("toe_angle", known), Some("toe"));
    assert_eq!(nearest("camber_angle", known), Some("camber"));
    assert_eq!(nearest("total_toe_angle", known), Some("total_toe"));
    assert_eq!(nearest("roll_centre_height", known), Some("roll_centre"));
    assert_eq!(nearest("front_camber_toe", ["a", "x_y"]), None);
}

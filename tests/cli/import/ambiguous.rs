//! Tables that can be read in several ways: they are refused, and the message names the rows.

use super::super::program::folder;
use super::refused::refusal;
use super::{CORNER, import, table};

#[test]
fn two_names_of_one_point_in_different_places_are_refused() {
    let corner = table(&CORNER);
    let said = refusal("a.csv", &format!("{corner}LBJ, -4, -560, 129\n"), &[]);
    let expected = "a.csv: `lca_outer` (a.csv:3) and `LBJ` (a.csv:16) are names of one point, lower_ball, in different places: \
                    leave one of them, or give the other a name that import does not know";
    assert_eq!(said, expected);
    // The middle of the rack is not the inner end of the tie rod.
    let said = refusal(
        "a.csv",
        &format!("Steering rack, -72, 0, 152\n{corner}"),
        &[],
    );
    assert!(
        said.contains(
            "`tierod_inner` (a.csv:8) and `Steering rack` (a.csv:1) are names of one point, rack"
        ),
        "{said}"
    );
}

#[test]
fn two_names_of_one_point_in_the_same_place_are_one_point() {
    let folder = folder();
    let corner = table(&CORNER);
    let twice = format!("{corner}LBJ, -4, -560, 128\n");
    let [once, twice] = [corner, twice].map(|file| import(folder.path(), "a.csv", &file, &[]));
    assert_eq!(twice.points(), once.points());
}

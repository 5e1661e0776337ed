//! Mistakes in tables that other commands read.

use super::super::program::{CORNER, text};
use super::check;

#[test]
fn mistakes_under_loads_tolerances_and_tune_are_found() {
    for (table, expected) in [
        (
            "[loads.braking]\nwheel_centr = [0.0, 0.0, 1.0]\n",
            "did you mean `wheel_centre`?",
        ),
        ("[tolerances]\nrak = 0.001\n", "did you mean `rack`?"),
        (
            "[tune.moves.up]\npoints = [\"rak\"]\nalong = \"z\"\nby = [-0.01, 0.01]\n\
             [tune.targets.straight]\nof = \"toe\"\nvalue = 0.0\nwithin = 0.001\n",
            "did you mean `rack`?",
        ),
    ] {
        let output = check(&format!("{CORNER}\n{table}"), &[]);
        assert_eq!(output.status.code(), Some(2), "{output:?}");
        let message = text(&output.stderr);
        assert!(message.trim_end().ends_with(expected), "{message}");
    }
}

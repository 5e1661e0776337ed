//! The option `--minutes` of the program.

use std::process::Command;

#[test]
fn a_duration_that_is_not_a_positive_number_is_refused() {
    for minutes in ["x", "-1", "0", "NaN", "inf"] {
        let run = Command::new(env!("CARGO_BIN_EXE_suspension-car"))
            .args(["--minutes", minutes])
            .output()
            .expect("the program runs");
        let expected = format!("error: --minutes takes a positive number, not {minutes}\n");
        assert_eq!(String::from_utf8_lossy(&run.stderr), expected);
        assert_eq!(run.status.code(), Some(1));
    }
}

//! The program `suspension`.

use std::process::ExitCode;

use suspension::cli::{Options, exit_code_of};

fn main() -> ExitCode {
    let options = Options::given();
    exit_code_of(|interrupted| options.run(interrupted))
}

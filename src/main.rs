//! The program `suspension`.

use std::process::ExitCode;

use suspension::cli::{Options, run_job};

fn main() -> ExitCode {
    let options = Options::parsed();
    run_job(|interrupted| options.run(interrupted))
}

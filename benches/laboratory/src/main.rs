//! The program `suspension-laboratory`.

use std::process::ExitCode;

use clap::Parser;
use suspension::cli::run_job;
use suspension_laboratory::cli::Options;

fn main() -> ExitCode {
    let options = Options::parse();
    run_job(|interrupted| options.command.run(interrupted))
}

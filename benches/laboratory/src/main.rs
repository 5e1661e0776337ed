//! The program `suspension-laboratory`.

use std::process::ExitCode;

use clap::Parser;
use suspension::cli::exit_code_of;
use suspension_laboratory::cli::Options;

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code_of(|interrupted| options.command.run(interrupted))
}

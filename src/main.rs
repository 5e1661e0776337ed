//! The program `suspension`.

use std::process::ExitCode;

use clap::Parser;
use suspension::cli::{Options, exit_code_of};

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code_of(|interrupted| options.run(interrupted))
}

//! The program `suspension`.

use std::process::ExitCode;

use clap::Parser;
use suspension::cli::{Options, exit_code_of};
use suspension::job;

fn main() -> ExitCode {
    let options = Options::parse();
    exit_code_of(|interrupted| match options.command {
        None => job::published(interrupted),
        Some(command) => command.run(interrupted),
    })
}

//! The program `suspension`.

use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use clap::Parser;
use suspension::cli::Options;
use suspension::failure::Failure;
use suspension::job;

fn main() -> ExitCode {
    let options = Options::parse();
    let interrupted = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&interrupted);
    if let Err(error) = ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)) {
        eprintln!("note: an interrupt will lose rows: {error}");
    }
    let done = match options.command {
        None => job::published(&interrupted),
        Some(command) => command.run(&interrupted),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            if !matches!(failure, Failure::ReaderGone) {
                eprintln!("{failure}");
            }
            ExitCode::from(failure.exit_code())
        }
    }
}

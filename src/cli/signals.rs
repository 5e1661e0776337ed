//! Handlers of signals.

use std::io;
use std::sync::Arc;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::register;

use crate::interrupt::flag;

/// Makes signals set the [flag of interrupts](flag), except a hang-up under `nohup`. Makes a file beyond the size limit an
/// error of its writer instead of the end of the program.
///
/// # Errors
///
/// If the system refuses a signal handler.
pub(crate) fn catch_signals() -> io::Result<()> {
    for signal in [SIGINT, SIGTERM] {
        register(signal, Arc::clone(flag()))?;
    }
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGHUP, SIGXFSZ};
        if !is_ignored(SIGHUP) {
            register(SIGHUP, Arc::clone(flag()))?;
        }
        register(SIGXFSZ, Arc::default())?;
    }
    Ok(())
}

/// Returns whether the parent process has made this process ignore a signal; known on Linux.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mut lines = status.lines();
    let ignored = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_some_and(|mask| mask & (1 << (signal - 1)) != 0)
}

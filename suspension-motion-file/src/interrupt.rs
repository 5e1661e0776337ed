//! Interrupts by the user, also while the program waits for another one. Signals belong to the whole process, and so does
//! the flag that they set.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, LazyLock};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::register;

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Returns the flag that is set when the user interrupts the program with Ctrl-C, SIGTERM or SIGHUP.
pub fn flag() -> &'static AtomicBool {
    &INTERRUPTED
}

/// Makes signals set the [`flag`], except a hang-up under `nohup`. Makes a file beyond the size limit an error of its writer
/// instead of the end of the program.
///
/// # Errors
///
/// If the system refuses a signal handler.
pub fn catch_signals() -> io::Result<()> {
    for signal in [SIGINT, SIGTERM] {
        register(signal, Arc::clone(&INTERRUPTED))?;
    }
    #[cfg(unix)]
    {
        use signal_hook::consts::{SIGHUP, SIGXFSZ};
        if !is_ignored(SIGHUP) {
            register(SIGHUP, Arc::clone(&INTERRUPTED))?;
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

/// Does work that may wait for another program, as opening a FIFO does. If the user interrupts it, this returns, and the
/// wait goes on until the program ends.
///
/// # Errors
///
/// The errors of the work, and [`io::ErrorKind::Interrupted`].
pub fn waiting<R: Send + 'static>(
    work: impl FnOnce() -> io::Result<R> + Send + 'static,
) -> io::Result<R> {
    const LOOK: Duration = Duration::from_millis(20);
    let (done, result) = channel();
    // After an interrupt nobody receives the result.
    thread::spawn(move || drop(done.send(work())));
    loop {
        match result.recv_timeout(LOOK) {
            Ok(result) => return result,
            Err(RecvTimeoutError::Timeout) if !flag().load(Ordering::Relaxed) => {}
            Err(_) => return Err(io::ErrorKind::Interrupted.into()),
        }
    }
}

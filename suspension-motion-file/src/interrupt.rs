//! Interrupts by the user, also during work that waits for another program. Signals belong to the whole process, and so
//! does the flag that they set.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, LazyLock};
use std::thread;
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::register;

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Whether the user has interrupted the program: with Ctrl-C, SIGTERM or SIGHUP.
pub fn flag() -> &'static AtomicBool {
    &INTERRUPTED
}

/// From now on signals set the [`flag`], but for a hang-up under `nohup`, and a file that grows beyond its limit is an error of the
/// write and no longer the end of the program.
///
/// # Errors
///
/// Where the system has no handler to give.
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

/// Whether who started the program wants it to go on in spite of a signal; known on Linux.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mut lines = status.lines();
    let ignored = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    ignored.is_some_and(|mask| mask & (1 << (signal - 1)) != 0)
}

/// Does what waits until another program comes, as opening a FIFO does. The wait itself goes on where the
/// user interrupts it, and ends with the program.
///
/// # Errors
///
/// Those of the work, and [`io::ErrorKind::Interrupted`].
pub fn waiting<R: Send + 'static>(
    work: impl FnOnce() -> io::Result<R> + Send + 'static,
) -> io::Result<R> {
    const LOOK: Duration = Duration::from_millis(20);
    let (done, result) = channel();
    // Nobody may be left to take the result.
    thread::spawn(move || drop(done.send(work())));
    loop {
        match result.recv_timeout(LOOK) {
            Ok(result) => return result,
            Err(RecvTimeoutError::Timeout) if !flag().load(Ordering::Relaxed) => {}
            Err(_) => return Err(io::ErrorKind::Interrupted.into()),
        }
    }
}

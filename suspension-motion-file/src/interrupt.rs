//! Interrupts by the user, also while the program waits for another one. Signals belong to the whole process, and so does
//! the flag that their handlers set.

use std::io;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, LazyLock};
use std::thread;
use std::time::Duration;

static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Returns the flag that is set when the user interrupts the program with Ctrl-C, SIGTERM or SIGHUP.
pub fn flag() -> &'static Arc<AtomicBool> {
    &INTERRUPTED
}

/// Lets a motion go on unless an interrupt has set the flag.
pub fn unless_set(interrupted: &AtomicBool) -> ControlFlow<()> {
    if interrupted.load(Ordering::Relaxed) {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
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

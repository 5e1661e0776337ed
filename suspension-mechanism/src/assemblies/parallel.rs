//! Work shared among the processors.

use std::sync::Mutex;
use std::thread;

/// The results of `work` for each item, in order.
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let todo = Mutex::new(items.iter().enumerate());
    let next = || todo.lock().ok()?.next();
    let mut results: Vec<Option<R>> = items.iter().map(|_| None).collect();
    thread::scope(|scope| {
        let one = || {
            let mine = std::iter::from_fn(next);
            mine.map(|(index, item)| (index, work(item)))
                .collect::<Vec<_>>()
        };
        let all: Vec<_> = (0..threads.min(items.len()))
            .map(|_| scope.spawn(one))
            .collect();
        for thread in all {
            match thread.join() {
                Ok(done) => {
                    for (index, result) in done {
                        results[index] = Some(result);
                    }
                }
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    results.into_iter().flatten().collect()
}

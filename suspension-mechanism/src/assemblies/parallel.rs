//! Work shared among the processors.

use std::sync::Mutex;
use std::thread;

/// The results of `work` for each item, in order.
pub(crate) fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let todo = Mutex::new(items.iter().enumerate());
    let next = || todo.lock().ok()?.next();
    let mut done: Vec<(usize, R)> = thread::scope(|scope| {
        let one = || {
            let mine = std::iter::from_fn(next);
            mine.map(|(index, item)| (index, work(item)))
                .collect::<Vec<_>>()
        };
        let all: Vec<_> = (0..threads.min(items.len()))
            .map(|_| scope.spawn(one))
            .collect();
        all.into_iter()
            .flat_map(|thread| match thread.join() {
                Ok(done) => done,
                Err(panic) => std::panic::resume_unwind(panic),
            })
            .collect()
    });
    done.sort_unstable_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

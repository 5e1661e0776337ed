//! The input files, which no result may overwrite.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

static READ: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Records that a file was read: a motion file, its listing, or a file that the listing includes.
pub fn note(path: &Path) {
    if let Ok(path) = path.canonicalize() {
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        read.push(path);
    }
}

/// Returns whether a file was read.
pub fn has(path: &Path) -> bool {
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    path.canonicalize().is_ok_and(|path| read.contains(&path))
}

//! The input files, which no result may overwrite.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

static READ: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Records an input file: a motion file, its listing, a file that the listing includes, or a file of measurements that the
/// motion file names, whether the command reads it or not.
pub fn note(path: &Path) {
    if let Ok(path) = path.canonicalize() {
        let mut read = READ.lock().unwrap_or_else(PoisonError::into_inner);
        read.push(path);
    }
}

/// Returns whether a file is an input file.
pub fn has(path: &Path) -> bool {
    let read = READ.lock().unwrap_or_else(PoisonError::into_inner);
    path.canonicalize().is_ok_and(|path| read.contains(&path))
}

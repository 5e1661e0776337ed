//! The shipped examples, whole and truncated after each line, against the conditions of the fuzz target of motion files.

#[path = "fuzz/fuzz_targets/motion_file/demand.rs"]
mod demand;

use std::fs;
use std::path::Path;

#[test]
fn examples_and_their_prefixes_move_or_are_refused_in_a_sentence() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let files = fs::read_dir(folder)
        .expect("a folder")
        .map(|file| file.expect("a file").path());
    let files = files.filter(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    let mut read = 0;
    for file in files {
        let text = fs::read_to_string(&file).expect("readable");
        let mut beginning = String::new();
        for line in text.split_inclusive('\n') {
            beginning += line;
            demand::demand(&beginning);
        }
        read += 1;
    }
    assert!(read > 15, "{read} examples");
}

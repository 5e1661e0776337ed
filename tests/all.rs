//! The tests of the library, as modules of one test program: shared code is compiled once, and tests run in parallel;
//! allocations are counted per thread. The tests of the program are in `cli`, those that take long in `long_running`, those
//! of both back ends in `back_ends`.

mod absolute_coordinates;
mod bounded;
mod branch;
mod chassis;
mod controllers;
mod corner;
mod counting;
mod derivatives;
#[path = "support/double_wishbone.rs"]
mod double_wishbone;
mod elimination;
mod forces;
mod guarantees;
mod imports;
mod inertia;
mod instructions;
mod lanes;
mod mechanisms;
mod messages;
mod motion_files;
mod no_alloc;
mod operations;
mod own_motion_file;
mod pages;
mod path;
mod published_tables;
mod quantities;
mod reference;
mod rigid_fit;
mod rotation;
mod series;
mod stepper;
mod support;
mod wheel_on_ground;
mod without_a_wheel;

use std::path::Path;

/// The file names of a test program's modules, without those in folders and the build script.
fn files_of(folder: &Path) -> Vec<String> {
    let files = std::fs::read_dir(folder)
        .expect("the folder")
        .map(|file| file.expect("a file").path());
    let sources = files.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    sources
        .map(|path| path.file_stem().expect("a name").display().to_string())
        .filter(|name| name != "build")
        .collect()
}

/// Tests of a file that is no module would silently not run.
#[test]
fn every_test_file_is_a_module_of_its_program() {
    let programs = [
        ("", "all", include_str!("all.rs")),
        ("long_running", "main", include_str!("long_running/main.rs")),
        ("back_ends", "main", include_str!("back_ends/main.rs")),
    ];
    for (folder, program, text) in programs {
        let files = files_of(
            &Path::new(env!("CARGO_MANIFEST_DIR"))
                .join("tests")
                .join(folder),
        );
        assert!(files.len() > 7, "{folder}: {files:?}");
        for name in files.iter().filter(|name| *name != program) {
            assert!(
                text.contains(&format!("\nmod {name};\n")),
                "{name}.rs is not in {program}.rs"
            );
        }
    }
}

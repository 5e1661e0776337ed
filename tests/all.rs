//! The tests of the library, as modules of one test program: what they have in common is compiled once, and
//! they run side by side; allocations are counted by thread. Those of the program stand alone, in `cli`.

mod absolute_coordinates;
mod assembly;
mod baked;
mod bounded;
mod branch;
mod certificate;
mod chassis;
mod corner;
mod counting;
mod derivatives;
mod elimination;
mod f32;
mod guarantees;
mod guard;
mod hostile;
mod inertia;
mod instructions;
mod lanes;
mod mechanisms;
mod messages;
mod no_alloc;
mod operations;
mod own_motion_file;
mod path;
mod properties;
mod published_tables;
mod reference;
mod renamed;
mod rigid_fit;
mod rotation;
mod series;
mod stepper;
mod support;
mod wheel_on_ground;
mod without_a_wheel;

/// Or its tests would not run, and nobody would know.
#[test]
fn every_file_is_a_module() {
    let files = std::fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests"));
    let mut count = 0;
    for file in files.expect("this folder") {
        let path = file.expect("a file").path();
        if path.extension().is_none_or(|extension| extension != "rs") {
            continue;
        }
        let name = path.file_stem().expect("a name").display().to_string();
        let is_program = name == "all";
        let is_module = include_str!("all.rs").contains(&format!("\nmod {name};\n"));
        assert!(is_program || is_module, "{name}.rs is in no test program");
        count += 1;
    }
    assert!(count > 20);
}

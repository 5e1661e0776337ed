//! Programs in C over the built libraries.

mod native;

use std::path::Path;
use std::process::Command;

use suspension_core::{Signal, Values};
use suspension_runtime::Listing;

use native::{compile, example, has, root, run};

/// The published motion in 1,900 steps: the text that C prints contains checksums of the bits of everything
/// computed, and equals that of the same program in Rust with the core.
#[test]
fn c_and_rust_compute_the_same_bits() {
    if !has("cc", "c_and_rust_compute_the_same_bits") {
        return;
    }
    let built = example("motion");
    example("catalogue");
    let folder = tempfile::tempdir().expect("a folder");
    for (number, options, library) in [
        ("f32", &[][..], "libcatalogue.a"),
        ("f64", &["-DDOUBLE"], "libcatalogue.a"),
        ("f64", &["-DDOUBLE"], "libcatalogue.so"),
    ] {
        let program = folder.path().join("motion");
        compile("motion.c", options, &built.join(library), &program);
        let by_c = run(Command::new(&program).env("LD_LIBRARY_PATH", &built));
        let by_rust = run(Command::new(built.join("motion")).arg(number));
        assert_eq!(by_c.lines().count(), 22);
        assert_eq!(by_c, by_rust, "{number}, {library}");
    }
}

/// A listing that C reads from a file moves like the same listing compiled in Rust. The text that both
/// print contains a checksum of the bits of everything computed.
#[test]
fn a_listing_from_text_in_c_moves_like_the_compiled_one_in_rust() {
    if !has(
        "cc",
        "a_listing_from_text_in_c_moves_like_the_compiled_one_in_rust",
    ) {
        return;
    }
    let built = example("listing");
    example("catalogue");
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("listing");
    let library = built.join("libcatalogue.a");
    compile("listing.c", &[], &library, &program);
    let text = "suspension-core/src/linkages/double_wishbone_pushrod.linkage";
    let by_c = run(Command::new(&program).arg(root().join(text)));
    let by_rust = run(&mut Command::new(built.join("listing")));
    assert_eq!(by_c.lines().count(), 15);
    assert_eq!(by_c, by_rust);

    let wrong = folder.path().join("wrong.linkage");
    std::fs::write(&wrong, "fixed: a;\nfree: p;\nlink rod a -> p;\n").expect("a file");
    let output = Command::new(&program)
        .arg(&wrong)
        .output()
        .expect("started");
    assert!(!output.status.success());
    let complaint = String::from_utf8(output.stderr).expect("text");
    assert!(complaint.starts_with("listing:3:"), "{complaint}");
}

/// A program that destroys its objects leaves no memory behind, not even what the standard library keeps of a thread.
#[test]
fn a_program_in_c_that_reads_a_listing_frees_all_memory() {
    let name = "a_program_in_c_that_reads_a_listing_frees_all_memory";
    if !has("cc", name) || !has("valgrind", name) {
        return;
    }
    let library = example("catalogue").join("libcatalogue.a");
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("listing");
    compile("listing.c", &[], &library, &program);
    let text = "suspension-core/src/linkages/double_wishbone_pushrod.linkage";
    run(Command::new("valgrind")
        .args(["--quiet", "--leak-check=full", "--show-leak-kinds=all"])
        .args(["--errors-for-leak-kinds=all", "--error-exitcode=1"])
        .arg(&program)
        .arg(root().join(text)));
}

/// C reads each wheel of an axle by its number and gets what Rust reads by the wheel's name.
#[test]
fn wheels_of_an_axle_read_in_c_equal_those_in_rust() {
    if !has("cc", "wheels_of_an_axle_read_in_c_equal_those_in_rust") {
        return;
    }
    let library = example("catalogue").join("libcatalogue.a");
    let folder = tempfile::tempdir().expect("a folder");
    let program = folder.path().join("axle");
    compile("axle.c", &[], &library, &program);
    let path = root().join("suspension-core/src/linkages/steered_axle.linkage");
    let by_c = run(Command::new(&program).arg(&path));

    let text = std::fs::read_to_string(&path).expect("a listing");
    let listing = Listing::parse(&text).expect("a listing");
    let design = listing.design().expect("positions");
    let mut axle = listing.corner::<60>(&design).expect("a geometry");
    let mut drives = axle.drives();
    for (name, by) in [("bump_left", 0.03), ("bump_right", -0.02), ("steer", 0.01)] {
        let drive = listing.drive(name).expect("a drive");
        let value = drives.values().nth(drive).expect("a value");
        drives = drives.with(drive, value + by);
    }
    axle.step(0.5, Signal::still(drives)).expect("a step");
    let mut by_rust =
        "left wheel 30 mm up, right wheel 20 mm down, rack 10 mm to the left:\n".to_owned();
    by_rust += "  wheel    camber       toe   kingpin\n";
    by_rust += "              deg       deg       deg\n";
    for name in ["left", "right"] {
        let (wheel, kingpin) = axle.wheel_named(name).expect("a wheel");
        let angles = [wheel.camber, wheel.toe, kingpin.expect("a kingpin").angle];
        let [camber, toe, kingpin] = angles.map(f64::to_degrees);
        by_rust += &format!("{name:>7} {camber:9.5} {toe:9.5} {kingpin:9.5}\n");
    }
    assert_eq!(by_c, by_rust);
}

/// Headers compile alone, in C99 with all that ISO demands, and in C++.
#[test]
fn headers_compile_alone_in_c99_and_in_cpp() {
    for (compiler, options) in [
        ("cc", ["-xc", "-std=c99"]),
        ("c++", ["-xc++", "-std=c++11"]),
    ] {
        if !has(compiler, "headers_compile_alone_in_c99_and_in_cpp") {
            continue;
        }
        for header in headers(&root().join("suspension-c/include")) {
            run(Command::new(compiler)
                .args(options)
                .args(["-fsyntax-only", "-pedantic", "-Wall", "-Wextra", "-Werror"])
                .arg(header));
        }
    }
}

fn headers(folder: &Path) -> Vec<std::path::PathBuf> {
    let files = std::fs::read_dir(folder).expect("the folder of headers");
    let paths: Vec<_> = files.map(|file| file.expect("a file").path()).collect();
    assert_eq!(paths.len(), 6);
    paths
}

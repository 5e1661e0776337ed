//! Programs in C that read baked headers.

use std::io::Write;
use std::path::Path;
use std::process::Command;

use super::super::program::text;

/// Returns whether there is a C compiler. In CI, where there must be one, its absence is an error.
pub(super) fn has_c_compiler(test: &str) -> bool {
    if Command::new("cc").arg("--version").output().is_ok() {
        return true;
    }
    assert!(std::env::var_os("CI").is_none(), "no cc");
    // The test harness captures what eprintln! writes, but not this.
    writeln!(std::io::stderr(), "SKIPPED {test}: there is no cc").expect("standard error");
    false
}

/// The header compiles without warnings about rounded numbers, which rules for controllers may demand.
pub(super) fn assert_converts(folder: &Path, name: &str, number: &str) {
    let unit = format!("#define {name}_NUMBER {number}\n#include \"wheel.h\"\nint none;\n");
    std::fs::write(folder.join("unit.c"), unit).expect("written");
    let compiled = Command::new("cc")
        .current_dir(folder)
        .args([
            "-std=c99",
            "-Wall",
            "-Wextra",
            "-Wconversion",
            "-Wfloat-conversion",
        ])
        .args(["-pedantic", "-Werror", "-c", "unit.c"])
        .output()
        .expect("a C compiler");
    assert!(compiled.status.success(), "{number}: {compiled:?}");
}

/// Compiles a program in C99, without warnings, and runs it.
pub(super) fn exit_of_c(folder: &Path, program: &str) -> Option<i32> {
    std::fs::write(folder.join("main.c"), program).expect("written");
    let flags = [
        "-std=c99",
        "-O2",
        "-Wall",
        "-Wextra",
        "-Wdouble-promotion",
        "-Werror",
        "main.c",
        "-o",
        "main",
        "-lm",
    ];
    let compiled = Command::new("cc")
        .current_dir(folder)
        .args(flags)
        .output()
        .expect("a C compiler");
    assert!(compiled.status.success(), "{}", text(&compiled.stderr));
    let ran = Command::new(folder.join("main")).status();
    ran.expect("a program").code()
}

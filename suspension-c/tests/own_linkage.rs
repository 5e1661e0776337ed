//! A user's own linkage: it is exported by one line, its header is printed, and a program in C is linked
//! with it.

mod native;

#[path = "../examples/four_bar.rs"]
mod library;

use std::process::Command;

use library::four_bar::{Drives, Model};
use library::four_bar_f32;
use suspension_core::linkage::Designed;
use suspension_core::{Build, Inputs, Linkage, Motion, Newton, Signal, Tracker, assemble};

#[test]
fn a_program_in_c_uses_a_linkage_exported_by_the_user() {
    if !native::has("cc", "a_program_in_c_uses_a_linkage_exported_by_the_user") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let header = four_bar_f32::INTERFACE.to_string();
    std::fs::write(folder.path().join("my_four_bar_f32.h"), header).expect("a header");
    let built = native::example("four_bar");
    let program = folder.path().join("four_bar");
    let include = format!("-I{}", folder.path().display());
    let library = built.join("libfour_bar.a");
    native::compile("four_bar.c", &[&include], &library, &program);
    let printed = native::run(&mut Command::new(program));
    let [angle, rate] = in_rust();
    assert_eq!(printed, format!("double {angle:.6} rad, {rate:.6} rad/s\n"));
}

suspension_core::linkage! {
    /// A rod in a plane without measures, between points whose names are keywords of C or equal to a
    /// renamed keyword.
    mod rod {
        fixed: int_;
        free:  int, r#struct;
        link rod: int_ -> int;
        link wchar_t: int -> r#struct;
        drive y: int.y;
        drive z: int.z;
        drive far_y: r#struct.y;
        drive far_z: r#struct.z;
    }
}
suspension_c::export!(
    /// A comment that contains the end of a comment: */ and more.
    mod rod_f64 = rod, f64, "my_rod_f64"
);

suspension_c::export!(mod rod_f32 = rod, f32, "my_rod_f32");

/// A linkage that is exported without a comment, as in the example of `export!`.
#[test]
fn a_header_without_a_comment_of_its_own_begins_with_the_rules() {
    let header = rod_f32::INTERFACE.to_string();
    let rules = "/*\n * suspension.h documents the rules for every function.\n */\n";
    assert!(header.starts_with(rules), "{}", &header[..120]);
}

/// C has no empty structs, so the struct has an unused member.
#[test]
fn the_measures_struct_of_a_linkage_without_measures_has_one_member() {
    if !native::has(
        "cc",
        "the_measures_struct_of_a_linkage_without_measures_has_one_member",
    ) {
        return;
    }
    let header = rod_f64::INTERFACE.to_string();
    assert!(
        header.contains(
            "#define MY_ROD_F64_MEASURES_COUNT 0\ntypedef struct {\n    double nothing;\n}"
        )
    );
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("my_rod_f64.h");
    std::fs::write(&path, header).expect("a header");
    for language in [["-xc", "-std=c99"], ["-xc++", "-std=c++17"]] {
        native::run(
            Command::new("cc")
                .args(language)
                .args(["-fsyntax-only", "-pedantic", "-Wall", "-Wextra", "-Werror"])
                .arg("-I")
                .arg(native::root().join("suspension-c/include"))
                .arg(&path),
        );
    }
}

/// Computes the output of the program.
fn in_rust() -> [f32; 2] {
    let design = Model::<f32>::design();
    let model = Model::new(&design).expect("a four-bar");
    let inputs = |turn| {
        let moving = Drives {
            turn: 1.0,
            ..Drives::default()
        };
        Inputs::still(Signal {
            value: Drives {
                turn,
                ..model.drives_at(&design)
            },
            rate: moving,
            second_rate: Drives::default(),
        })
    };
    let mut unknowns = model.unknowns(&design);
    assemble(&Newton::from_afar(), &model, &inputs(0.5), &mut unknowns).expect("an assembly");
    let mut motion = Motion::at_rest(unknowns);
    for step in 0..=1000_u16 {
        let dt = if step == 0 { 0.0 } else { 0.001 };
        let inputs = inputs(0.5 + 0.001 * f32::from(step));
        let tracker = Tracker::default();
        tracker
            .step(&model, &inputs, dt, &mut motion)
            .expect("a step");
    }
    let measures = model.measures(&motion.points(&model, &inputs(1.5)));
    [measures.value.double, measures.rate.double]
}

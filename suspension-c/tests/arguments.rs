//! Every function of a linkage with every argument wrong, one after the other: a program in C, generated
//! from the descriptions of the functions.

mod native;

use std::fmt::Write;
use std::process::Command;

use suspension_c::catalogue::{attia2003_f64, five_link_f32};
use suspension_c::{Function, Interface};

/// The beginning of every program: a valid object of each type that functions read.
const HEAD: &str = r#"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "HEADER"

static PREFIX_points points = {DESIGN};
static susp_NUMBER_rigid_motion rigid_motion = {.rotation = {1, 0, 0, 0}};
static PREFIX_model model;
static PREFIX_motion motion;
static PREFIX_inputs inputs;
static PREFIX_point_rates point_rates;
static PREFIX_chassis_rates chassis_rates;
static PREFIX_lengths lengths;
static PREFIX_drives drives;
static susp_NUMBER_mass one = {.count = 1, .points = {5}, .mass = 2};
static susp_NUMBER_masses masses = {.masses = &one, .count = 1, .gravity = {0, 0, -9.81}};
static int checks;

static void same(const void *a, const void *b, size_t size, const char *call)
{
    if (memcmp(a, b, size) == 0)
        return;
    printf("%s: an argument is changed\n", call);
    exit(EXIT_FAILURE);
}

static void expect(susp_status status, susp_status expected, const char *call)
{
    checks++;
    if (status == expected || (expected < 0 && status != SUSP_OK))
        return;
    printf("%s: %d and not %d: %s\n", call, (int)status, (int)expected, susp_status_text(status));
    exit(EXIT_FAILURE);
}

static void set_up(void)
{
    expect(PREFIX_model_new(&model, sizeof model, &points, NULL), SUSP_OK, "set-up");
    expect(PREFIX_model_drives(&model, &points, &inputs.value), SUSP_OK, "set-up");
    expect(PREFIX_motion_at_rest(&model, &motion, sizeof motion, &points), SUSP_OK, "set-up");
    expect(PREFIX_step(&model, &inputs, 0, &motion, NULL, NULL), SUSP_OK, "set-up");
    expect(PREFIX_read_points(&model, &inputs, &motion, &point_rates), SUSP_OK, "set-up");
    expect(PREFIX_move_chassis(&model, &rigid_motion, &chassis_rates), SUSP_OK, "set-up");
    expect(PREFIX_model_lengths(&model, &lengths), SUSP_OK, "set-up");
    expect(PREFIX_model_drives(&model, &points, &drives), SUSP_OK, "set-up");
}
"#;

/// The types of those objects.
const VALID: [&str; 10] = [
    "Points",
    "RigidMotion",
    "Model",
    "Motion",
    "Inputs",
    "PointRates",
    "ChassisRates",
    "Lengths",
    "Drives",
    "Masses",
];

/// Attia 2003, tables 1 and 2, and a wheel centre.
const DESIGN: &str = "{-1.396, -0.025, -0.082}, {-1.301, 0.1168, 0.106}, {-1.0941, 0.1987, 0.09},
        {-0.9838, 0.2609, -0.0501}, {-1.095, 0.183, -0.0158}, {-1.315, 0.4, 0.027},
        {-1.302, 0.383, 0.24}, {-1.27, 0.315, 0.218}, {-1.292, 0.309, -0.005},
        {-1.188, 0.418, 0.167}, {-1.27, 0.415, 0.218}";

/// Arguments that may be NULL.
const OPTIONAL: [&str; 3] = ["failure", "assembly", "report"];

#[test]
fn wrong_arguments_are_reported_and_change_no_output() {
    if !native::has("cc", "wrong_arguments_are_reported_and_change_no_output") {
        return;
    }
    let built = native::example("catalogue");
    let folder = tempfile::tempdir().expect("a folder");
    for interface in [attia2003_f64::INTERFACE, five_link_f32::INTERFACE] {
        let text = program(&interface);
        let (source, program) = (folder.path().join("main.c"), folder.path().join("main"));
        std::fs::write(&source, text).expect("written");
        let library = built.join("libcatalogue.a");
        let source = source.to_str().expect("a path in text");
        native::compile(source, &["-O0"], &library, &program);
        let printed = native::run(&mut Command::new(&program));
        assert_eq!(printed, "done\n");
    }
}

/// Returns the program for an interface.
fn program(interface: &Interface) -> String {
    let header = format!("{}.h", interface.prefix.replacen("susp_", "suspension_", 1));
    let mut text = HEAD
        .replace("HEADER", &header)
        .replace("PREFIX", interface.prefix)
        .replace("NUMBER", interface.number)
        .replace("DESIGN", DESIGN);
    let mut names = Vec::new();
    for function in interface.functions.iter().copied().flatten() {
        if function.returns == "Status" {
            let cases = cases(function);
            names.push(function.name);
            text += &Case::test(interface, function, &cases);
        }
    }
    text += "\nint main(void)\n{\n    set_up();\n";
    for name in names {
        let _ = writeln!(text, "    test_{name}();");
    }
    text += "    puts(checks > 300 ? \"done\" : \"too few\");\n    return EXIT_SUCCESS;\n}\n";
    text
}

/// A call with at most one wrong argument.
struct Case {
    wrong: Option<(usize, String)>,
    answer: &'static str,
    /// The byte with which an object is filled first.
    fill: Option<u8>,
}

fn cases(function: &Function) -> Vec<Case> {
    let case = |wrong: Option<(usize, &str)>, answer, fill| Case {
        wrong: wrong.map(|(index, text)| (index, text.to_owned())),
        answer,
        fill,
    };
    let mut cases = vec![case(None, "SUSP_OK", None)];
    for (index, [name, kind, of]) in function.arguments.iter().enumerate() {
        match *kind {
            "In" | "InOut" | "Out" => {
                let is_optional = OPTIONAL.contains(name);
                let null = if is_optional {
                    "SUSP_OK"
                } else {
                    "SUSP_ERROR_NULL"
                };
                cases.push(case(Some((index, "NULL")), null, None));
                let odd = format!("(void *)((char *)&a{index} + 1)");
                cases.push(case(Some((index, &odd)), "SUSP_ERROR_MISALIGNED", None));
                let is_object = ["Model", "Motion"].contains(of);
                // Only sub-steps need the inputs from which a step starts.
                let is_needed = *kind == "In" && *name != "from";
                if !is_object && is_needed && is_solving(function) {
                    // Every byte of a NaN.
                    let nan = format!("&a{index}");
                    cases.push(case(Some((index, &nan)), "-1", Some(0xff)));
                }
                if is_object && *kind != "Out" {
                    let object = format!("&a{index}");
                    for fill in [0, 1, 0xa5, 0xff] {
                        cases.push(case(
                            Some((index, &object)),
                            "SUSP_ERROR_OBJECT",
                            Some(fill),
                        ));
                    }
                }
            }
            "usize" => {
                for size in ["0", "4", "1000"] {
                    cases.push(case(Some((index, size)), "SUSP_ERROR_SIZE", None));
                }
            }
            "Outputs" => {
                for outputs in ["3", "-1"] {
                    cases.push(case(Some((index, outputs)), "SUSP_ERROR_ARGUMENT", None));
                }
            }
            "Number" => {
                for number in ["NAN", "INFINITY"] {
                    cases.push(case(Some((index, number)), "-1", None));
                }
            }
            other => panic!("{}: an argument of type {other}", function.name),
        }
    }
    cases
}

/// Whether a function makes a model or solves, and does not only read, transform or evaluate.
fn is_solving(function: &Function) -> bool {
    let mut arguments = function.arguments.iter();
    arguments.any(|[name, ..]| OPTIONAL.contains(name))
}

impl Case {
    fn test(interface: &Interface, function: &Function, cases: &[Self]) -> String {
        let name = function.name;
        let mut text = format!("\nstatic void test_{name}(void)\n{{\n");
        for (index, of) in pointers(function) {
            let before = if of == "Failure" {
                String::new()
            } else {
                format!(", b{index}")
            };
            let _ = writeln!(
                text,
                "    static {} a{index}{before};",
                interface.type_name(of)
            );
        }
        for case in cases {
            text += &case.call(interface, function);
        }
        text + "}\n"
    }

    fn call(&self, interface: &Interface, function: &Function) -> String {
        let mut text = String::new();
        for (index, of) in pointers(function) {
            let content = if VALID.contains(&of) {
                format!("memcpy(&a{index}, &{}, sizeof a{index})", snake(of))
            } else {
                format!("memset(&a{index}, 0x5a, sizeof a{index})")
            };
            let _ = writeln!(text, "    {content};");
        }
        if let (Some(fill), Some((index, _))) = (self.fill, &self.wrong) {
            let _ = writeln!(text, "    memset(&a{index}, {fill}, sizeof a{index});");
        }
        for (index, _) in pointers(function).filter(|(_, of)| *of != "Failure") {
            let _ = writeln!(text, "    b{index} = a{index};");
        }
        let arguments: Vec<String> = (0..function.arguments.len())
            .map(|index| match &self.wrong {
                Some((wrong, text)) if *wrong == index => text.clone(),
                _ => valid(function, index),
            })
            .collect();
        let arguments = arguments.join(", ");
        let (name, answer) = (function.name, self.answer);
        let place = format!("{name}({arguments})");
        let prefix = interface.prefix;
        let _ = writeln!(text, "    expect({prefix}_{place}, {answer}, \"{place}\");");
        if answer != "SUSP_OK" {
            text += &self.unchanged(function, &place);
        }
        text
    }

    /// Only the failure is written, with the status of the call.
    fn unchanged(&self, function: &Function, place: &str) -> String {
        let mut text = String::new();
        for (index, of) in pointers(function) {
            let is_wrong = matches!(&self.wrong, Some((wrong, _)) if *wrong == index);
            let _ = match of {
                "Failure" if is_wrong => Ok(()),
                "Failure" => {
                    let answer = self.answer;
                    writeln!(
                        text,
                        "    expect(a{index}.status, {answer}, \"failure of {place}\");"
                    )
                }
                _ => writeln!(
                    text,
                    "    same(&a{index}, &b{index}, sizeof a{index}, \"{place}\");"
                ),
            };
        }
        text
    }
}

/// Returns numbers and types of the pointer arguments.
fn pointers(function: &Function) -> impl Iterator<Item = (usize, &'static str)> {
    let numbered = function.arguments.iter().enumerate();
    numbered
        .filter(|(_, [_, _, of])| !of.is_empty())
        .map(|(index, [_, _, of])| (index, *of))
}

/// Returns a valid argument.
fn valid(function: &Function, index: usize) -> String {
    match function.arguments[index] {
        [_, "usize", _] => {
            let object = function
                .arguments
                .iter()
                .position(|[_, kind, of]| *kind == "Out" && ["Model", "Motion"].contains(of));
            format!("sizeof a{}", object.expect("an object to make"))
        }
        [_, "Outputs", _] => "SUSP_ACCELERATION".to_owned(),
        [_, "Number", _] => "0.001".to_owned(),
        _ => format!("&a{index}"),
    }
}

fn snake(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

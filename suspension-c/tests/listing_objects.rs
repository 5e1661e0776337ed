//! Every function of listings from text with a wrong object: a program in C, generated from the descriptions of the
//! functions.

mod native;

use std::fmt::Write;
use std::process::Command;

use suspension_c::Function;
use suspension_c::listing::INTERFACE;

const HEAD: &str = r#"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "suspension_listing.h"

static double memory[4096], before[4096];
static susp_f64_failure failure;

static void expect(int passed, const char *call)
{
    if (passed && memcmp(memory, before, sizeof memory) == 0)
        return;
    puts(call);
    exit(EXIT_FAILURE);
}

int main(void)
{
    memset(memory, 0x5a, sizeof memory);
    memcpy(before, memory, sizeof memory);
"#;

/// No object, by the status for it.
const WRONG: [(&str, &str); 3] = [
    ("NULL", "SUSP_ERROR_NULL"),
    ("(void *)((char *)memory + 1)", "SUSP_ERROR_MISALIGNED"),
    ("(void *)memory", "SUSP_ERROR_OBJECT"),
];

#[test]
fn every_function_refuses_a_wrong_object_and_changes_no_output() {
    if !native::has(
        "cc",
        "every_function_refuses_a_wrong_object_and_changes_no_output",
    ) {
        return;
    }
    let functions: Vec<&Function> = INTERFACE.functions.iter().copied().flatten().collect();
    let mut text = HEAD.to_owned();
    let of_objects = functions.iter().filter(|function| takes_object(function));
    let lines = of_objects.flat_map(|function| WRONG.map(|wrong| checked(function, wrong)));
    lines.for_each(|line| text += &line);
    assert_eq!(
        text.matches("expect(susp").count(),
        3 * (functions.len() - 1),
        "all but one, which parses"
    );
    text += "    puts(\"done\");\n    return EXIT_SUCCESS;\n}\n";
    let built = native::example("catalogue");
    let folder = tempfile::tempdir().expect("a folder");
    let (source, program) = (folder.path().join("main.c"), folder.path().join("main"));
    std::fs::write(&source, text).expect("written");
    let source = source.to_str().expect("a path in text");
    native::compile(source, &["-O0"], &built.join("libcatalogue.a"), &program);
    assert_eq!(native::run(&mut Command::new(&program)), "done\n");
}

/// Whether the first argument is a listing or a suspension.
fn takes_object(function: &Function) -> bool {
    let [_, kind, of] = function.arguments[0];
    ["Listing", "Corner"].contains(&of) && kind != "Create"
}

/// A call with this object, and with memory that may be read and written for the rest.
fn checked(function: &Function, (object, status): (&str, &str)) -> String {
    let rest = function.arguments[1..]
        .iter()
        .map(|[_, kind, of]| match *kind {
            _ if *of == "Failure" => "&failure",
            "In" | "InOut" | "Out" | "Create" => "(void *)memory",
            _ => "1",
        });
    let arguments: Vec<&str> = [object].into_iter().chain(rest).collect();
    let expected = match function.returns {
        "Text" => "NULL",
        _ if function.arguments[0][1] == "Destroy" && object == "NULL" => "SUSP_OK",
        _ => status,
    };
    let mut condition = format!(
        "susp_{}({}) == {expected}",
        function.name,
        arguments.join(", ")
    );
    if arguments.contains(&"&failure") {
        let _ = write!(condition, " && failure.status == {expected}");
    }
    format!("    expect({condition}, \"{condition}\");\n")
}

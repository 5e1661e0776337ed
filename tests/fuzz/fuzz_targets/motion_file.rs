//! From any text to a mechanism: a motion, or one sentence that says what is wrong.
#![cfg_attr(feature = "fuzzer", no_main)]

use libfuzzer_sys::fuzz_target;

#[path = "motion_file/demand.rs"]
mod demand;

fuzz_target!(|text: &str| demand::demand(text));

#[cfg(not(feature = "fuzzer"))]
fn main() {
    panic!("this target is linked without the fuzzer; tests/fuzz/README.md says how to run it");
}

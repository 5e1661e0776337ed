//! From any text to a mechanism: a motion, or one sentence that says what is wrong.
#![no_main]

use libfuzzer_sys::fuzz_target;

#[path = "motion_file/demand.rs"]
mod demand;

fuzz_target!(|text: &str| demand::demand(text));

//! From any text to a study: a motion, or one sentence that says what is wrong.
#![no_main]

use std::ops::ControlFlow;

use libfuzzer_sys::fuzz_target;
use suspension::input::setup;
use suspension::input::source::Source;

/// Rows to ask of a motion that does begin.
const ROWS: usize = 3;

/// The longest message, in characters.
const LONGEST: usize = 1000;

fuzz_target!(|text: &str| {
    match setup::load(&Source::new("fuzz.toml", text)) {
        Ok((study, instants)) => {
            let (mut rows, columns) = (0, study.columns().len());
            let mut take = |row: &[f64]| {
                rows += 1;
                assert_eq!(row.len(), columns);
                assert!(row[0].is_finite());
                let next = if rows < ROWS {
                    ControlFlow::Continue(())
                } else {
                    ControlFlow::Break(())
                };
                Ok(next)
            };
            study.sweep(&instants, &mut take).expect("rows are taken");
        }
        Err(failure) => {
            let message = failure.to_string();
            assert!(message.starts_with("fuzz.toml:"), "{message:?}");
            assert!(!message.contains(char::is_control), "{message:?}");
            assert!(message.chars().count() <= LONGEST, "{message:?}");
        }
    }
});

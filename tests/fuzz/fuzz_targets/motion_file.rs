//! From any text to a mechanism: a motion, or one sentence that says what is wrong.
#![no_main]

use std::ops::ControlFlow;

use libfuzzer_sys::fuzz_target;
use suspension::file::Source;
use suspension::kinematics::Kinematics;
use suspension::load::load;
use suspension::quantities::{catalogue, columns};

/// Instants to ask of a motion that does begin.
const INSTANTS: usize = 3;

/// The longest message, in characters.
const LONGEST: usize = 1000;

fn first_instants(mechanism: &dyn Kinematics) {
    let (mut done, columns) = (0, columns(catalogue(), &mechanism.names));
    let swept = mechanism.move_through(&mechanism.instants, &mut |state| {
        done += 1;
        assert!(
            columns
                .iter()
                .all(|column| column.value(&state).is_finite())
        );
        Ok(if done < INSTANTS {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        })
    });
    swept.expect("states are taken");
}

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.toml", text);
    let done = load(&source).and_then(|loaded| {
        first_instants(&*loaded.at_first_instant()?);
        Ok(())
    });
    if let Err(failure) = done {
        let message = failure.to_string();
        assert!(message.starts_with("fuzz.toml:"), "{message:?}");
        assert!(!message.contains(char::is_control), "{message:?}");
        assert!(message.chars().count() <= LONGEST, "{message:?}");
    }
});

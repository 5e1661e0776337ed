//! From any text to a mechanism: a motion, or one sentence that says what is wrong.
#![no_main]

use std::ops::ControlFlow;

use libfuzzer_sys::fuzz_target;
use suspension::failure::Failure;
use suspension::file::Source;
use suspension::load::load;
use suspension::mechanism::{Mechanism, Suspension, Work};
use suspension::quantities::{catalogue, columns};

/// Instants to ask of a motion that does begin.
const INSTANTS: usize = 3;

/// The longest message, in characters.
const LONGEST: usize = 1000;

struct FirstInstants;

impl Work for FirstInstants {
    type Answer = ();

    fn on<L: Suspension<N>, const N: usize>(
        self,
        mechanism: &Mechanism<L, N>,
    ) -> Result<(), Failure> {
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
        Ok(())
    }
}

fuzz_target!(|text: &str| {
    let source = Source::new("fuzz.toml", text);
    let done = load(&source).and_then(|loaded| loaded.run(FirstInstants));
    if let Err(failure) = done {
        let message = failure.to_string();
        assert!(message.starts_with("fuzz.toml:"), "{message:?}");
        assert!(!message.contains(char::is_control), "{message:?}");
        assert!(message.chars().count() <= LONGEST, "{message:?}");
    }
});

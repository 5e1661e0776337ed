//! Requirements for any text that is read as a motion file.

use std::ops::ControlFlow;

use suspension::file::Source;
use suspension::kinematics::Kinematics;
use suspension::prepare::load;
use suspension::quantities::{catalogue, columns};

/// Instants to ask of a motion that does begin.
const INSTANTS: usize = 3;

/// The longest line of a message, in characters.
const LONGEST: usize = 1000;

/// A mechanism and its first instants, or sentences with a place in the file, a line each.
pub(crate) fn demand(text: &str) {
    let source = Source::new("fuzz.toml", text);
    let done = load(&source).and_then(|loaded| {
        first_instants(&*loaded.at_first_instant()?);
        Ok(())
    });
    if let Err(failure) = done {
        for message in failure.to_string().split('\n') {
            assert!(message.starts_with("fuzz.toml:"), "{message:?}");
            assert!(!message.contains(char::is_control), "{message:?}");
            assert!(message.chars().count() <= LONGEST, "{message:?}");
        }
    }
}

/// Points have finite coordinates; a quantity without a value, such as the instant centre of a parallel motion, is NaN.
fn first_instants(mechanism: &dyn Kinematics) {
    let (mut done, columns) = (0, columns(catalogue(), &mechanism.names));
    let swept = mechanism.move_through(&mechanism.instants, &mut |state| {
        done += 1;
        let mut points = state.points.value.iter();
        assert!(points.all(|point| point.iter().all(|x| x.is_finite())));
        for column in &columns {
            let value = column.value(&state);
            assert!(!value.is_infinite(), "{} is {value}", column.title());
        }
        Ok(if done < INSTANTS {
            ControlFlow::Continue(())
        } else {
            ControlFlow::Break(())
        })
    });
    swept.expect("states are taken");
}

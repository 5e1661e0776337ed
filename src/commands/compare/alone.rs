//! Quantities that only one of the two suspensions has.

use crate::characteristics::Parameter;
use crate::commands::compare::differences::is_same;
use crate::commands::compare::side::Side;

/// Names the quantities that only `own` has, in a sentence in which `called` is its file; `None` if the other has all of
/// them.
pub(super) fn alone(own: &Side, other: &Side, called: &str) -> Option<String> {
    let has = |parameter: &Parameter| {
        let mut theirs = other.parameters.iter();
        theirs.any(|of_other| {
            is_same([&parameter.title, &of_other.title]) && parameter.symbol == of_other.symbol
        })
    };
    let mut names: Vec<String> = Vec::new();
    for parameter in own.parameters.iter().filter(|own| !has(own)) {
        let wheel = &parameter.title.wheel;
        let of_wheel = || {
            own.parameters
                .iter()
                .filter(|own| own.title.wheel == *wheel)
        };
        let name = match wheel {
            Some(wheel) if !of_wheel().any(has) => format!("all of `{wheel}`"),
            _ => format!("{} ({})", parameter.title, parameter.symbol),
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    (!names.is_empty()).then(|| format!("only {called} has: {}", names.join(", ")))
}

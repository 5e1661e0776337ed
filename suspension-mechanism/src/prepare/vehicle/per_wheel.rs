//! The wheel data of a motion file, read and checked.

use suspension_listing::did_you_mean::unknown;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::PerWheel;
use crate::mechanism::{Wheel, is_within};
use crate::prepare::task::Task;

/// Whether a file states something of a wheel.
pub(in crate::prepare) fn is_stated<T>(
    stated: &Option<Spanned<PerWheel<T>>>,
    wheel: &Wheel,
) -> bool {
    let stated = stated.as_ref().map(Spanned::get_ref);
    stated.is_some_and(|stated| stated.is_of(&wheel.name))
}

/// The statement for each wheel, if there is any.
pub(super) fn for_each_wheel<T: Clone>(
    task: &Task<'_>,
    wheels: &[Wheel],
    stated: &Option<Spanned<PerWheel<T>>>,
) -> Result<Vec<Option<Spanned<T>>>, Failure> {
    let Some(stated) = stated else {
        return Ok(vec![None; wheels.len()]);
    };
    let of_some = match stated.get_ref() {
        PerWheel::All(all) => {
            let of_all = Spanned::new(stated.span(), all.clone());
            return Ok(vec![Some(of_all); wheels.len()]);
        }
        PerWheel::Of(some) => some,
    };
    let names: Vec<&str> = wheels.iter().map(|wheel| wheel.name.as_str()).collect();
    let mut keys = of_some.names().map(Spanned::get_ref);
    if let Some(wanted) = keys.find(|key| !names.iter().any(|name| is_within(key, name))) {
        let message = if names == [""] {
            format!(
                "unknown wheel `{wanted}`; the listing names no wheels: write the value alone, without a wheel's name"
            )
        } else {
            unknown("wheel", wanted, &names)
        };
        return Err(task.source.refuse(&stated.span(), message));
    }
    // The longest of several that are in a wheel's name.
    let of_wheel = |name: &&str| {
        let within = of_some
            .iter()
            .filter(|(key, _)| is_within(key.get_ref(), name));
        let longest = within.max_by_key(|(key, _)| key.get_ref().split('_').count());
        longest.map(|(_, value)| value.clone())
    };
    Ok(names.iter().map(of_wheel).collect())
}

/// A length in the unit of the file.
pub(in crate::prepare) fn length(
    task: &Task<'_>,
    name: &str,
    stated: Option<&Spanned<f64>>,
) -> Result<Option<f64>, Failure> {
    checked(task, stated, is_positive, || {
        format!("{name} is not a positive finite number; give it in the unit of the file")
    })
}

pub(in crate::prepare) fn is_positive(number: f64) -> bool {
    number > 0.0 && number.is_finite()
}

pub(in crate::prepare) fn checked(
    task: &Task<'_>,
    stated: Option<&Spanned<f64>>,
    will_do: impl Fn(f64) -> bool,
    message: impl Fn() -> String,
) -> Result<Option<f64>, Failure> {
    match stated {
        Some(stated) if !will_do(*stated.get_ref()) => {
            Err(task.source.refuse(&stated.span(), message()))
        }
        _ => Ok(stated.map(|stated| *stated.get_ref())),
    }
}

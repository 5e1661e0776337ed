//! The instants of a motion file.

use toml::Spanned;

use crate::Instants;
use crate::failure::Failure;
use crate::motion_file::Time;
use crate::number::{exact, rounded};
use crate::source::Source;

/// A file with more instants has probably a mistyped step.
const MOST_INSTANTS: f64 = 1e7;

/// Returns the instants of the file.
///
/// # Errors
///
/// [`Failure::Input`] if there are none or too many, or their order changes.
pub fn instants(source: &Source, time: &Spanned<Time>) -> Result<Instants, Failure> {
    match time.get_ref() {
        Time {
            start: Some(start),
            stop: Some(stop),
            step: Some(step),
            instants: None,
        } => stepped(source, [start, stop, step]),
        Time {
            start: None,
            stop: None,
            step: None,
            instants: Some(instants),
        } => listed(source, instants),
        _ => Err(source.refuse(
            &time.span(),
            "[time] needs either start, stop and step, or instants",
        )),
    }
}

fn stepped(source: &Source, values: [&Spanned<f64>; 3]) -> Result<Instants, Failure> {
    for value in values {
        finite_time(source, value)?;
    }
    let [first, stop, step] = values.map(|value| *value.get_ref());
    let refuse = |message: String| Err(source.refuse(&values[2].span(), message));
    if step == 0.0 {
        return refuse("the time step is zero; write its length in seconds, as step = 0.01".into());
    }
    if (stop - first) / step < 0.0 {
        return refuse(format!(
            "the time step {} s leads away from the stop at {} s; write step = {}, or exchange start and stop",
            exact(step),
            exact(stop),
            exact(-step)
        ));
    }
    let count = Instants::count_stepped(first, stop, step);
    if count.is_nan() || count > MOST_INSTANTS {
        return refuse(format!(
            "the time step {} s gives {} instants; at most {MOST_INSTANTS} are allowed: write a longer step",
            exact(step),
            rounded(count, 12)
        ));
    }
    let farthest = first.abs().max(stop.abs());
    if count >= 2.0 && step.abs() < farthest * f64::EPSILON {
        return refuse(format!(
            "the time step {} s is too small to change a time of {} s",
            exact(step),
            rounded(farthest, 12)
        ));
    }
    if count < 2.0 && stop != first {
        return refuse(format!(
            "the time step {} s is longer than the motion from {} s to {} s; for one instant write instants = [{}]",
            exact(step),
            exact(first),
            exact(stop),
            exact(first)
        ));
    }
    Ok(Instants::stepped(first, stop, step))
}

fn listed(source: &Source, list: &Spanned<Vec<Spanned<f64>>>) -> Result<Instants, Failure> {
    for instant in list.get_ref() {
        finite_time(source, instant)?;
    }
    let times: Vec<f64> = list.get_ref().iter().map(|t| *t.get_ref()).collect();
    if times.is_empty() {
        let message = "the list of instants is empty; write times in seconds, as [0.0, 0.5]";
        return Err(source.refuse(&list.span(), message));
    }
    let backwards = times.len() > 1 && times[1] < times[0];
    for (pair, at) in times.windows(2).zip(&list.get_ref()[1..]) {
        let onwards = if backwards {
            pair[1] < pair[0]
        } else {
            pair[1] > pair[0]
        };
        if !onwards {
            let message = format!(
                "the instants must increase or decrease throughout, but {} s follows {} s",
                exact(pair[1]),
                exact(pair[0])
            );
            return Err(source.refuse(&at.span(), message));
        }
    }
    Ok(Instants::Listed(times))
}

fn finite_time(source: &Source, time: &Spanned<f64>) -> Result<(), Failure> {
    if time.get_ref().is_finite() {
        Ok(())
    } else {
        Err(source.refuse(&time.span(), "a time is not a finite number"))
    }
}

//! Parsers of numbers in options, whose errors say what to write.

use std::fmt::Display;
use std::str::FromStr;

use clap::builder::TypedValueParser;

/// Parses a number; `wanted` says what to write.
pub(crate) fn number(wanted: impl Into<String>) -> impl TypedValueParser<Value = f64> {
    number_where(wanted.into(), |_| true)
}

/// Parses a number above zero that is finite; `wanted` says what to write.
pub(crate) fn positive(wanted: impl Into<String>) -> impl TypedValueParser<Value = f64> {
    number_where(wanted.into(), |number: &f64| {
        *number > 0.0 && number.is_finite()
    })
}

/// Parses a whole number, which the help names `called`.
pub(crate) fn whole_number<T>(called: &str, least: T) -> impl TypedValueParser<Value = T> + use<T>
where
    T: FromStr + PartialOrd + Display + Clone + Send + Sync + 'static,
{
    let wanted = format!("{called} is a whole number, at least {least}");
    number_where(wanted, move |number| *number >= least)
}

/// Parses the order of derivatives: 0, 1 or 2.
pub(crate) fn derivatives() -> impl TypedValueParser<Value = u8> {
    number_where("write 0, 1 or 2".to_owned(), |order| *order <= 2)
}

fn number_where<T>(
    wanted: String,
    is_good: impl Fn(&T) -> bool + Clone + Send + Sync + 'static,
) -> impl TypedValueParser<Value = T>
where
    T: FromStr + Clone + Send + Sync + 'static,
{
    move |text: &str| {
        let number = text.parse().ok().filter(|number| is_good(number));
        number.ok_or_else(|| wanted.clone())
    }
}

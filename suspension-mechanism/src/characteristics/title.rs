//! Titles of numbers for people.

use std::collections::BTreeSet;
use std::fmt;

use crate::file::is_within;
use crate::mechanism::Wheel;
use crate::quantities::{Column, Compiled};

/// The name of a number, and the wheel to which it belongs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Title {
    /// The wheel's name, if it has one.
    pub wheel: Option<String>,
    /// The name of the number for this wheel, the same for each wheel.
    pub of_wheel: String,
}

impl Title {
    /// The title of a column, with its axis.
    pub fn new<N: Compiled>(column: &Column<N>, wheels: &[Wheel]) -> Self {
        let mut title = if column.quantity.name.is_empty() {
            Self::of_part(&column.name, wheels)
        } else {
            Self {
                wheel: column.wheel.clone(),
                of_wheel: column.quantity.title.to_owned(),
            }
        };
        if let Some(axis) = column.axis {
            title.of_wheel += &format!(" {axis}");
        }
        title
    }

    /// Whether a name is that of a column in tables or in reports. Capital letters, brackets and the order of the words do not
    /// matter: `Toe (left)` is `left_toe`.
    pub fn is_called<N: Compiled>(column: &Column<N>, wheels: &[Wheel], name: &str) -> bool {
        let names = [column.title(), Self::new(column, wheels).to_string()];
        let wanted = words(name);
        names.iter().any(|name| words(name) == wanted)
    }

    /// The title of a part of the listing, such as a measure. It belongs to a wheel if its name has the words of one wheel's
    /// name, and others: `left_damper`.
    fn of_part(name: &str, wheels: &[Wheel]) -> Self {
        let of_wheel = |wheel: &Wheel| Self {
            wheel: Some(wheel.name.clone()),
            of_wheel: without(&wheel.name, name),
        };
        let named = wheels.iter().filter(|wheel| !wheel.name.is_empty());
        let within = named.filter(|wheel| is_within(&wheel.name, name));
        let mut titles = within
            .map(of_wheel)
            .filter(|title| !title.of_wheel.is_empty());
        match (titles.next(), titles.next()) {
            (Some(title), None) => title,
            _ => Self {
                wheel: None,
                of_wheel: name.to_owned(),
            },
        }
    }
}

/// A name in small letters, in the form of those in tables: `toe_angle` for `Toe angle`.
pub fn as_in_tables(name: &str) -> String {
    name.to_lowercase().replace(' ', "_")
}

/// The words of a name in the order of the alphabet.
fn words(name: &str) -> BTreeSet<String> {
    let name = as_in_tables(name);
    let words = name.split(['_', '(', ')']);
    let words = words.filter(|word| !word.is_empty());
    words.map(str::to_owned).collect()
}

/// A name without the words of another.
fn without(words: &str, name: &str) -> String {
    let is_other = |word: &&str| !is_within(word, words);
    let others: Vec<&str> = name.split('_').filter(is_other).collect();
    others.join("_")
}

impl fmt::Display for Title {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.wheel {
            Some(wheel) => write!(f, "{wheel} {}", self.of_wheel),
            None => f.write_str(&self.of_wheel),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_measure_belongs_to_the_wheel_that_its_name_has() {
        let named = |names: &[&str]| -> Vec<Wheel> {
            let wheel = |name: &&str| Wheel {
                name: (*name).to_owned(),
                ..Wheel::default()
            };
            names.iter().map(wheel).collect()
        };
        let car = named(&["front_left", "front_right", "rear_left", "rear_right"]);
        let (axle, corner) = (named(&["left", "right"]), named(&[""]));
        for (wheels, name, wheel, of_wheel) in [
            (&axle, "left_damper", Some("left"), "damper"),
            (&axle, "damper_right", Some("right"), "damper"),
            (&axle, "left_to_right", None, "left_to_right"),
            (&axle, "left", None, "left"),
            (&axle, "bar_twist", None, "bar_twist"),
            (&car, "rear_left_damper", Some("rear_left"), "damper"),
            (&car, "rear_bar", None, "rear_bar"),
            (&corner, "left_damper", None, "left_damper"),
        ] {
            let wheel = wheel.map(str::to_owned);
            let of_wheel = of_wheel.to_owned();
            assert_eq!(Title::of_part(name, wheels), Title { wheel, of_wheel });
        }
    }
}

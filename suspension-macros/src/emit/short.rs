//! Short names of equations and unknowns, from which the elimination makes the names of its entries.

use std::collections::BTreeMap;

use quote::{ToTokens, format_ident};
use syn::Ident;

use super::terms::ident;
use suspension_listing::name::{KEYWORD_OF_2024, Name};
use suspension_listing::system::{AXES, System};

/// Variables and functions of the elimination, and names that a pattern does not bind.
const TAKEN: [&str; 23] = [
    "Err",
    "Listing",
    "None",
    "Ok",
    "Some",
    "carried",
    "d",
    "determinant",
    "difference",
    "fixed",
    "free",
    "gradient",
    "growth",
    "opposite",
    "origin",
    "pivots",
    "product",
    "q",
    "right",
    "second",
    "third",
    "xyz",
    KEYWORD_OF_2024,
];

/// The short names of a system's equations and unknowns.
pub(super) struct ShortNames {
    /// For each row, the short name of its equation, followed by the axis if the equation has three rows.
    pub(super) rows: Vec<Ident>,
    /// For each unknown, the short name of its point, followed by the axis, or the short name of a scalar.
    pub(super) columns: Vec<Ident>,
    /// The equations and unknowns that they stand for.
    pub(super) meanings: [Vec<(String, Name)>; 2],
}

impl ShortNames {
    pub(super) fn new(system: &System) -> Self {
        let equations = system.equations.iter();
        let equations: Vec<&Name> = equations.map(|equation| &equation.named.name).collect();
        let points = system.free.iter().map(|point| &point.named.name);
        let unknowns: Vec<&Name> = points.chain(&system.scalars).collect();
        let bodies = system.bodies.iter().map(|body| &body.name);
        let bodies: Vec<&Name> = bodies.collect();
        let short = short_names(&[equations.as_slice(), &unknowns].concat(), &bodies);
        let (rows, columns) = short.split_at(equations.len());
        let sizes = system.equations.iter();
        let sizes = sizes.map(|equation| equation.rows().len());
        let coordinates = system.free.iter().map(|_| 3);
        let scalars = system.scalars.iter().map(|_| 1);
        Self {
            rows: components(rows, sizes),
            columns: components(columns, coordinates.chain(scalars)),
            meanings: [(rows, equations), (columns, unknowns)].map(|(short, names)| {
                let names = names.into_iter().cloned();
                short.iter().cloned().zip(names).collect()
            }),
        }
    }
}

/// The name of each component, given the number of components under each name: one, or three with the axis appended.
fn components(names: &[String], sizes: impl Iterator<Item = usize>) -> Vec<Ident> {
    let each = names.iter().zip(sizes).flat_map(|(name, size)| match size {
        1 => vec![ident(name)],
        _ => AXES.map(|axis| format_ident!("{name}_{axis}")).into(),
    });
    each.collect()
}

/// The initials of each name's words, or the name if it is one word; more letters where names would otherwise be
/// equal. None has an underscore in it, so that names made from two can be told apart.
fn short_names(names: &[&Name], also_taken: &[&Name]) -> Vec<String> {
    let mut lengths = vec![1; names.len()];
    loop {
        let short: Vec<String> = (names.iter().zip(&lengths).enumerate())
            .map(|(index, (name, length))| shortened(name.as_str(), *length, index))
            .collect();
        let mut times = BTreeMap::new();
        for name in &short {
            *times.entry(name.as_str()).or_insert(0) += 1;
        }
        let clashes = |name: &String| {
            let is_keyword = syn::parse2::<Ident>(ident(name).into_token_stream()).is_err();
            let is_taken = also_taken.iter().any(|taken| taken.as_str() == name);
            times[name.as_str()] > 1 || is_keyword || is_taken || TAKEN.contains(&name.as_str())
        };
        let clashing: Vec<bool> = short.iter().map(clashes).collect();
        if !clashing.contains(&true) {
            return short;
        }
        let clashing = lengths.iter_mut().zip(clashing);
        clashing.for_each(|(length, clashes)| *length += usize::from(clashes));
    }
}

/// The first letters of each word; if all letters are used, the name's index is appended.
fn shortened(name: &str, length: usize, index: usize) -> String {
    let words: Vec<&str> = name.split('_').filter(|word| !word.is_empty()).collect();
    let sizes = words.iter().map(|word| word.chars().count());
    let longest = if words.len() == 1 {
        1
    } else {
        sizes.max().unwrap_or(0)
    };
    let short: String = if length > longest {
        words.concat() + &index.to_string().repeat(length - longest)
    } else if words.len() == 1 {
        words.concat()
    } else {
        words
            .iter()
            .flat_map(|word| word.chars().take(length))
            .collect()
    };
    let is_name = short.starts_with(char::is_alphabetic);
    if is_name { short } else { format!("n{short}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn short<const K: usize>(names: [&str; K]) -> Vec<String> {
        let names = names.map(|name| Name::made(name.to_owned()));
        let body = Name::made("kr".to_owned());
        short_names(&names.iter().collect::<Vec<_>>(), &[&body])
    }

    #[test]
    fn short_names_are_the_initials_or_the_single_word() {
        assert_eq!(
            short(["lower_front", "p6", "track_rod"]),
            ["lf", "p6", "tr"]
        );
    }

    #[test]
    fn clashing_short_names_get_more_letters() {
        let names = short(["lower_front", "left_front", "rear"]);
        assert_eq!(names, ["lofr", "lefr", "rear"]);
        // A keyword, a variable, a body; two that have the same letters; none at all.
        let names = short(["front_nut", "d", "knuckle_rear", "a_b", "a__b", "_"]);
        assert_eq!(names, ["frnu", "d1", "knre", "ab3", "ab4", "n5"]);
        // A keyword of edition 2024 alone.
        assert_eq!(short(["gearbox_end_near"]), ["geenne"]);
    }
}

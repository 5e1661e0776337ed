//! The paper's tables as printed, and its misprints.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// The published data: H. A. Attia, KSME International Journal 17(8), 2003.
const DATA: &str = include_str!("attia2003.toml");

/// Tables 2 and 3 and the known misprints of the paper.
#[derive(Clone, Debug)]
pub struct Paper {
    /// The instants of both tables, s.
    pub times: Vec<f64>,
    /// The drive's angle and the knuckle points' coordinates.
    pub table2: Vec<Column>,
    /// The knuckle's angular velocity and acceleration.
    pub table3: Vec<Column>,
    /// The misprints.
    pub misprints: Vec<Misprint>,
}

/// A column of a table.
#[derive(Clone, Debug)]
pub struct Column {
    /// The name, equal to that of a column of our results.
    pub name: String,
    /// One entry per instant.
    pub entries: Vec<Entry>,
}

/// An entry of a table.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The number as printed, to the last digit.
    pub printed: String,
    /// Whether it is a misprint.
    pub misprinted: bool,
    /// The number that the paper should have.
    pub value: f64,
    /// One unit of the last digit.
    pub unit: f64,
}

/// A misprint.
#[derive(Clone, Debug)]
pub struct Misprint {
    /// The table, the column and the instant.
    pub place: String,
    /// The number as printed.
    pub printed: String,
    /// The number that it should be.
    pub corrected: String,
    /// The evidence for the misprint.
    pub why: String,
}

impl Paper {
    /// Reads the data that the program carries.
    ///
    /// # Panics
    ///
    /// If the data is not what it was when the program was built and tested.
    pub fn built_in() -> Self {
        let document = DeTable::parse(DATA).expect("the built-in data is TOML");
        let document = document.get_ref();
        let misprints: Vec<Misprint> = list(document, "correction").map(misprint).collect();
        let [table2, table3] = ["table2", "table3"].map(|name| table(document, name));
        let times: Vec<f64> = list(table2, "time_s").map(|t| number(literal(t))).collect();
        let columns = |table: &str, entries: &DeTable<'_>| {
            let names = entries.keys().map(|key| key.get_ref().as_ref());
            let mut names: Vec<&str> = names.filter(|name| shown(name)).collect();
            names.sort_by_key(|name| (name.len(), *name));
            let of = |name| column(table, name, entries, &times, &misprints);
            names.into_iter().map(of).collect()
        };
        let [table2, table3] = [columns("table2", table2), columns("table3", table3)];
        Self {
            times,
            table2,
            table3,
            misprints,
        }
    }
}

/// Returns whether a table of the data is a column that is compared.
fn shown(name: &str) -> bool {
    name != "time_s" && name != "initial_guess"
}

fn column(
    table: &str,
    name: &str,
    entries: &DeTable<'_>,
    times: &[f64],
    misprints: &[Misprint],
) -> Column {
    let most_decimals = list(entries, name).map(|value| decimals(literal(value)));
    let most_decimals = most_decimals.max().unwrap_or_default();
    let entry = |(value, t): (&Spanned<DeValue<'_>>, &f64)| {
        let printed = literal(value);
        let misprint = misprints.iter().find(|misprint| {
            let (column, time) = misprint.place.split_once(", t = ").unwrap_or_default();
            column == format!("{table}.{name}") && time.parse() == Ok(*t)
        });
        let correct = misprint.map_or(printed, |misprint| &misprint.corrected);
        // Table 2 has a fixed number of decimals, Table 3 a fixed number of digits.
        let decimals = match table {
            "table2" => most_decimals,
            _ => decimals(correct),
        };
        Entry {
            printed: printed.to_owned(),
            misprinted: misprint.is_some(),
            value: number(correct),
            unit: 10_f64.powi(-(decimals as i32)),
        }
    };
    Column {
        name: name.to_owned(),
        entries: list(entries, name).zip(times).map(entry).collect(),
    }
}

fn misprint(correction: &Spanned<DeValue<'_>>) -> Misprint {
    let fields = correction.get_ref().as_table();
    let fields = fields.expect("a correction has fields");
    let text = |key| value(fields, key).get_ref().as_str();
    let text = |key| text(key).expect("a text").to_owned();
    Misprint {
        place: text("where"),
        printed: literal(value(fields, "printed")).to_owned(),
        corrected: literal(value(fields, "corrected")).to_owned(),
        why: text("why"),
    }
}

fn value<'a, 'i>(table: &'a DeTable<'i>, key: &str) -> &'a Spanned<DeValue<'i>> {
    table.get(key).expect("the built-in data has the key")
}

fn table<'a, 'i>(document: &'a DeTable<'i>, key: &str) -> &'a DeTable<'i> {
    value(document, key).get_ref().as_table().expect("a table")
}

fn list<'a, 'i>(
    table: &'a DeTable<'i>,
    key: &str,
) -> impl Iterator<Item = &'a Spanned<DeValue<'i>>> {
    value(table, key)
        .get_ref()
        .as_array()
        .expect("a list")
        .iter()
}

/// Returns a number with all printed digits.
fn literal<'a>(value: &'a Spanned<DeValue<'_>>) -> &'a str {
    let float = value.get_ref().as_float().expect("a number with a point");
    float.as_str()
}

fn decimals(literal: &str) -> usize {
    literal.split_once('.').map_or(0, |(_, after)| after.len())
}

fn number(literal: &str) -> f64 {
    literal.parse().expect("a number")
}

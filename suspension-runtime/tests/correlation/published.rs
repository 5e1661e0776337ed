//! The published files.

use std::collections::HashMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use nalgebra::Vector3;

const ENVIRONMENT: &str = "SUSPENSION_PUBLISHED_DATA";

/// The folder of the data; without it the test says so.
pub(crate) fn folder(test: &str) -> Option<PathBuf> {
    let folder = std::env::var_os(ENVIRONMENT).map(PathBuf::from);
    if folder.is_none() {
        // The test harness captures what eprintln! writes, but not this.
        writeln!(
            std::io::stderr(),
            "SKIPPED {test}: set {ENVIRONMENT} to the folder of published data"
        )
        .expect("standard error");
    }
    folder
}

fn text(file: &Path) -> String {
    std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()))
}

/// A geometry: TOML.
pub(crate) fn geometry(file: &Path) -> toml::Table {
    text(file).parse().expect("valid TOML")
}

/// A number of a table.
pub(crate) fn number(value: &toml::Value) -> f64 {
    let integer = value.as_integer().map(|integer| integer as f64);
    value.as_float().or(integer).expect("a number")
}

/// The numbers of an array.
pub(crate) fn numbers(value: &toml::Value) -> Vec<f64> {
    let array = value.as_array().expect("an array");
    array.iter().map(number).collect()
}

/// A point of a table.
pub(crate) fn point(value: &toml::Value) -> Vector3<f64> {
    let three: [f64; 3] = numbers(value).try_into().expect("three numbers");
    three.into()
}

/// A row of results by the names of the columns without `_mm`; empty cells are left out.
pub(crate) type Row = HashMap<String, f64>;

/// Results: CSV with comments.
pub(crate) fn results(file: &Path) -> Vec<Row> {
    let text = text(file);
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let header: Vec<_> = lines.next().expect("a header").split(',').collect();
    let row = |line: &str| {
        let cells = header.iter().zip(line.split(','));
        let filled = cells.filter(|(_, cell)| !cell.is_empty());
        filled
            .map(|(name, cell)| {
                (
                    name.trim_end_matches("_mm").to_owned(),
                    cell.parse().expect("a number"),
                )
            })
            .collect()
    };
    lines.map(row).collect()
}

/// A vector of three columns, in whose names `?` stands for the axis.
pub(crate) fn vector(row: &Row, columns: &str) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| row[&columns.replace('?', axis)]))
}

/// The name of a double wishbone's point as files with Adams names have it.
pub(crate) fn adams_name(name: &str) -> &str {
    match name {
        "lower_inboard_front" => "lca_front",
        "lower_inboard_rear" => "lca_rear",
        "upper_inboard_front" => "uca_front",
        "upper_inboard_rear" => "uca_rear",
        "lower_outboard" => "lca_outer",
        "upper_outboard" => "uca_outer",
        "trackrod_inboard" => "tierod_inner",
        "trackrod_outboard" => "tierod_outer",
        _ => "wheel_center",
    }
}

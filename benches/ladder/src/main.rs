//! The cost of a linkage as it grows.
//!
//! Writes listings of ladders of 1 to 40 bodies, expands them with the macro's own code, compiles
//! them and runs them. Results go to `ladder.csv` and `ladder.svg` in the folder of `--out`.
//!
//! ```sh
//! cargo run --manifest-path benches/ladder/Cargo.toml
//! ```
//!
//! Without `--release`: cargo compiles macros without optimisation, in release builds too, and the
//! time of an expansion is measured as it will be there.

// The macro's files, as they are: a crate of macros exports nothing else.
#[path = "../../../suspension-macros/src"]
mod macros {
    pub(crate) mod emit;
    pub(crate) mod expand;
    pub(crate) mod listing_files;
    pub(crate) mod module;
}
// The modules look for each other at the root of the crate.
use macros::{emit, expand, listing_files, module};

mod chart;
mod compilation;
mod expansion;
mod listing;
mod median;

use std::error::Error;
use std::fs;
use std::path::PathBuf;

use clap::Parser;
use serde::Serialize;

use compilation::{Compilation, Workshop};
use expansion::Expansion;

/// What a linkage costs as it grows: operations, run time, expansion and compile time of ladders
/// of bodies.
#[derive(Parser)]
struct Arguments {
    /// Numbers of bodies.
    #[arg(long, value_delimiter = ',', default_values_t = [1, 2, 3, 4, 6, 8, 10, 15, 20, 30, 40])]
    bodies: Vec<usize>,
    /// The folder that results are written to.
    #[arg(long, default_value = "out/ladder")]
    out: PathBuf,
}

/// A name, and the quantity of a row.
type Quantity = (&'static str, fn(&Row) -> f64);

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
struct Row {
    bodies: usize,
    unknowns: usize,
    non_zeros: usize,
    factor_non_zeros: usize,
    /// The longest chain of operations in the factorisation.
    factor_chain: usize,
    factor_operations: usize,
    solve_operations: usize,
    residual_operations: usize,
    /// The whole expansion, and of it the choice of the order of elimination.
    expansion_s: f64,
    order_s: f64,
    /// In addition to the time of an empty program.
    check_s: f64,
    check_cpu_s: f64,
    release_s: f64,
    release_cpu_s: f64,
    /// Position, velocity and acceleration, each millisecond.
    step_us: f64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    fs::create_dir_all(&arguments.out)?;
    let workshop = Workshop::new(&arguments.out)?;
    let mut table = csv::Writer::from_path(arguments.out.join("ladder.csv"))?;
    let mut rows = Vec::new();
    for bodies in arguments.bodies.iter().copied() {
        let row =
            measure(bodies, &workshop).map_err(|error| format!("{bodies} bodies: {error}"))?;
        println!("{row:?}");
        table.serialize(&row)?;
        table.flush()?;
        rows.push(row);
        fs::write(arguments.out.join("ladder.svg"), chart::svg(&rows)?)?;
    }
    for (what, value) in GROWTHS {
        if let Some(power) = growth(&rows, value) {
            println!("{what} grows with the power {power:.2} of the number of bodies");
        }
    }
    Ok(())
}

const GROWTHS: [Quantity; 4] = [
    ("a step", |row| row.step_us),
    ("a factorisation", |row| row.factor_operations as f64),
    ("an expansion", |row| row.expansion_s),
    ("a release build", |row| row.release_cpu_s),
];

/// The power of growth from ladders of a quarter of the largest number of bodies on.
fn growth(rows: &[Row], value: impl Fn(&Row) -> f64) -> Option<f64> {
    let last = rows.last()?;
    let first = rows.iter().find(|row| 4 * row.bodies >= last.bodies)?;
    let sizes = last.bodies as f64 / first.bodies as f64;
    (sizes > 1.0).then(|| (value(last) / value(first)).ln() / sizes.ln())
}

fn measure(bodies: usize, workshop: &Workshop) -> Result<Row, Box<dyn Error>> {
    let Expansion {
        unknowns,
        non_zeros,
        factor_non_zeros,
        factor_chain,
        operations: [residual_operations, factor_operations, solve_operations],
        expansion_s,
        order_s,
    } = Expansion::of(bodies)?;
    let Compilation {
        check,
        release,
        step_us,
    } = workshop.compile(bodies)?;
    Ok(Row {
        bodies,
        unknowns,
        non_zeros,
        factor_non_zeros,
        factor_chain,
        factor_operations,
        solve_operations,
        residual_operations,
        expansion_s,
        order_s,
        check_s: check.wall_s,
        check_cpu_s: check.cpu_s,
        release_s: release.wall_s,
        release_cpu_s: release.cpu_s,
        step_us,
    })
}

//! What a linkage costs as it grows.
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

// The macro's rooms, as they are: a crate of macros exports nothing else.
#[path = "../../../suspension-macros/src"]
mod macros {
    pub(crate) mod ast;
    pub(crate) mod check;
    pub(crate) mod eliminate;
    pub(crate) mod emit;
    pub(crate) mod errors;
    pub(crate) mod expand;
    pub(crate) mod lower;
    pub(crate) mod parse;
    pub(crate) mod sample;
    pub(crate) mod system;
}
// Where they look for each other.
use macros::{ast, check, eliminate, emit, errors, expand, lower, parse, sample, system};

mod chart;
mod compilation;
mod expansion;
mod listing;

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
    #[arg(long, value_delimiter = ',', default_values_t = [1, 2, 3, 5, 7, 10, 15, 20, 30, 40])]
    bodies: Vec<usize>,
    /// The folder that results are written to.
    #[arg(long, default_value = "out/ladder")]
    out: PathBuf,
}

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
    /// Beyond those of an empty program.
    check_s: f64,
    release_s: f64,
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
    Ok(())
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
        check_s,
        release_s,
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
        check_s,
        release_s,
        step_us,
    })
}

//! Rows of numbers in files: as comma-separated values, as JSON, as Parquet. A file takes its name once it is whole.
//!
//! A crate of its own, so that it is optimised where commands are not: [`rows`] write most of what a sweep takes time for.

pub mod csv_file;
pub mod files;
pub mod heading;
mod json_file;
#[cfg(not(feature = "parquet"))]
#[path = "no_parquet.rs"]
mod parquet_file;
#[cfg(feature = "parquet")]
mod parquet_file;
pub mod rows;
pub mod target;

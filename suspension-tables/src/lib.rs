//! Rows of numbers in files, as comma-separated values, JSON or Parquet, and records of texts and numbers, as the first two. A
//! file gets its name only when it is complete.
//!
//! This crate is separate so that it is optimised while commands are not: writing [`rows`] takes much of the time of a
//! sweep.

mod csv_file;
pub mod files;
pub mod heading;
mod json_file;
#[cfg(not(feature = "parquet"))]
#[path = "no_parquet.rs"]
mod parquet_file;
#[cfg(feature = "parquet")]
mod parquet_file;
pub mod records;
pub mod rows;
pub mod target;

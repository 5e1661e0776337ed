//! What the user gets: CSV and JSON files, plots, summaries, progress.

pub mod csv_file;
pub mod drawing;
pub mod figures;
pub mod files;
pub mod heading;
mod json_file;
pub mod page;
#[cfg(not(feature = "parquet"))]
#[path = "output/no_parquet.rs"]
mod parquet_file;
#[cfg(feature = "parquet")]
mod parquet_file;
pub mod plot;
pub mod progress;
pub mod record;
pub mod rows;
pub mod summary;
pub mod table;
pub mod target;

//! Output for the user: CSV and JSON files, plots, summaries, progress.

pub mod beside;
pub mod colour;
pub mod destinations;
pub mod drawing;
pub mod figures;
pub mod notes;
pub mod page;
pub mod plot;
pub mod progress;
pub mod record;
pub mod summary;
mod svg;
pub mod table;
pub mod text_table;

pub use suspension_tables::{csv_file, files, heading, records, rows, target};

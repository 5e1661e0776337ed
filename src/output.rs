//! Output for the user: CSV and JSON files, plots, summaries, progress.

pub mod capitalised;
pub mod colour;
pub mod default_path;
pub mod destinations;
pub mod drawing;
pub mod file_table;
pub mod motion;
pub mod notes;
pub mod page;
pub mod plot;
pub mod progress;
pub mod pulling;
mod svg;
pub mod svg_folder;
pub mod text_table;

pub use suspension_tables::{files, heading, records, rows, target};

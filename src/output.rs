//! What the user gets: CSV files, plots, summaries, progress.

pub mod csv_file;
pub mod drawing;
pub mod figures;
pub mod files;
pub mod page;
pub mod plot;
pub mod progress;
pub mod record;
pub mod summary;
pub mod table;

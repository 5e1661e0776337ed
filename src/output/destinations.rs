//! Where results go: tables, and beside them standard output and a page of HTML.

use std::path::PathBuf;

use crate::failure::Failure;
use crate::output::files::{announce, print};
use crate::output::rows::TableTargets;
use crate::output::target::Target;

/// Returns the destinations of tables that the options `--csv`, `--json` and `--parquet` name.
pub fn table_targets(options: [&Option<PathBuf>; 3]) -> TableTargets {
    let [csv, json, parquet] = options.map(|path| path.clone().map(Target::from));
    TableTargets { csv, json, parquet }
}

/// The files that the options `--csv`, `--json` and `--html` name.
pub struct Destinations {
    /// The destinations of the tables.
    pub tables: TableTargets,
    /// The destination of the page.
    pub html: Option<Target>,
}

impl Destinations {
    /// Returns the destinations that the three options name.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] for a file that was read, and for one place that two options name.
    pub fn new([csv, json, html]: [&Option<PathBuf>; 3]) -> Result<Self, Failure> {
        let tables = table_targets([csv, json, &None]);
        let html = html.clone().map(Target::from);
        tables.check_with(html.as_ref(), "--html")?;
        Ok(Self { tables, html })
    }

    /// Prints a report as text, unless a table or the page goes to standard output, and writes its tables and its page.
    ///
    /// # Errors
    ///
    /// See [`Failure::writing`].
    pub fn write(
        &self,
        text: impl FnOnce() -> String,
        write_tables: impl FnOnce(&TableTargets) -> Result<(), Failure>,
        page: impl FnOnce() -> String,
    ) -> Result<(), Failure> {
        let Self { tables, html } = self;
        if !tables.is_to_stdout() && *html != Some(Target::Stdout) {
            print(&text())?;
        }
        write_tables(tables)?;
        if let Some(html) = html {
            html.write(&page())?;
        }
        let files = tables.files().map(|(path, _)| path.as_path());
        announce(files.chain(html.as_ref().and_then(Target::path)));
        Ok(())
    }
}

//! Drawings and plots in a folder that an option names.

use std::borrow::Cow;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::output::default_path::name_of;
use crate::output::files::{refuse_plot, write_file};
use crate::output::plot::Chart;
use crate::output::rows::TableTargets;

/// A folder, and the beginning of the names of the files in it.
pub struct SvgFolder<'a> {
    folder: &'a Path,
    stem: Cow<'a, str>,
}

impl<'a> SvgFolder<'a> {
    /// The files in the folder for a motion file, whose name theirs begin with. The folder is created if it is missing.
    pub fn new(folder: &'a Path, file: &'a Path) -> Self {
        let stem = name_of(file);
        Self { folder, stem }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.join(format!("{}_{name}.svg", self.stem))
    }

    /// Refuses tables that would be written over plots of these names.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`].
    pub fn refuse_tables<'n>(
        &self,
        tables: &TableTargets,
        plots: impl IntoIterator<Item = &'n str>,
    ) -> Result<(), Failure> {
        let plots = plots.into_iter().map(|name| self.path(name));
        let plots: Vec<PathBuf> = plots.collect();
        let mut tables = tables.files();
        tables.try_for_each(|(table, option)| refuse_plot(table, option, &plots))
    }

    /// Writes a file of this name; returns its path.
    ///
    /// # Errors
    ///
    /// [`Failure::Output`].
    pub fn write(&self, name: &str, svg: &str) -> Result<PathBuf, Failure> {
        let path = self.path(name);
        write_file(&path, svg)?;
        Ok(path)
    }

    /// Draws plots, each under its name, without those that have no points; returns the paths of the files.
    ///
    /// # Errors
    ///
    /// [`Failure::Output`].
    pub fn draw(
        &self,
        charts: impl IntoIterator<Item = (impl AsRef<str>, Chart)>,
    ) -> Result<Vec<PathBuf>, Failure> {
        let drawn = charts.into_iter();
        let drawn = drawn.filter_map(|(name, chart)| Some((name, chart.svg()?)));
        drawn
            .map(|(name, svg)| self.write(name.as_ref(), &svg))
            .collect()
    }
}

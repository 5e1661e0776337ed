//! The place of an equation.

use suspension_listing::name::Name;
use suspension_listing::system::System;

use crate::plan::lengths::LengthNames;
use crate::site::Site;

/// The place of an equation.
pub(super) struct Place<'a> {
    pub(super) system: &'a System,
    pub(super) lengths: &'a LengthNames<'a>,
    /// The places of derivatives, by row and column.
    pub(super) entries: &'a dyn Fn(usize, Option<usize>) -> u16,
    pub(super) name: &'a Name,
    /// Its first row.
    pub(super) row: usize,
}

impl Place<'_> {
    /// The place of the derivative of a row of the equation, counted from its first row.
    pub(super) fn entry(&self, row: usize, column: Option<usize>) -> u16 {
        (self.entries)(self.row + row, column)
    }

    /// The places of the derivatives with respect to the coordinates of a site.
    pub(super) fn site_entries(&self, row: usize, site: Site) -> [u16; 3] {
        [0, 1, 2].map(|axis| self.entry(row, site.column(axis)))
    }
}

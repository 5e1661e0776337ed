//! A number whose sensitivities are printed.

/// Digits of a sensitivity.
pub(super) const DIGITS: usize = 4;

/// A number of a quantity: its value, or a derivative with respect to a drive.
pub(super) struct Number {
    pub(super) column: usize,
    /// 0, or 1 more than the number of the drive.
    pub(super) number: usize,
    pub(super) csv_name: String,
    /// What the solver's number is multiplied with for that in the file's units.
    pub(super) in_file: f64,
    pub(super) title: String,
    /// What it is multiplied with for the unit that is printed.
    pub(super) scale: f64,
    pub(super) symbol: String,
}

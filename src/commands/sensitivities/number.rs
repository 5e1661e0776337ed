//! A number whose sensitivities are printed.

/// Digits of a sensitivity.
pub(super) const DIGITS: usize = 4;

/// A number of the report: the value of a quantity, or its derivative with respect to a drive.
pub(super) struct Number {
    pub(super) column: usize,
    /// 0 for the value, or 1 more than the number of the drive.
    pub(super) number: usize,
    pub(super) csv_name: String,
    /// The factor from the solver's unit to the file's.
    pub(super) in_file: f64,
    pub(super) title: String,
    /// The factor from the solver's unit to the printed one.
    pub(super) scale: f64,
    pub(super) symbol: String,
}

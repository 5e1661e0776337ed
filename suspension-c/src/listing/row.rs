//! Memory of the caller for numbers.

use core::mem::MaybeUninit;

/// Memory for numbers.
pub(super) type Row<'a> = &'a mut [MaybeUninit<f64>];

/// Writes numbers until the memory is full.
pub(super) fn write(numbers: impl Iterator<Item = f64>, row: Row<'_>) {
    for (place, number) in row.iter_mut().zip(numbers) {
        place.write(number);
    }
}

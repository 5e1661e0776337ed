//! Baked wheels, from tables that the caller owns.

use suspension_core::baked::{self, Split};

use crate::shared::{BakedWheel, BakedWheelRates, Curve};
use crate::status::Status;

/// Wheel centre and spin axis.
const OUTPUTS: usize = 6;
/// Coefficients of the polynomials of degree five that `suspension bake` writes.
const TERMS: usize = 6;

/// Computes the wheel from the drive's value and rates.
///
/// # Errors
///
/// [`Status::Argument`] if range, segments per unit and coefficients do not belong to one table,
/// [`Status::Outside`] beyond the range.
pub(crate) fn wheel<T: Split>(
    curve: &Curve<T>,
    drive: T,
    rate: T,
    second_rate: T,
) -> Result<BakedWheelRates<T>, Status> {
    let (rows, rest) = curve.coefficients.get()?.as_chunks::<OUTPUTS>();
    let (segments, rows_left) = rows.as_chunks::<TERMS>();
    let [first, last] = curve.range;
    let wanted = (last - first) * curve.segments_per_unit;
    let off = wanted - T::constant(segments.len() as f64);
    let half = T::constant(0.5);
    let is_whole = rest.is_empty() && rows_left.is_empty() && !segments.is_empty();
    // Up to rounding.
    let cover_the_range = off.abs() < half;
    if !(is_whole && cover_the_range) {
        return Err(Status::Argument);
    }
    let curve = baked::Curve {
        range: curve.range,
        segments_per_unit: curve.segments_per_unit,
        segments,
    };
    let place = curve.at(drive).map_err(|_| Status::Outside)?;
    let [value, rate, second_rate] = place.acceleration(rate, second_rate).map(halves);
    Ok(BakedWheelRates {
        value,
        rate,
        second_rate,
    })
}

fn halves<T>([a, b, c, d, e, f]: [T; OUTPUTS]) -> BakedWheel<T> {
    BakedWheel {
        centre: [a, b, c],
        axis: [d, e, f],
    }
}

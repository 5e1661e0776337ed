//! The part of a range that can be baked.

use crate::bake::fit::{Fit, MOST_SEGMENTS, Wanted};
use crate::bake::path::{Exact, OutOfReach};

/// The widest part of the range, to a 64th, that can be baked; `None` where not even the smallest
/// about the middle can.
///
/// # Errors
///
/// [`OutOfReach`].
pub fn widest(wanted: &Wanted, exact: &dyn Exact) -> Result<Option<[f64; 2]>, OutOfReach> {
    const PARTS: u32 = 64;
    let [from, to] = wanted.range;
    let place = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
    let possible = |first: u32, last: u32| {
        let range = [first, last].map(place);
        let count = MOST_SEGMENTS;
        let fit = Fit {
            wanted: &Wanted { range, ..*wanted },
            exact,
            count,
        };
        Ok(last > first && fit.all(0.5)?.is_ok())
    };
    let middle = PARTS / 2;
    let half = most(middle, |half| possible(middle - half, middle + half))?;
    let before = most(middle, |before| {
        possible(middle - before.max(half), middle + half)
    })?
    .max(half);
    let after = most(middle, |after| {
        possible(middle - before, middle + after.max(half))
    })?
    .max(half);
    Ok((half > 0).then(|| [middle - before, middle + after].map(place)))
}

/// The largest number up to `limit` that is possible, where all smaller ones are.
fn most(limit: u32, possible: impl Fn(u32) -> Result<bool, OutOfReach>) -> Result<u32, OutOfReach> {
    let (mut good, mut bad) = (0, limit + 1);
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        if possible(middle)? {
            good = middle;
        } else {
            bad = middle;
        }
    }
    Ok(good)
}

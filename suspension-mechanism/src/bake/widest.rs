//! The part of a range that can be baked.

use std::cell::Cell;

use crate::bake::fit::{Fit, MOST_SEGMENTS, Wanted};
use crate::bake::path::Exact;

/// The widest part of the range, to a 64th, that can be baked; `None` where not even the smallest
/// about the middle can.
pub fn widest(wanted: &Wanted, exact: &dyn Exact) -> Option<[f64; 2]> {
    const PARTS: u32 = 64;
    let [from, to] = wanted.range;
    let place = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
    // A range that is too wide is so at an end, mostly where the last one was.
    let suspect = Cell::new(0.5);
    let possible = |first: u32, last: u32| {
        let range = [first, last].map(place);
        let fit = Fit {
            wanted: &Wanted { range, ..*wanted },
            exact,
            count: MOST_SEGMENTS,
        };
        let tried = (last > first).then(|| fit.all(suspect.get()));
        if let Some(Ok(Err(missed))) = tried {
            suspect.set(missed);
        }
        matches!(tried, Some(Ok(Ok(_))))
    };
    let middle = PARTS / 2;
    let half = most(middle, |half| possible(middle - half, middle + half));
    let before = most(middle, |before| {
        possible(middle - before.max(half), middle + half)
    })
    .max(half);
    let after = most(middle, |after| {
        possible(middle - before, middle + after.max(half))
    })
    .max(half);
    (half > 0).then(|| [middle - before, middle + after].map(place))
}

/// The largest number up to `limit` that is possible, where all smaller ones are.
fn most(limit: u32, possible: impl Fn(u32) -> bool) -> u32 {
    let (mut good, mut bad) = (0, limit + 1);
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        if possible(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    good
}

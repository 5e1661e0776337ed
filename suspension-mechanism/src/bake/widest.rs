//! The part of a range that can be baked.

use std::cell::Cell;
use std::ops::Range;

use crate::bake::baked::Wanted;
use crate::bake::exact::Exact;
use crate::bake::fit::{Fit, MOST_SEGMENTS, Met};

/// The number of parts of the range, between whose ends the search takes place.
const PARTS: u32 = 64;

/// The widest part of the range, to a 64th, that can be baked; `None` if not even the smallest part around the middle
/// can.
///
/// A range that is too wide usually fails at an end. The search therefore uses only the outermost segments, which is
/// a hundredth of the work, and all segments if the range found in this way cannot be baked.
pub fn widest(wanted: &Wanted, exact: &dyn Exact) -> Option<[f64; 2]> {
    let [from, to] = wanted.range;
    let place = |part: u32| from + (to - from) * f64::from(part) / f64::from(PARTS);
    // The place where the last range that was too wide failed.
    let suspect = Cell::new(0.5);
    let possible = |parts: [u32; 2], by: fn(&Fit<'_>, f64) -> Met| {
        let range = parts.map(place);
        let fit = Fit {
            wanted: &Wanted { range, ..*wanted },
            exact,
            count: MOST_SEGMENTS,
        };
        let tried = by(&fit, suspect.get());
        if let Ok(Err(missed)) = tried {
            suspect.set(missed);
        }
        matches!(tried, Ok(Ok(())))
    };
    let by_all = |parts| {
        possible(parts, |fit: &Fit<'_>, suspect| {
            Ok(fit.all(suspect)?.map(drop))
        })
    };
    let by_ends = |parts| possible(parts, |fit: &Fit<'_>, suspect| fit.outermost(suspect));
    let found = search(by_ends).filter(|parts| by_all(*parts));
    Some(found.or_else(|| search(by_all))?.map(place))
}

/// The widest possible parts: widened around the middle, then to either side.
fn search(possible: impl Fn([u32; 2]) -> bool) -> Option<[u32; 2]> {
    let middle = PARTS / 2;
    let half = most(1..middle + 1, |half| {
        possible([middle - half, middle + half])
    })?;
    let beyond = half + 1..middle + 1;
    let before = most(beyond.clone(), |before| {
        possible([middle - before, middle + half])
    })
    .unwrap_or(half);
    let after = most(beyond, |after| possible([middle - before, middle + after])).unwrap_or(half);
    Some([middle - before, middle + after])
}

/// The largest possible number in a range in which all smaller ones are possible.
fn most(range: Range<u32>, possible: impl Fn(u32) -> bool) -> Option<u32> {
    let (mut good, mut bad) = (range.start - 1, range.end);
    while bad - good > 1 {
        let middle = good.midpoint(bad);
        if possible(middle) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    (good >= range.start).then_some(good)
}

//! The places of a text about its point, and what they cover.

use plotters::style::text_anchor::HPos;

use super::Segment;

/// How far a text above or below its point goes beyond it, in pixels.
const BEYOND: i32 = 6;

/// Returns the places of a text of a width and height at a distance from a point, in order of preference, each with the side
/// of the text that stays where it is in a wider font.
pub(super) fn places_around(
    (x, y): (i32, i32),
    [width, height]: [i32; 2],
    gap: i32,
    unit: i32,
) -> [(HPos, [i32; 4]); 12] {
    let (gap, beyond) = (gap * unit, BEYOND * unit);
    let [right, left, middle, to_the_right, to_the_left] = [
        (HPos::Left, x + gap),
        (HPos::Right, x - gap - width),
        (HPos::Center, x - width / 2),
        (HPos::Left, x - beyond),
        (HPos::Right, x + beyond - width),
    ];
    let [beside, above, below] = [y - height / 2, y - gap - height, y + gap];
    [
        (right, beside),
        (left, beside),
        (right, above),
        (right, below),
        (left, above),
        (left, below),
        (middle, above),
        (middle, below),
        (to_the_right, above),
        (to_the_right, below),
        (to_the_left, above),
        (to_the_left, below),
    ]
    .map(|((anchor, left), top)| (anchor, [left, top, left + width, top + height]))
}

/// Returns the area that two boxes have in common.
pub(super) fn common(a: &[i32; 4], b: &[i32; 4]) -> i64 {
    let along =
        |low: usize, high: usize| i64::from((a[high].min(b[high]) - a[low].max(b[low])).max(0));
    along(0, 2) * along(1, 3)
}

/// Returns the length of a line within a box (Liang and Barsky 1984).
pub(super) fn inside([from, to]: &Segment, [left, top, right, bottom]: &[i32; 4]) -> f64 {
    let [dx, dy] = [to.0 - from.0, to.1 - from.1].map(f64::from);
    let sides = [
        (-dx, from.0 - left),
        (dx, right - from.0),
        (-dy, from.1 - top),
        (dy, bottom - from.1),
    ];
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (outwards, room) in sides {
        let room = f64::from(room);
        if outwards < 0.0 {
            enters = enters.max(room / outwards);
        } else if outwards > 0.0 {
            leaves = leaves.min(room / outwards);
        } else if room < 0.0 {
            return 0.0;
        }
    }
    (leaves - enters).max(0.0) * dx.hypot(dy)
}

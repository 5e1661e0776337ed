//! The time at which a motion meets an end of a drive's range.

use crate::mechanism::Description;

/// The multiple of its duration to which the motion is continued beyond its last instant, unless a drive is recorded.
pub const CARRIED_ON: f64 = 10.0;

/// Whether the motion is continued beyond its last instant.
pub fn is_continued(mechanism: &Description) -> bool {
    !mechanism.drives.are_recorded()
}

/// Returns whether the motion, continued that long, leaves the drive with this index where it is.
pub fn holds(mechanism: &Description, index: usize) -> bool {
    let is_still = |t| {
        mechanism
            .drives
            .at(t)
            .nth(index)
            .is_none_or(|drive| drive.rate == 0.0)
    };
    looks(mechanism).all(is_still)
}

/// Returns whether the motion, continued that long, moves only the drive with this index.
pub fn moves_alone(mechanism: &Description, index: usize) -> bool {
    looks(mechanism).all(|t| !moves_others(mechanism, index, t))
}

/// The instants at which the motion is checked, without the first.
fn looks(mechanism: &Description) -> impl Iterator<Item = f64> {
    const LOOKS: usize = 20_000;
    let [first, last] = mechanism.instants.ends();
    let times = if is_continued(mechanism) {
        CARRIED_ON
    } else {
        1.0
    };
    let span = (last - first) * times;
    (1..=LOOKS).map(move |look| first + span * look as f64 / LOOKS as f64)
}

fn moves_others(mechanism: &Description, index: usize, t: f64) -> bool {
    let mut drives = mechanism.drives.at(t).enumerate();
    drives.any(|(other, drive)| other != index && drive.rate != 0.0)
}

/// The first time at which the drive with this index is at one of `ends`, in the file's coordinates, and the index of
/// this end; `None` if it never is, or if another drive moves too or a measure leads, because the ends are then not
/// those of the motion.
pub fn meeting(mechanism: &Description, index: usize, ends: [f64; 2]) -> Option<(f64, usize)> {
    if mechanism.led_by.is_some() {
        return None;
    }
    let ends = ends.map(|end| end - mechanism.drive_offsets[index]);
    let value = |t: f64| mechanism.drives_at(t).get(index).copied();
    let excess = |t: f64| Some([ends[0] - value(t)?, value(t)? - ends[1]]);
    let [mut before, _] = mechanism.instants.ends();
    for after in looks(mechanism) {
        if moves_others(mechanism, index, after) {
            return None;
        }
        let beyond = excess(after)?;
        if let Some(end) = beyond.iter().position(|excess| *excess >= 0.0) {
            let mut ways = [before, after];
            while let [from, to] = ways
                && let middle = from + (to - from) / 2.0
                && middle != from
                && middle != to
            {
                ways = if excess(middle)?[end] >= 0.0 {
                    [from, middle]
                } else {
                    [middle, to]
                };
            }
            return Some((ways[1], end));
        }
        before = after;
    }
    None
}

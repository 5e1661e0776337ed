//! A motion along a drive or a measure, or the possible part of it.

use crate::bake::{Baked, Exact, MOST_SEGMENTS, OutOfReach, Unmet, Wanted, bake, widest};
use crate::commands::bake::baking::{Baking, DIGITS, Variable};
use crate::failure::Failure;
use crate::mechanism::advice;
use crate::number::{number, rounded};

/// The part of a range through which a motion leads, in local coordinates, and the ends of the range that are among its own.
pub(super) struct Within {
    pub(super) range: [f64; 2],
    pub(super) kept: [bool; 2],
}

impl Baking<'_> {
    pub(super) fn curve(&self, along: &Variable) -> Result<Baked, Failure> {
        let metre = self.mechanism.unit.metre();
        let wanted = Wanted {
            range: along.local,
            tolerance: self.tolerance * metre,
            metre,
            continuity: self.continuity,
        };
        let path = self.path(along, wanted.range).map_err(Unmet::from);
        let baked = path.and_then(|path| bake(&wanted, &*path));
        let baked = baked.map_err(|unmet| self.unmet(along, &wanted, &unmet))?;
        Ok(baked.moved(self.mechanism.origin.into(), along.range))
    }

    fn unmet(&self, along: &Variable, wanted: &Wanted, unmet: &Unmet) -> Failure {
        let (of_reach, within) = match along.measure {
            Some(_) => self.reach_of_measure(along, unmet),
            None => self.reach_of_drive(along, unmet),
        };
        let reason = match unmet {
            Unmet::TooManySegments { at } => format!(
                "{MOST_SEGMENTS} segments do not meet {} m about {}",
                rounded(self.tolerance, 3),
                self.in_words(along, *at)
            ),
            Unmet::OutOfReach(_) => of_reach,
        };
        let name = self.name(along);
        let advice = match (self.possible(along, wanted, &within), along.measure) {
            (None, _) => "no part of the range can be baked".to_owned(),
            (Some([from, to]), None) => format!("possible is --from {from} --to {to}"),
            (Some([from, to]), Some(_)) => format!("possible is --along {name}={from}:{to}"),
        };
        let [from, to] = along.local.map(|end| number(self.in_file(along, end)));
        Failure::Solver(format!(
            "{}: {name} cannot be baked from {from} to {to}: {reason}; {advice}",
            self.file
        ))
    }

    /// Says what limits a drive, and how far it leads the mechanism.
    fn reach_of_drive(&self, along: &Variable, unmet: &Unmet) -> (String, Within) {
        let (range, locks) = self.reach(along);
        let kept = locks.each_ref().map(Option::is_none);
        match unmet {
            Unmet::OutOfReach(error) if locks == [None, None] => {
                let kept = [false; 2];
                (self.lost_between(along, error), Within { range, kept })
            }
            _ => {
                let locks: Vec<String> = locks.into_iter().flatten().collect();
                let why = format!("{}; {}", locks.join("; "), advice(self.file));
                (why, Within { range, kept })
            }
        }
    }

    /// Returns the part of a range through which the drive leads the mechanism, and for either end, in words, what limits
    /// it.
    pub(super) fn reach(&self, along: &Variable) -> ([f64; 2], [Option<String>; 2]) {
        let mut locks = [None, None];
        let now = self.first(along.drive);
        let [from, to] = along.local;
        let mut reached = [from.min(now), to.max(now)];
        for ((end, wanted), in_the_way) in reached.iter_mut().zip(along.local).zip(&mut locks) {
            // The path to the other end passes this end if it is beyond the first instant.
            if *end != wanted {
                continue;
            }
            if let Some(lock) = self.mechanism.lock_before(along.drive, *end) {
                *in_the_way = Some(self.mechanism.lock_in_words(&lock));
                *end = lock.drives[along.drive] - self.mechanism.drive_offsets[along.drive];
            }
        }
        let [low, high] = reached;
        let inside = [low.max(from), high.min(to)];
        // The message for a range beyond a lock gives the part up to the lock.
        let inside = if inside[0] < inside[1] {
            inside
        } else {
            reached
        };
        (inside, locks)
    }

    /// Returns the part of a range that can be baked, in a few digits, in the file's coordinates and units.
    fn possible(&self, along: &Variable, wanted: &Wanted, within: &Within) -> Option<[String; 2]> {
        let in_file = |end| self.in_file(along, end);
        let ends = possible_in_few_digits(within.range, within.kept, in_file, |range| {
            let path = self.path(along, range).ok()?;
            widest(&Wanted { range, ..*wanted }, &*path)
        })?;
        Some(ends.map(|end| rounded(end, DIGITS)))
    }

    fn path(&self, along: &Variable, range: [f64; 2]) -> Result<Box<dyn Exact + '_>, OutOfReach> {
        let points = self.points;
        self.mechanism
            .path(along.drive, along.measure, range, points)
    }

    /// Says at which value, within the reach of the drive, the solver lost the motion.
    fn lost_between(&self, along: &Variable, error: &OutOfReach) -> String {
        let [from, to] = error.reached.map(|end| number(self.in_file(along, end)));
        let cause = self.cause(error.cause);
        format!("the motion is lost between {from} and {to}{cause}")
    }
}

/// Returns the part of a range that can be baked, which `widest` finds, rounded to a few digits in the file's coordinates
/// and units; `shown` converts local values to these. An end that is `kept`, because nothing limits it, is not rounded if
/// the range up to it can be baked.
fn possible_in_few_digits(
    range: [f64; 2],
    kept: [bool; 2],
    shown: impl Fn(f64) -> f64,
    widest: impl FnOnce([f64; 2]) -> Option<[f64; 2]>,
) -> Option<[f64; 2]> {
    /// How near to a turning point the mechanism is solved, as a part of the range.
    const CLOSE: f64 = 1e-6;
    let [from, to] = range;
    if from >= to {
        return None;
    }
    let inset = CLOSE * (to - from);
    let within = [from + inset, to - inset];
    let tried = [0, 1].map(|end| if kept[end] { range[end] } else { within[end] });
    let found = widest(tried)?;
    let [from, to] = found.map(&shown);
    let steps_a_unit = 10_f64.powf(3.0 - (to - from).log10().floor());
    let few = [
        (from * steps_a_unit).ceil() / steps_a_unit,
        (to * steps_a_unit).floor() / steps_a_unit,
    ];
    let stays = |end: usize| kept[end] && (found[end] - range[end]).abs() < inset;
    Some([0, 1].map(|end| match stays(end) {
        true => shown(range[end]),
        false => few[end],
    }))
}

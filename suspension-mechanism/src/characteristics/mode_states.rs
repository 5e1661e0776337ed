//! The states along travel, in heave and in roll of an axle, and along steering.

use std::ops::Deref;
use std::sync::atomic::AtomicBool;

use suspension_core::listing::DriveKind;

use crate::characteristics::modes::Mode;
use crate::characteristics::movement::{Effect, Movement};
use crate::characteristics::span::{Span, through_design};
use crate::failure::Failure;
use crate::kinematics::Kinematics;
use crate::mechanism::{CountedFrom, DerivativeOrder, Grid, GridAxis, Place, State, Unit, Visited};
use crate::number::number;

/// The states in a mode.
pub struct ModeStates {
    mode: Mode,
    /// The effect of the drives.
    pub movement: Movement,
    /// The changes from the design position.
    pub changes: Vec<f64>,
    /// Whether their range is the usual one, because the user states none.
    pub is_usual: bool,
    /// Each state, and the state with derivatives with respect to each of the drives.
    pub visited: Visited<(State, Vec<Option<State>>)>,
}

impl Deref for ModeStates {
    type Target = Mode;

    fn deref(&self) -> &Mode {
        &self.mode
    }
}

/// The number of places of each curve.
const PLACES: usize = 61;

/// The usual spans of travel and steering in either direction, in metres, and as an angle.
const USUAL: [f64; 2] = [0.06, 0.03];
const USUAL_ANGLE: f64 = 0.2;

/// The states in heave and roll of axles, along travel of single wheels, and along steering if a drive steers. Spans
/// are in `unit`; that of travel also applies to heave and roll. [`check_spans`](fn@crate::characteristics::check_spans) checks them.
pub fn mode_states(
    mechanism: &dyn Kinematics,
    spans: [Option<Span>; 2],
    unit: Unit,
    interrupted: &AtomicBool,
) -> Vec<ModeStates> {
    let mut modes: Vec<ModeStates> = Vec::new();
    for mode in Mode::all(mechanism) {
        let stated = spans[option_of(&mode)];
        let metre = mechanism.unit.metre();
        let span = match (stated, mode.kind) {
            (Some(Span(ends)), DriveKind::Coordinate) => ends.map(|end| end / unit.metre() * metre),
            (Some(Span(ends)), DriveKind::Angle | DriveKind::Turn) => {
                ends.map(|end| end / unit.angle.radian())
            }
            (None, kind) => {
                let end = usual_change(mode.effect, kind, mechanism.unit);
                [-end, end]
            }
        };
        let Some(span) = within_travel(mode.effect, span) else {
            continue;
        };
        let changes = through_design(span, PLACES);
        let effect = mode.effect;
        let number = 1 + modes.iter().filter(|other| other.effect == effect).count();
        modes.push(ModeStates {
            visited: visited(mechanism, &mode, &changes, interrupted),
            mode,
            movement: Movement { effect, number },
            changes,
            is_usual: stated.is_none(),
        });
    }
    modes
}

/// The states at changes of the drives of a mode.
fn visited(
    mechanism: &dyn Kinematics,
    Mode { drives, .. }: &Mode,
    changes: &[f64],
    interrupted: &AtomicBool,
) -> Visited<(State, Vec<Option<State>>)> {
    let axis = GridAxis {
        drives: drives.clone(),
        values: changes.to_vec(),
    };
    // This small number of places is always accepted.
    let grid = Grid::new(mechanism, vec![axis], CountedFrom::Start).unwrap_or_default();
    let mut read = |place: &dyn Place| {
        let per = drives.iter().map(|(drive, _)| place.per(*drive));
        (place.state(), per.collect())
    };
    mechanism.visit(&grid, DerivativeOrder::First, interrupted, &mut read)
}

/// The usual largest change of a drive to either side: in the unit of lengths, or in radians.
pub fn usual_change(effect: Effect, kind: DriveKind, unit: Unit) -> f64 {
    match kind {
        DriveKind::Coordinate => USUAL[usize::from(effect == Effect::Steer)] * unit.metre(),
        DriveKind::Angle | DriveKind::Turn => USUAL_ANGLE,
    }
}

/// Returns the first failure if places of a range are missing, and notes on the modes before it. A lock within a range that
/// the user does not state is no failure: a note says that the curves end there.
pub fn unmet_range(modes: &[ModeStates], file: &str) -> (Vec<String>, Option<Failure>) {
    let mut notes = Vec::new();
    for mode in modes {
        let Some(failure) = mode.visited.failure(file) else {
            continue;
        };
        let has_places = mode.visited.places.iter().any(Option::is_some);
        if !mode.is_usual || !has_places || !matches!(failure, Failure::Solver(_)) {
            return (notes, Some(failure));
        }
        let title = &mode.title;
        let option = match mode.movement.effect {
            Effect::Steer => "--steer",
            _ => "--travel",
        };
        notes.push(format!(
            "the usual range of {title} is longer than its reach, where its curves end; {option} sets another range. {failure}"
        ));
    }
    (notes, None)
}

/// The failure that an option moves a drive that steers although no drive does.
pub fn no_steering(file: &str) -> Failure {
    Failure::Input(format!(
        "{file}: no drive steers, so --steer has no effect; if one does, write [vehicle] with steer = \"NAME\""
    ))
}

/// The number of the span that a mode moves through: that of travel or that of steering.
pub(super) fn option_of(mode: &Mode) -> usize {
    usize::from(mode.effect == Effect::Steer)
}

/// The part of a span that a mode moves through: in roll, where one wheel moves down as far as the other moves up, the
/// part in which neither leaves the span. `None` if there is none.
fn within_travel(effect: Effect, [from, to]: [f64; 2]) -> Option<[f64; 2]> {
    let end = to.min(-from);
    match effect {
        Effect::Roll => (end > 0.0).then_some([-end, end]),
        Effect::Travel | Effect::Steer => Some([from, to]),
    }
}

/// A sentence on the range of the curves over roll, if a stated travel is longer to one side than to the other.
pub fn shorter_roll(mechanism: &dyn Kinematics, travel: Option<Span>) -> Option<String> {
    let Span([from, to]) = travel.filter(|Span([from, to])| *from != -to)?;
    let mut modes = Mode::all(mechanism).into_iter();
    modes.find(|mode| mode.effect == Effect::Roll)?;
    Some(match within_travel(Effect::Roll, [from, to]) {
        Some(ends) => {
            let [low, high] = ends.map(number);
            format!(
                "the curves over roll are from {low} to {high}, as one wheel moves down as far as the other moves up, and \
                 neither leaves --travel"
            )
        }
        None => "there are no curves over roll, as within --travel no wheel moves both up and down"
            .to_owned(),
    })
}

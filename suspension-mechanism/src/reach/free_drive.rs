//! One drive set free, and its curve followed both ways.

use std::sync::atomic::{AtomicBool, Ordering};

use suspension_core::path::{Continuation, Curve, End, Place, Stretch};
use suspension_core::{Signal, Values};

use crate::failure::Failure;
use crate::mechanism::{DrivenLength, Mechanism, State, Suspension};
use crate::reach::drive_range::{DriveRange, Station};
use crate::reach::limit::{Limit, RangeEnd, fault_beyond};

/// The longest step, as a fraction of the linkage's size: curves are drawn through the places.
const LONGEST: f64 = 0.01;

/// The curve in one direction from the start.
struct Run {
    stations: Vec<Station>,
    /// The indices of turning points among them, and whether each is an end of the angle.
    turns: Vec<(usize, bool)>,
    limit: Limit,
    gap: Option<f64>,
}

/// The range of the drive with this index, with the others held as at the first instant.
///
/// # Errors
///
/// [`Failure::Solver`] if the curve has no start.
pub fn range<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    index: usize,
    interrupted: &AtomicBool,
) -> Result<DriveRange, Failure> {
    let [down, up] = [false, true].map(|up| run(mechanism, index, up, interrupted));
    let (down, up) = (down?, up?);
    let ends = [&down, &up].map(|run| run.end(mechanism, index));
    let usable = [&down, &up].map(Run::usable);
    let backwards = usable[0].iter().skip(1).rev();
    let usable = backwards.chain(usable[1]).cloned().collect();
    let gap = up.gap;
    let turning_points = |run: &Run| run.turns.iter().filter(|(_, is_end)| !is_end).count();
    let mut turns = turning_points(&up);
    let curve = if gap.is_some() {
        up.stations
    } else {
        turns += turning_points(&down);
        let back = down.stations.into_iter().skip(1).rev();
        back.chain(up.stations).collect()
    };
    let drive = &mechanism.names.drives[index];
    Ok(DriveRange {
        name: drive.name.clone(),
        index,
        kind: drive.kind,
        start: mechanism.drives_in_file(mechanism.first_drives())[index],
        ends,
        usable,
        curve,
        turns,
        gap,
    })
}

/// The curve in one direction from the first instant.
fn run<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    index: usize,
    increasing: bool,
    interrupted: &AtomicBool,
) -> Result<Run, Failure> {
    let settings = Continuation {
        longest: LONGEST,
        ..Continuation::default()
    };
    let [first, _] = mechanism.instants.ends();
    let inputs = mechanism.drives.inputs(first);
    let curve = Curve::new(&mechanism.model, &inputs, index)
        .ok_or_else(|| Failure::Solver("no such drive".to_owned()))?;
    let lost = |error| mechanism.names.cause(&error);
    let mut path = settings
        .path(curve, &mechanism.start.position, increasing)
        .map_err(|error| {
            let drive = &mechanism.names.drives[index].name;
            Failure::Solver(format!(
                "the curve of the drive `{drive}` has no start: {}",
                lost(error)
            ))
        })?;
    let mut run = Run {
        stations: vec![station(mechanism, index, path.curve(), path.here())],
        turns: Vec::new(),
        limit: Limit::Cut,
        gap: None,
    };
    while !interrupted.load(Ordering::Relaxed) {
        match path.next() {
            Some(Ok(stretch)) => {
                let at = |place: &_| station(mechanism, index, path.curve(), place);
                run.extend(&stretch, at);
            }
            Some(Err(error)) => {
                run.limit = Limit::Lost(lost(error));
                break;
            }
            None => break,
        }
    }
    Ok(run)
}

/// The mechanism at a place of the curve.
fn station<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    index: usize,
    curve: &Curve<'_, L, N>,
    place: &Place<f64, N>,
) -> Station {
    let [first, _] = mechanism.instants.ends();
    let drives = mechanism.start_drives().with(index, place.value);
    let state = State {
        residual: place.residual,
        ..mechanism.state_at_rest(first, &drives, curve.points(&place.configuration))
    };
    Station {
        freed: index,
        turns: false,
        speed: speed(curve, place, mechanism.names.free),
        state: mechanism.with_velocities(state, drives, &place.configuration.unknowns),
    }
}

/// The distance that the free points move per unit of the drive.
fn speed<L: Suspension<N>, const N: usize>(
    curve: &Curve<'_, L, N>,
    place: &Place<f64, N>,
    free: usize,
) -> f64 {
    let (tangent, at) = (&place.tangent, &place.configuration);
    let drive = curve.value(&Signal {
        value: at.drive,
        rate: tangent.drive,
        second_rate: 0.0,
    });
    // The unknowns begin with the coordinates of the free points.
    tangent.unknowns.rows(0, 3 * free).norm() / drive.rate.abs()
}

impl Run {
    /// Extends the curve by a stretch, whose turning point comes before its end.
    fn extend<const N: usize>(
        &mut self,
        stretch: &Stretch<f64, N>,
        at: impl Fn(&Place<f64, N>) -> Station,
    ) {
        if let Some(turning) = &stretch.turning {
            let is_end = turning.is_end_of_angle;
            self.turns.push((self.stations.len(), is_end));
            // At the end of an angle its cosine turns, while the points move on with the angle.
            let speed = match self.stations.last() {
                Some(before) if is_end => before.speed,
                _ => f64::INFINITY,
            };
            self.stations.push(Station {
                turns: true,
                speed,
                ..at(&turning.place)
            });
        }
        self.stations.push(at(&stretch.place));
        match stretch.end {
            Some(End::Closed { gap }) => self.gap = Some(gap),
            Some(End::Bifurcation { accuracy }) => self.limit = Limit::Bifurcation(accuracy),
            Some(End::Range | End::OutOfRange | End::Steps) | None => {}
        }
    }

    /// The end of the drive's range.
    fn end<L: Suspension<N>, const N: usize>(
        &self,
        mechanism: &Mechanism<L, N>,
        drive: usize,
    ) -> RangeEnd {
        let place = self
            .turns
            .first()
            .map_or(self.stations.len() - 1, |(place, _)| *place);
        let value = self.stations[place].value();
        let limit = match self.turns.first() {
            Some((_, true)) => Limit::EndOfAngle,
            Some((_, false)) => Limit::Locks {
                fault: fault_beyond(mechanism, drive, value),
            },
            None => zero_length(mechanism, drive, value).unwrap_or_else(|| self.limit.clone()),
        };
        RangeEnd { value, limit }
    }

    /// The stations up to that end.
    fn usable(&self) -> &[Station] {
        let first = self.turns.first();
        first.map_or(&self.stations, |(place, _)| &self.stations[..=*place])
    }
}

/// The limit that the drive's value is a length of zero, if it is.
fn zero_length<L: Suspension<N>, const N: usize>(
    mechanism: &Mechanism<L, N>,
    drive: usize,
    value: f64,
) -> Option<Limit> {
    let mut drives = mechanism.drives_in_file(mechanism.first_drives());
    drives[drive] = value;
    let lengths = &mechanism.names.driven_lengths;
    let length = DrivenLength::at_zero(lengths, &drives, mechanism.model.size())?;
    (length.drive == drive).then(|| Limit::ZeroLength(length.fault()))
}

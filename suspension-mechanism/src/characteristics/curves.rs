//! Curves over travel or steering.

use crate::characteristics::line::{Line, Sort};
use crate::characteristics::mode_states::ModeStates;
use crate::characteristics::movement::{Effect, Movement};
use crate::characteristics::parameters::{columns_of_curves, symbol_per};
use crate::characteristics::poles::{cut_at_jumps, has_poles, remove_far};
use crate::characteristics::small_steer::{LEAST_STEER, leave_out};
use crate::characteristics::title::Title;
use crate::file::Dimension;
use crate::mechanism::{Description, Pair, State, Unit};
use crate::quantities::{ACKERMANN, Column, MEASURES, ROLL_CENTRE, place_in_curves};

/// The curves along a drive, those that a reader looks for first before the others.
#[derive(Clone)]
pub struct Curves {
    /// The name of what moves: see [`ModeStates`].
    pub title: String,
    /// The effect of the drives.
    pub movement: Movement,
    /// A description of what moves.
    pub moved: String,
    /// The dimension of the change.
    pub dimension: Dimension,
    /// The changes from the design position, in units for people.
    pub changes: Vec<f64>,
    /// The lines, one per quantity.
    pub lines: Vec<Line>,
    /// The quantities without a line, as they pass through infinity.
    pub left_out: Vec<Title>,
    /// Whether the Ackermann percentage is left out at small steer angles.
    pub is_without_small_steer: bool,
}

impl Curves {
    /// Says that the Ackermann percentage is left out at small steer angles, if it is.
    pub fn without_small_steer(&self) -> Option<String> {
        self.is_without_small_steer.then(|| {
            format!(
                "{}: left out where a wheel is steered by less than {LEAST_STEER} deg, as static toe determines it there. \
                 suspension sweep writes all values",
                ACKERMANN.title
            )
        })
    }

    /// The label of an axis of the drive.
    pub fn axis_label(&self, unit: Unit) -> String {
        let (_, symbol) = self.dimension.display_scale(unit);
        format!("{} ({symbol})", self.moved)
    }

    /// The points of a line; the height of a missing one is NaN.
    pub fn points(&self, line: &Line) -> Vec<(f64, f64)> {
        let places = self.changes.iter().zip(&line.values);
        places
            .map(|(change, value)| (*change, value.unwrap_or(f64::NAN)))
            .collect()
    }
}

/// Reads a number from a state, and from the state with derivatives with respect to each drive.
type OfPlace<'a> = dyn Fn(&State, &[Option<State>]) -> Option<f64> + 'a;

/// All quantities along a drive, or along several, with lengths in `unit`; for measures also their derivatives, which
/// are motion ratios. Left out are, over roll, the roll centres of single wheels, which are none of the axle; the Ackermann
/// percentage at small steer angles; and, if there are several axles, quantities of one that do not change when another
/// moves.
pub fn curves(mechanism: &Description, mode: &ModeStates, unit: Unit) -> Curves {
    let read = Read {
        mechanism,
        mode,
        unit,
    };
    let mut columns = columns_of_curves(mechanism);
    columns.retain(|column| mode.movement.effect != Effect::Roll || !column.is(&ROLL_CENTRE));
    columns.sort_by_key(|column| place_in_curves(column.quantity));
    let columns = columns.iter();
    let mut lines: Vec<Line> = columns.flat_map(|column| read.lines(column)).collect();
    let is_without_small_steer = leave_out(&mut lines);
    let is_short = |line: &Line| line.values.iter().flatten().count() < 2;
    let is_left_out = |line: &mut Line| line.is_cut && is_short(line);
    let left_out = lines.extract_if(.., is_left_out);
    let left_out = left_out.map(|line| line.title).collect();
    lines.retain(|line| !is_short(line));
    if Pair::all(&mechanism.names.wheels).len() > 1 {
        lines.retain(Line::varies);
    }
    let dimension = read.drive_dimension();
    let (per_change, _) = read.converted(dimension);
    let changes = mode.changes.iter().map(|change| change * per_change);
    Curves {
        title: mode.title.clone(),
        movement: mode.movement,
        moved: mode.moved.clone(),
        dimension,
        changes: changes.collect(),
        lines,
        left_out,
        is_without_small_steer,
    }
}

/// The source of the curves, and the unit of their lengths.
struct Read<'a> {
    mechanism: &'a Description,
    mode: &'a ModeStates,
    unit: Unit,
}

impl Read<'_> {
    fn drive_dimension(&self) -> Dimension {
        Dimension::from(self.mode.kind)
    }

    /// The factor to the unit for people, and the unit's symbol.
    fn converted(&self, dimension: Dimension) -> (f64, String) {
        let (scale, symbol) = dimension.display_scale(self.unit);
        (
            scale * dimension.conversion(self.mechanism.unit, self.unit),
            symbol,
        )
    }

    /// A number at each place; `None` where the mechanism is out of reach, or the number is not finite.
    fn values(&self, value: &OfPlace<'_>) -> Vec<Option<f64>> {
        let places = self.mode.visited.places.iter();
        let value = |place: &Option<(State, Vec<Option<State>>)>| {
            let (state, per) = place.as_ref()?;
            value(state, per).filter(|value| value.is_finite())
        };
        places.map(value).collect()
    }

    /// The derivatives of a number, in units for people, with respect to the drive in the file's unit.
    fn rates(&self, column: &Column, scale: f64) -> Vec<Option<f64>> {
        let of_drive = self.drive_dimension();
        let of_change = of_drive.conversion(self.mechanism.unit, self.unit);
        let per = scale / (of_change * self.unit.file_factor(of_drive));
        self.values(&|_, states| Some(rate(column, self.mode, states)? * per))
    }

    /// The curve of a number; for a measure, preceded by its motion ratio.
    fn lines(&self, column: &Column) -> Vec<Line> {
        let (scale, symbol) = self.converted(column.dimension);
        let title = Title::new(column, &self.mechanism.names.wheels);
        let rates = self.rates(column, scale);
        let is_measure = column.is(&MEASURES);
        let motion_ratio = is_measure.then(|| Line {
            title: Title {
                of_wheel: format!("motion ratio: {} per {}", title.of_wheel, self.mode.title),
                ..title.clone()
            },
            quantity: column.title(),
            symbol: symbol_per(&symbol, self.drive_dimension(), self.unit),
            rates: vec![None; rates.len()],
            values: rates.clone(),
            is_cut: false,
            sort: Sort::MotionRatio,
        });
        let values = self.values(&|state, _| Some(column.value(state) * scale));
        let may_be_far = has_poles(column);
        let drawn = match may_be_far {
            true => cut_at_jumps(&remove_far(&values, self.unit.metre())),
            false => values.clone(),
        };
        let curve = Line {
            title,
            quantity: column.title(),
            symbol,
            is_cut: drawn != values,
            values: drawn,
            rates,
            sort: if is_measure {
                Sort::Measure
            } else {
                Sort::Quantity
            },
        };
        motion_ratio.into_iter().chain([curve]).collect()
    }
}

/// The derivative of a number with respect to the change, from the derivatives with respect to the drives.
fn rate(column: &Column, mode: &ModeStates, per: &[Option<State>]) -> Option<f64> {
    let mut drives = mode.drives.iter().zip(per);
    drives.try_fold(0.0, |sum, ((_, part), state)| {
        Some(sum + part * column.along(state.as_ref()?).rate)
    })
}

//! A quantity, and the columns of numbers that it makes.

use suspension_core::Signal;

use crate::file::Dimension;
use crate::mechanism::{Drive, Names, State, Unit};
use crate::quantities::axis::Axis;
use crate::quantities::formulas::{Compiled, Formulas, Read, Reading};
use crate::quantities::reader::Reader;

/// What is read off a mechanism: a row of the catalogue.
pub struct Quantity {
    /// What it is called.
    pub title: &'static str,
    /// Its name in tables; empty where it is one of several things that the linkage names.
    pub name: &'static str,
    /// What is positive; empty where that goes without saying.
    pub sign: &'static str,
    /// What it is, by a formula where there is one.
    pub definition: &'static str,
    /// Where the definition is from.
    pub source: &'static str,
    /// The lines of `[vehicle]` without which a mechanism does not have it, in words; empty where the linkage alone decides.
    pub vehicle: &'static str,
    /// Where it is shown.
    pub shown: Shown,
    /// Its numbers; none where the linkage has no such thing.
    pub(super) read: Formulas,
}

/// Where a quantity is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// In tables of all numbers, as CSV files are.
    InTables,
    /// In summaries, as it stands in tables under another name.
    InSummaries,
    /// In both.
    InBoth,
}

/// A column of numbers: one number of a quantity, read of any state of a mechanism.
pub struct Column<N = Signal<f64>> {
    /// The quantity.
    pub quantity: &'static Quantity,
    /// What it is the quantity of, or else the quantity's name, behind the wheel's: `left_camber`.
    pub name: String,
    /// The name of the wheel that it is of, where that has one.
    pub wheel: Option<String>,
    /// What it measures.
    pub dimension: Dimension,
    /// The component, of a vector.
    pub axis: Option<Axis>,
    /// Whether [`read`](Self::read) has derivatives: whether positions alone determine it.
    pub has_derivatives: bool,
    value: Box<Read<N>>,
}

impl Column {
    /// Its number in a state: lengths in the file's unit, angles in radians.
    pub fn value(&self, state: &State) -> f64 {
        self.along(state).value
    }

    /// The same with its derivatives: see [`read`](Self::read).
    pub fn along(&self, state: &State) -> Signal<f64> {
        self.read(&Reader::of(state))
    }
}

impl<N: Compiled> Column<N> {
    /// The number with its derivatives, those of a [`State`] along the rates of its points: with respect to time, or to a
    /// drive. They are NaN of what is not determined by positions.
    pub fn read(&self, reader: &Reader<'_, N>) -> N {
        (self.value)(reader)
    }

    /// Its name without a unit: `camber`, `roll_centre_z`.
    pub fn title(&self) -> String {
        let axis = self.axis.map(|axis| format!("_{axis}"));
        format!("{}{}", self.name, axis.unwrap_or_default())
    }

    /// The same of its derivative with respect to a drive, where there is one: `camber per bump`.
    pub fn title_per(&self, drive: Option<&Drive>) -> String {
        let per = drive.map(|drive| format!(" per {}", drive.name));
        self.title() + &per.unwrap_or_default()
    }

    /// What a number inside, or its derivative with respect to a drive, is multiplied with for that in the file.
    pub fn in_file_per(&self, drive: Option<&Drive>, unit: Unit) -> f64 {
        let per = drive.map_or(1.0, |drive| Dimension::from(drive.kind).in_file(unit));
        self.dimension.in_file(unit) / per
    }

    /// The same for what people read, and the unit's symbol.
    pub fn for_people_per(&self, drive: Option<&Drive>, unit: Unit) -> (f64, String) {
        let (scale, symbol) = self.dimension.for_people(unit);
        match drive.map(|drive| drive.kind) {
            Some(dimension) => {
                let symbol = format!("{symbol}/{}", Dimension::from(dimension).symbol(unit));
                (scale / Dimension::from(dimension).in_file(unit), symbol)
            }
            None => (scale, symbol),
        }
    }

    /// Its name in a CSV file: `p6_x`, `p6_vx`, `omega_x`, `camber_rad`.
    pub fn csv_name(&self, unit: Unit) -> String {
        self.name_with(&self.dimension.symbol(unit))
    }

    /// The same of numbers for people: `camber_deg`.
    pub fn name_for_people(&self, unit: Unit) -> String {
        let (_, symbol) = self.dimension.for_people(unit);
        self.name_with(&symbol)
    }

    fn name_with(&self, symbol: &str) -> String {
        let Self {
            name, dimension, ..
        } = self;
        match (self.axis, dimension) {
            (Some(axis), Dimension::Velocity) => format!("{name}_v{axis}"),
            (Some(axis), Dimension::Acceleration) => format!("{name}_a{axis}"),
            (Some(axis), _) => format!("{name}_{axis}"),
            (None, Dimension::Count) => name.clone(),
            (None, _) => format!("{name}_{}", symbol.replace('/', "_").replace('^', "")),
        }
    }

    /// Above a column for people: `camber (deg)`, `centre x (m)`.
    pub fn heading(&self, unit: Unit) -> String {
        let (_, symbol) = self.dimension.for_people(unit);
        let axis = self
            .axis
            .map_or_else(String::new, |axis| format!(" {axis}"));
        format!("{}{axis} ({symbol})", self.name)
    }

    /// Whether it is one of a quantity's.
    pub fn is(&self, quantity: &Quantity) -> bool {
        std::ptr::eq(self.quantity, quantity)
    }
}

/// The columns of quantities that a linkage has, in their order.
pub fn columns(
    quantities: impl IntoIterator<Item = &'static Quantity>,
    names: &Names,
) -> Vec<Column> {
    columns_in(quantities, names)
}

/// The same that are read in other numbers.
pub fn columns_in<N: Compiled>(
    quantities: impl IntoIterator<Item = &'static Quantity>,
    names: &Names,
) -> Vec<Column<N>> {
    let of_reading = |quantity: &'static Quantity, reading: Reading<N>| {
        let name = reading.name.unwrap_or_else(|| quantity.name.to_owned());
        Column {
            quantity,
            name: match &reading.wheel {
                Some(wheel) => format!("{wheel}_{name}"),
                None => name,
            },
            wheel: reading.wheel,
            dimension: reading.dimension,
            axis: reading.axis,
            has_derivatives: reading.has_derivatives,
            value: reading.value,
        }
    };
    let of_one = |quantity: &'static Quantity| {
        let readings = N::readings(&quantity.read, names).into_iter();
        readings.map(move |reading| of_reading(quantity, reading))
    };
    quantities.into_iter().flat_map(of_one).collect()
}

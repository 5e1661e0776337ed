//! A quantity, and the columns of numbers that it makes.

use suspension_core::Signal;

use crate::file::Dimension;
use crate::mechanism::{Drive, Names, State, Unit};
use crate::quantities::axis::Axis;
use crate::quantities::formulas::{Compiled, Formulas, Read, Reading};
use crate::quantities::reader::Reader;

/// A quantity that is read from a mechanism: a row of the catalogue.
pub struct Quantity {
    /// Its name for people.
    pub title: &'static str,
    /// Its name in tables; empty if it belongs to one of several things that the linkage names.
    pub name: &'static str,
    /// The positive direction; empty if that is obvious.
    pub sign: &'static str,
    /// Its definition, as a formula if there is one.
    pub definition: &'static str,
    /// The source of the definition.
    pub source: &'static str,
    /// The lines of `[vehicle]` that a mechanism needs to have it, in words; empty if the linkage alone decides.
    pub vehicle: &'static str,
    /// For a quantity that is zero at the design position, the one that changes in the same way.
    pub zero_at_design: Option<(&'static Quantity, Option<Axis>)>,
    /// The outputs in which it is shown.
    pub shown: Shown,
    /// Its numbers; none if the linkage lacks what it describes.
    pub(super) read: Formulas,
}

/// Two are the same if they are one row of the catalogue.
impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Eq for Quantity {}

/// The outputs in which a quantity is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// Tables of all numbers, such as CSV files.
    InTables,
    /// Summaries, because tables have it under another name.
    InSummaries,
    /// Both.
    InBoth,
}

/// A column of numbers: one number of a quantity, read from any state of a mechanism.
pub struct Column<N = Signal<f64>> {
    /// The quantity.
    pub quantity: &'static Quantity,
    /// The name of what the quantity belongs to, otherwise the quantity's name after that of the wheel:
    /// `left_camber`.
    pub name: String,
    /// The name of the wheel to which it belongs, if that has one.
    pub wheel: Option<String>,
    /// Its dimension.
    pub dimension: Dimension,
    /// The component, for a vector.
    pub axis: Option<Axis>,
    /// Whether [`read`](Self::read) has derivatives, that is, whether positions alone determine it.
    pub has_derivatives: bool,
    value: Box<Read<N>>,
}

impl Column {
    /// Its value in a state: lengths in the file's unit, angles in radians.
    pub fn value(&self, state: &State) -> f64 {
        self.along(state).value
    }

    /// The value with its derivatives: see [`read`](Self::read).
    pub fn along(&self, state: &State) -> Signal<f64> {
        self.read(&Reader::new(state))
    }
}

impl<N: Compiled> Column<N> {
    /// The number with its derivatives. Those of a [`State`] are along the rates of its points: with respect to time,
    /// or to a drive. They are NaN if positions do not determine the number.
    pub fn read(&self, reader: &Reader<'_, N>) -> N {
        (self.value)(reader)
    }

    /// Its name without a unit: `camber`, `roll_centre_z`.
    pub fn title(&self) -> String {
        let axis = self.axis.map(|axis| format!("_{axis}"));
        format!("{}{}", self.name, axis.unwrap_or_default())
    }

    /// The name of its derivative with respect to a drive, if one is given: `camber per bump`.
    pub(crate) fn title_per(&self, drive: Option<&Drive>) -> String {
        let per = drive.map(|drive| format!(" per {}", drive.name));
        self.title() + &per.unwrap_or_default()
    }

    /// The factor from the number, or its derivative with respect to a drive, to its value in the file.
    pub(crate) fn file_factor_per(&self, drive: Option<&Drive>, unit: Unit) -> f64 {
        let per = drive.map_or(1.0, |drive| unit.file_factor(drive.kind));
        unit.file_factor(self.dimension) / per
    }

    /// The factor to the value for people, and the symbol of its unit.
    pub(crate) fn display_scale_per(&self, drive: Option<&Drive>, unit: Unit) -> (f64, String) {
        let (scale, symbol) = self.dimension.display_scale(unit);
        match drive.map(|drive| Dimension::from(drive.kind)) {
            Some(per) => {
                let symbol = format!("{symbol}/{}", per.symbol(unit));
                (scale / unit.file_factor(per), symbol)
            }
            None => (scale, symbol),
        }
    }

    /// Its name in a CSV file: `p6_x`, `p6_vx`, `omega_x`, `camber_rad`.
    pub fn csv_name(&self, unit: Unit) -> String {
        self.name_with(&self.dimension.symbol(unit))
    }

    /// Its name for people: `camber_deg`.
    pub fn name_for_people(&self, unit: Unit) -> String {
        let (_, symbol) = self.dimension.display_scale(unit);
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

    /// The heading of a column for people, without its unit: `camber`, `centre x`.
    pub fn heading(&self) -> String {
        let axis = self
            .axis
            .map_or_else(String::new, |axis| format!(" {axis}"));
        format!("{}{axis}", self.name)
    }

    /// Whether it belongs to a quantity.
    pub fn is(&self, quantity: &Quantity) -> bool {
        self.quantity == quantity
    }
}

/// The columns of quantities that a linkage has, in their order.
pub fn columns(
    quantities: impl IntoIterator<Item = &'static Quantity>,
    names: &Names,
) -> Vec<Column> {
    columns_in(quantities, names)
}

/// The same columns, read in another number type.
pub(crate) fn columns_in<N: Compiled>(
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

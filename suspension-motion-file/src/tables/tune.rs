//! Tuning in a motion file: the points that may move, and the targets.

use serde::Deserialize;
use toml::Spanned;

use crate::tables::entries::Table;
use crate::tables::number_list::{NumberList, number_list};
use crate::tables::several_notations::written_as_table;
use crate::tables::target_values::{CsvTable, TargetValues};

/// The table `[tune]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct TuneTable {
    /// The moves by name.
    pub moves: Table<MoveTable>,
    /// The targets by name.
    pub targets: Table<TargetTable>,
}

written_as_table!(
    TuneTable,
    "moves and targets under [tune.moves.NAME] and [tune.targets.NAME]"
);

impl TuneTable {
    /// The files of measurements that the targets name.
    pub(crate) fn measured(&self) -> impl Iterator<Item = &CsvTable> {
        let targets = self.targets.get_ref().values().map(Spanned::get_ref);
        let wanted = targets.flat_map(|target| [&target.value, &target.change]);
        wanted
            .flatten()
            .filter_map(|wanted| match wanted.get_ref() {
                TargetValues::Csv(table) => Some(table),
                _ => None,
            })
    }
}

/// A move of points that move together, or a change of a length.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct MoveTable {
    /// Points that move together.
    #[serde(default)]
    pub points: Vec<Spanned<String>>,
    /// Points on the other side of the vehicle that make the mirrored move, or links whose lengths change together with
    /// `length`.
    #[serde(default)]
    pub mirrored: Vec<Spanned<String>>,
    /// The direction of the move.
    pub along: Option<Spanned<Direction>>,
    /// The link whose length changes, in place of points.
    pub length: Option<Spanned<String>>,
    /// The least and the greatest displacement or change of length, in the unit of lengths.
    pub by: Spanned<NumberList<2>>,
}

written_as_table!(
    MoveTable,
    "a move, which has a name: write its lines under [tune.moves.NAME]"
);

/// A direction in the file's axes.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "expected \"x\", \"y\", \"z\" or [x, y, z]")]
pub enum Direction {
    /// Along an axis.
    Axis(AxisName),
    /// Along a vector other than zero.
    Vector(#[serde(deserialize_with = "number_list")] [f64; 3]),
}

/// An axis.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AxisName {
    /// The longitudinal axis.
    X,
    /// The lateral axis.
    Y,
    /// The vertical axis.
    Z,
}

/// A quantity, where it is read, and its target value there.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields, remote = "Self")]
pub struct TargetTable {
    /// The quantity, by its name in tables without the unit: `toe`, `left_camber`, `roll_centre`, a measure.
    pub of: Spanned<String>,
    /// The drive with respect to which the derivative of the quantity is the target.
    pub per: Option<Spanned<String>>,
    /// Drives, or drives joined by commas that move together, with their ranges from the design position; without it the target
    /// holds at the design position.
    pub over: Option<Table<NumberList<2>>>,
    /// The target value.
    pub value: Option<Spanned<TargetValues>>,
    /// The target change from the design position.
    pub change: Option<Spanned<TargetValues>>,
    /// The largest permitted deviation.
    pub within: Spanned<f64>,
}

written_as_table!(
    TargetTable,
    "a target, which has a name: write its lines under [tune.targets.NAME]"
);

//! Tuning in a motion file: the points that may move, and the targets.

use serde::Deserialize;
use toml::Spanned;

use crate::number_list::{NumberList, number_list};
use crate::table::{Table, UnderName, under_names};

/// The table `[tune]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TuneTable {
    /// What may be moved, by name.
    #[serde(deserialize_with = "under_names")]
    pub moves: Table<MoveTable>,
    /// What is to be reached, by name.
    #[serde(deserialize_with = "under_names")]
    pub targets: Table<TargetTable>,
}

/// Points that move together, or a length.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MoveTable {
    /// Points that move together.
    #[serde(default)]
    pub points: Vec<Spanned<String>>,
    /// Points that move with them on the other side of the vehicle, or links that become longer with the one of `length`.
    #[serde(default)]
    pub mirrored: Vec<Spanned<String>>,
    /// The way that points move.
    pub along: Option<Spanned<Direction>>,
    /// In place of points the length of a link.
    pub length: Option<Spanned<String>>,
    /// The least and the greatest that they are moved, or that the length is made longer, in the unit.
    pub by: Spanned<NumberList<2>>,
}

impl UnderName for MoveTable {
    const EXPECTED: &str = "a move, which has a name: write its lines under [tune.moves.NAME]";
}

/// A direction in the file's axes.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "expected \"x\", \"y\", \"z\" or [x, y, z]")]
pub enum Direction {
    /// Along an axis.
    Axis(AxisName),
    /// Of any vector but zero.
    Vector(#[serde(deserialize_with = "number_list")] [f64; 3]),
}

/// An axis.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AxisName {
    /// Along the vehicle.
    X,
    /// Across it.
    Y,
    /// The vertical one.
    Z,
}

/// A quantity, where it is read, and what it is to be there.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TargetTable {
    /// The quantity, by its name in tables without the unit: `toe`, `left_camber`, `roll_centre`, a measure.
    pub of: Spanned<String>,
    /// The drive with respect to which its derivative is meant.
    pub per: Option<Spanned<String>>,
    /// Drives with how far they go from the design position; without it the quantity is read there.
    pub over: Option<Table<NumberList<2>>>,
    /// What it is to be.
    pub value: Option<Spanned<Wanted>>,
    /// What it is to differ by from the design position.
    pub change: Option<Spanned<Wanted>>,
    /// How far it may be off.
    pub within: Spanned<f64>,
}

impl UnderName for TargetTable {
    const EXPECTED: &str = "a target, which has a name: write its lines under [tune.targets.NAME]";
}

/// One number for all places, or one for each.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "expected a number, or one for each of evenly spaced values of the drive as [0.0, 0.1, 0.3]"
)]
pub enum Wanted {
    /// The same everywhere.
    Everywhere(f64),
    /// At evenly spaced values of the drive, from the first to the last.
    Each(Vec<f64>),
}

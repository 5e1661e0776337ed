//! The plan that the solver walks: a listing as indices. It is made once for a listing and has no numbers of a
//! geometry.

mod clusters;
mod elimination;
pub(crate) mod lengths;
mod places;
mod readout;
mod room;
mod substitution;

use suspension_listing::eliminate::EliminationOrder;
use suspension_listing::system::System;

use crate::form::Forms;
use crate::site::Site;
use crate::size::LARGEST;
use crate::table::{SPARE, index};

pub(crate) use clusters::Cluster;
pub(crate) use elimination::{Elimination, Step};
pub(crate) use lengths::{BodyPoint, Length, LengthNames, LineLength};
pub(crate) use readout::{Coordinate, Drive, Measure, Wheel};
pub(crate) use substitution::{Carrier, Term};

/// The last place but one: zero among the numbers of the factors.
pub(crate) const ZERO: u16 = u16::MAX - 1;

/// The indices of a listing.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) unknowns: u16,
    /// The number of free points: their coordinates are the first unknowns.
    pub(crate) free: u16,
    pub(crate) chassis: u16,
    /// The equations with derivatives at their places in the factors.
    pub(crate) forms: Forms,
    /// The equations with derivatives at their [places in the matrix](place_in_matrix).
    pub(crate) forms_in_matrix: Forms,
    /// Whether drives move each chassis point.
    pub(crate) driven: Vec<bool>,
    pub(crate) elimination: Elimination,
    pub(crate) drives: Vec<Drive>,
    pub(crate) measures: Vec<Measure>,
    /// The sites that carry each marker.
    pub(crate) markers: Vec<[Site; 3]>,
    pub(crate) clusters: Vec<Cluster>,
    pub(crate) lengths: Vec<Length>,
    pub(crate) wheels: Vec<Wheel>,
}

impl Plan {
    pub(crate) fn new(system: &System, order: &EliminationOrder) -> Self {
        let elimination = Elimination::new(system, order);
        let lengths = LengthNames::new(system);
        let drives = readout::drives(system);
        let moves = |point| drives.iter().any(|drive| drive.moves == Some(point));
        let forms =
            |entries: &dyn Fn(usize, Option<usize>) -> u16| Forms::new(system, &lengths, entries);
        Self {
            unknowns: index(system.size()),
            free: index(system.free.len()),
            chassis: index(system.fixed.len()),
            forms: forms(&|row, column| elimination.entry(row, column)),
            forms_in_matrix: forms(&entry_in_matrix),
            driven: (0..).take(system.fixed.len()).map(moves).collect(),
            drives,
            measures: readout::measures(system),
            markers: (system.markers.iter())
                .map(|marker| marker.frame.each_ref().map(Site::from))
                .collect(),
            clusters: clusters::clusters(system, &lengths),
            lengths: lengths.lengths(),
            wheels: readout::wheels(system),
            elimination,
        }
    }

    /// The number of chassis points, free points and markers.
    pub(crate) fn points(&self) -> usize {
        usize::from(self.chassis) + usize::from(self.free) + self.markers.len()
    }

    /// The number of points of clusters, without those of their frames.
    pub(crate) fn linked(&self) -> usize {
        let clusters = self.clusters.iter();
        clusters.map(|cluster| cluster.points.len()).sum()
    }
}

/// The index of an entry of the whole matrix, by its row and column.
fn entry_in_matrix(row: usize, column: Option<usize>) -> u16 {
    column.map_or(SPARE, |column| index(row * LARGEST + column))
}

/// The row and column of an entry.
pub(crate) fn place_in_matrix(entry: u16) -> (usize, usize) {
    let entry = usize::from(entry);
    (entry / LARGEST, entry % LARGEST)
}

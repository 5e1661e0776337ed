//! The effects of forces at the points of a suspension.

use std::borrow::ToOwned;
use std::string::String;
use std::vec::Vec;

use suspension_core::error::{Explain, Facts};
use suspension_core::nalgebra::Vector3;
use suspension_core::statics::Loads;
use suspension_core::{Corner, Linkage, Values};
use suspension_runtime::{Listing, Model, PartForces, Room, Size};

use super::row::{Row, write};
use crate::masses::{add_at, each_force};
use crate::shared::Masses;
use crate::status::Status;

/// The parts of a listing that transmit forces.
#[derive(Clone, Debug)]
pub(super) struct Structure {
    /// The statements that hold points, without drives.
    pub(super) parts: Vec<Part>,
}

/// A statement.
#[derive(Clone, Debug)]
pub(super) struct Part {
    pub(super) name: String,
    forces: PartForces,
    /// The end points of a link.
    ends: Option<[usize; 2]>,
}

impl Structure {
    pub(super) fn of(listing: &Listing) -> Self {
        let parts = listing.parts().zip(listing.part_forces());
        let parts = parts.map(|(part, forces)| Part {
            name: part.name.to_owned(),
            ends: part.ends(),
            forces,
        });
        Self {
            parts: parts.collect(),
        }
    }
}

/// Memory for the requested results, empty if C does not ask for them: per drive, per part, and per part at
/// each point.
pub(super) struct Wanted<'a> {
    pub(super) drives: Row<'a>,
    pub(super) tensions: Row<'a>,
    pub(super) reactions: Row<'a>,
}

/// Writes the effects of forces, x, y, z at each point.
pub(super) fn read<const N: usize>(
    corner: &Corner<Model<'_, f64, N>, N>,
    structure: &Structure,
    forces: &[f64],
    wanted: Wanted<'_>,
) -> Result<(), Facts>
where
    Room<N>: Size,
{
    let statics = corner.statics();
    let statics = statics.map_err(|failure| failure.error.facts())?;
    let at = corner.points().value;
    let (forces, _) = forces.as_chunks();
    let forces = Values::from_values(forces.iter().copied().map(Vector3::from));
    let loads = statics.under(&forces);
    let loads = loads.map_err(|failure| failure.error.facts())?;
    write(loads.on_drives().values(), wanted.drives);
    let tensions = structure.parts.iter().map(|part| part.tension(&loads, &at));
    write(tensions, wanted.tensions);
    let each = wanted.reactions.len() / structure.parts.len().max(1);
    let rows = wanted.reactions.chunks_exact_mut(each.max(1));
    for (row, part) in rows.zip(&structure.parts) {
        let forces = part.forces.forces(|rows| loads.by(rows.clone()), &at);
        write(forces.values().flat_map(<[f64; 3]>::from), row);
    }
    Ok(())
}

/// Adds weight and inertia of masses, stated at the points `design`, to forces, x, y, z at each point.
pub(super) fn add_masses<const N: usize>(
    corner: &Corner<Model<'_, f64, N>, N>,
    masses: &Masses<f64>,
    design: &[f64],
    forces: &mut [f64],
) -> Result<(), Status>
where
    Room<N>: Size,
{
    let points = corner.points();
    let (design, _) = design.as_chunks();
    let place = |point: usize| {
        let stated: [f64; 3] = *design.get(point).ok_or(Status::Absent)?;
        let of = |all: &_| nth(all, point);
        Ok((stated.into(), points.map(of)))
    };
    // All masses are checked before anything is added.
    each_force(masses, place, |_, _| {})?;
    let (forces, _) = forces.as_chunks_mut();
    each_force(masses, place, |point, force| add_at(forces, point, force))
}

fn nth<P: Values<Vector3<f64>>>(all: &P, point: usize) -> Vector3<f64> {
    all.values().nth(point).unwrap_or_default()
}

impl Part {
    /// Returns the force in a link, and zero for other parts.
    fn tension<L: Linkage<N, Scalar = f64>, const N: usize>(
        &self,
        loads: &Loads<'_, L, N>,
        at: &L::Points,
    ) -> f64 {
        self.ends.map_or(0.0, |[from, to]| {
            let along = (nth(at, to) - nth(at, from)).normalize();
            let forces = self.forces.forces(|rows| loads.by(rows.clone()), at);
            nth(&forces, from).dot(&along)
        })
    }
}

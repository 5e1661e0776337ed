//! The format of a hardpoint file.

mod adams_car;
mod add_row;
mod ambiguous_rows;
mod fields;
mod heading;
mod lines;
mod lotus;
mod row;
mod row_corner;
mod table;

pub(super) use table::is_name_of_other_angle;

use super::hardpoints::Hardpoints;
use super::names::Names;
use crate::failure::Failure;
use crate::file::{Source, is_listing, is_motion};

/// Reads a file of hardpoints in the format that its content shows.
///
/// # Errors
///
/// [`Failure::Input`] with the line of a mistake, or if the file has no points.
pub(super) fn read<'a>(source: &'a Source, names: &Names) -> Result<Hardpoints<'a>, Failure> {
    let other = [
        (
            is_motion(source.text()),
            "this is a motion file already; suspension sheet takes it",
        ),
        (
            is_listing(source.text()),
            "this is a listing; a motion file names it, see suspension motion --help",
        ),
    ];
    if let Some((_, message)) = other.iter().find(|(is, _)| *is) {
        return Err(source.refuse(&(0..0), message));
    }
    let stated = if lotus::is_model(source) {
        lotus::read(source)?
    } else if adams_car::is_subsystem(source.text()) {
        adams_car::read(source, names)?
    } else {
        table::read(source, names)?
    };
    if stated.points.is_empty() {
        let message = "there are no hardpoints here; a line has a name and three numbers: x, y, z (or each of them has a line, as `lca_front_x = 130`)";
        return Err(source.refuse(&(0..0), message));
    }
    Ok(stated)
}

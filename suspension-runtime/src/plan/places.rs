//! The places of parts in a listing.

use suspension_listing::form::Form;
use suspension_listing::name::Name;
use suspension_listing::system::System;

use crate::table::{SPARE, index};

/// The index of a name among others. The front end has checked that it is there.
pub(super) fn position<'a>(mut names: impl Iterator<Item = &'a Name>, name: &Name) -> u16 {
    names.position(|other| other == name).map_or(SPARE, index)
}

/// The index of a point among chassis points, free points and markers.
pub(super) fn point(system: &System, name: &Name) -> u16 {
    position(system.points().into_iter(), name)
}

/// The index of the distance that an equation keeps.
pub(super) fn distance(system: &System, name: &Name) -> u16 {
    let equations = system.equations.iter();
    let kept = equations.filter(|equation| equation.form.equations().keeps().is_some());
    position(kept.map(|equation| &equation.named.name), name)
}

/// The index of a driven angle about an axis.
pub(super) fn turn(system: &System, name: &Name) -> u16 {
    let equations = system.equations.iter();
    let turns = equations.filter(|equation| matches!(equation.form, Form::Turn(_)));
    position(turns.map(|equation| &equation.named.name), name)
}

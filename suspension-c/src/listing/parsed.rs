//! A parsed listing and its names for C.

use core::mem::MaybeUninit;
use std::ffi::{CStr, CString};
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::nalgebra::Vector3;
use suspension_runtime::Listing;

use super::kind;
use super::loads::Structure;
use crate::names::{Naming, Text};
use crate::status::Status;

/// See the [module](self).
#[derive(Clone, Debug)]
pub struct Parsed {
    pub(super) listing: Listing,
    points: Vec<CString>,
    drives: Vec<CString>,
    measures: Vec<CString>,
    wheels: Vec<CString>,
    parts: Vec<CString>,
    pub(super) structure: Structure,
    lengths: Vec<CString>,
    equations: Vec<CString>,
    unknowns: Vec<CString>,
}

impl Parsed {
    /// Parses a text; the error has all mistakes in words.
    pub(super) fn new(text: &[u8]) -> Result<Self, String> {
        let text = core::str::from_utf8(text).map_err(|error| {
            let good = error.valid_up_to();
            format!("listing: after {good} bytes the text is not UTF-8")
        })?;
        let listing = Listing::parse(text).map_err(|mistakes| mistakes.to_string())?;
        Ok(Self::of(listing))
    }

    fn of(listing: Listing) -> Self {
        let structure = Structure::of(&listing);
        let closed = |name: &str| CString::new(name).unwrap_or_default();
        let names = |kinds: &[Kind], part: fn(usize) -> Part| {
            let count = kinds.iter().map(|kind| listing.count(*kind)).sum();
            let names = (0..count).map(|index| closed(listing.name(part(index))));
            names.collect()
        };
        let wheels = (0..).map_while(|wheel| listing.wheel(wheel));
        Self {
            points: names(&Kind::POINTS, Part::Point),
            drives: names(&[Kind::Drive], Part::Drive),
            measures: names(&[Kind::Measure], Part::Measure),
            wheels: wheels.map(|wheel| closed(wheel.name)).collect(),
            parts: structure
                .parts
                .iter()
                .map(|part| closed(&part.name))
                .collect(),
            lengths: names(&[Kind::Length], Part::Length),
            equations: names(&[Kind::Unknown], Part::Equation),
            unknowns: names(&[Kind::Unknown], Part::Unknown),
            structure,
            listing,
        }
    }

    /// Returns the listing with the order of elimination that suits these hardpoints.
    pub(super) fn ordered_at(&self, hardpoints: &[Vector3<f64>]) -> Self {
        let mut ordered = self.clone();
        ordered.listing = ordered.listing.ordered_at(hardpoints);
        ordered
    }

    /// Returns the numbers of points, drives, measures and parts.
    pub(super) fn counts(&self) -> Counts {
        Counts {
            points: self.points.len(),
            drives: self.drives.len(),
            measures: self.measures.len(),
            parts: self.parts.len(),
        }
    }

    /// Returns the names of a kind of parts, for example `SUSP_POINT`.
    pub(super) fn names(&self, kind: kind::Kind) -> Result<&[CString], Status> {
        match kind {
            0 => Ok(&self.points),
            1 => Ok(&self.drives),
            2 => Ok(&self.measures),
            3 => Ok(&self.wheels),
            4 => Ok(&self.parts),
            _ => Err(Status::Argument),
        }
    }

    /// Returns the number of the part with a name.
    pub(super) fn find(&self, kind: kind::Kind, name: &CStr) -> Result<usize, Status> {
        let mut names = self.names(kind)?.iter();
        let place = names.position(|other| other.as_c_str() == name);
        place.ok_or(Status::Absent)
    }

    /// Writes the positions that the listing states, NaN for the others.
    pub(super) fn write_design(&self, points: &mut [MaybeUninit<f64>]) {
        points.fill(MaybeUninit::new(f64::NAN));
        let (points, _) = points.as_chunks_mut();
        for (place, at) in self.listing.stated() {
            if let Some(point) = points.get_mut(place) {
                *point = <[f64; 3]>::from(at).map(MaybeUninit::new);
            }
        }
    }
}

/// The numbers of parts of a listing.
#[derive(Clone, Copy, Debug)]
pub(super) struct Counts {
    pub(super) points: usize,
    pub(super) drives: usize,
    pub(super) measures: usize,
    pub(super) parts: usize,
}

impl Naming for Parsed {
    fn name(&self, part: Part) -> Text {
        let table = match part {
            Part::Equation(_) => &self.equations,
            Part::Unknown(_) => &self.unknowns,
            Part::Point(_) => &self.points,
            Part::Drive(_) => &self.drives,
            Part::Measure(_) => &self.measures,
            Part::Length(_) => &self.lengths,
        };
        let name = table.get(part.index());
        name.map_or(Text::NONE, |name| name.as_c_str().into())
    }
}

/// Copies a text into memory, truncated to its size and terminated by a zero.
pub(super) fn copy(text: &str, memory: &mut [MaybeUninit<u8>]) {
    let Some(room) = memory.len().checked_sub(1) else {
        return;
    };
    let mut cuts = (0..=room.min(text.len())).rev();
    let kept = cuts.find_map(|end| text.get(..end)).unwrap_or_default();
    for (place, byte) in memory.iter_mut().zip(kept.bytes().chain([0])) {
        place.write(byte);
    }
}

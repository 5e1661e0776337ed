//! A check of whether a plan fits into the tables of a size.

use super::Plan;
use crate::model::counts_of_constants;
use crate::size::{Few, Lengths, Points, Room, Size};
use crate::table::Table;

/// The first of a listing's counts that exceeds a size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Exceeded {
    pub(crate) count: usize,
    pub(crate) most: usize,
    pub(crate) what: &'static str,
}

impl Plan {
    /// `None` if models of `N` unknowns have room for all parts of the listing.
    pub(crate) fn exceeded<const N: usize>(&self) -> Option<Exceeded>
    where
        Room<N>: Size,
    {
        let chassis = <<Room<N> as Size>::Chassis<u16> as Table<u16>>::ROOM;
        let few = <Few<u16, N> as Table<u16>>::ROOM;
        let points = <Points<u16, N> as Table<u16>>::ROOM;
        let lengths = <Lengths<u16, N> as Table<u16>>::ROOM;
        // Two places have another use.
        let numbers = <<Room<N> as Size>::Numbers<u16> as Table<u16>>::ROOM - 2;
        let counts = [
            (self.unknowns.into(), N, "unknowns"),
            (self.chassis.into(), chassis, "chassis points"),
            (self.points(), points, "points"),
            (self.drives.len(), few, "drives"),
            (self.measures.len(), few, "measures"),
        ];
        let last = [
            (self.lengths.len(), lengths, "lengths"),
            (
                self.elimination.numbers(),
                numbers,
                "numbers in the factored Jacobian",
            ),
        ];
        let counts = counts.into_iter().chain(counts_of_constants::<N>(self));
        let mut counts = counts.chain(last);
        let exceeded = counts.find(|(count, most, _)| count > most);
        exceeded.map(|(count, most, what)| Exceeded { count, most, what })
    }
}

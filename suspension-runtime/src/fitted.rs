//! A listing together with the capacity for its model.

use suspension_core::listing::{DriveKind, Kind, MeasureKind, Part, Parts, WheelPlaces};

use crate::listing::Listing;
use crate::plan::Plan;
use crate::size::{LARGEST, Room, Size};

/// A listing that fits into models of `N` unknowns: the family of its models over any number type.
#[derive(Clone, Copy, Debug)]
pub struct Fitted<'l, const N: usize>(&'l Listing);

impl<'l, const N: usize> Fitted<'l, N>
where
    Room<N>: Size,
{
    /// `None` if the listing is too large.
    pub(crate) fn new(listing: &'l Listing) -> Option<Self> {
        let fits = listing.plan().exceeded::<N>().is_none();
        fits.then_some(Self(listing))
    }
}

impl<'l, const N: usize> Fitted<'l, N> {
    /// The listing.
    pub fn listing(&self) -> &'l Listing {
        self.0
    }

    #[inline(always)]
    pub(crate) fn plan(&self) -> &'l Plan {
        self.0.plan()
    }
}

impl<const N: usize> Parts for Fitted<'_, N> {
    fn name(&self, part: Part) -> &str {
        self.0.name(part)
    }

    #[inline(always)]
    fn count(&self, kind: Kind) -> usize {
        self.0.count(kind)
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        self.0.drive_kind(drive)
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        self.0.measure_kind(measure)
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.0.wheel(wheel)
    }
}

/// Work on the models of a listing of any size.
pub trait Work {
    /// The result of the work.
    type Answer;

    /// Does the work with the smallest models that have room for the listing.
    fn on<const N: usize>(self, listing: Fitted<'_, N>) -> Self::Answer
    where
        Room<N>: Size;
}

impl Listing {
    /// The listing as one that fits into models of `N` unknowns; `None` if it is too large.
    pub fn fitted<const N: usize>(&self) -> Option<Fitted<'_, N>>
    where
        Room<N>: Size,
    {
        Fitted::new(self)
    }

    /// Does work with the smallest models that have room for the listing.
    pub fn in_its_size<W: Work>(&self, work: W) -> W::Answer {
        if let Some(listing) = self.fitted::<15>() {
            work.on(listing)
        } else if let Some(listing) = self.fitted::<30>() {
            work.on(listing)
        } else if let Some(listing) = self.fitted::<60>() {
            work.on(listing)
        } else {
            // Larger listings are refused when they are read.
            work.on(Fitted::<LARGEST>(self))
        }
    }
}

//! Listings from text, called as C does.
#![allow(dead_code)]

use std::ffi::CStr;
use std::mem::MaybeUninit;

use suspension_c::listing::{self, Corner, Listing};
use suspension_c::of::f64::{Failure, Report};
use suspension_c::{Create, Destroy, In, InOut, Out, Status};

/// The values of `kind`.
pub(crate) const POINT: i32 = 0;
pub(crate) const DRIVE: i32 = 1;
pub(crate) const MEASURE: i32 = 2;
pub(crate) const WHEEL: i32 = 3;
pub(crate) const PART: i32 = 4;

/// Returns a pointer to numbers that are read.
pub(crate) fn from<T>(numbers: &[T]) -> In<'_, T> {
    // SAFETY: tests state the length of the slice, or less.
    unsafe { In::from_raw(numbers.as_ptr()) }
}

/// Returns a pointer to numbers that are written.
pub(crate) fn to<T>(numbers: &mut [T]) -> Out<'_, T> {
    // SAFETY: as above.
    unsafe { Out::from_raw(numbers.as_mut_ptr()) }
}

/// Calls a function and returns the object that it writes.
pub(crate) fn made<T>(call: impl FnOnce(Out<'_, T>) -> Status) -> Result<T, Status> {
    let mut memory = MaybeUninit::uninit();
    match call((&mut memory).into()) {
        // SAFETY: the status `Ok` means that the object is written.
        Status::Ok => Ok(unsafe { memory.assume_init() }),
        status => Err(status),
    }
}

/// A listing, freed when it is dropped.
pub(crate) struct Read(pub(crate) *mut Listing);

impl Read {
    /// Parses a listing; the error has all mistakes in words.
    pub(crate) fn new(text: &str) -> Result<Self, String> {
        let (mut message, mut needed) = ([0_u8; 4096], MaybeUninit::new(0));
        let read = made(|listing: Create<'_, Listing>| {
            let (place, size) = (to(&mut message), 4096);
            let needed = (&mut needed).into();
            listing::listing_parse(
                from(text.as_bytes()),
                text.len(),
                listing,
                place,
                size,
                needed,
            )
        });
        read.map(Self).map_err(|status| {
            assert_eq!(status, Status::Listing);
            let message = CStr::from_bytes_until_nul(&message).expect("closed");
            // SAFETY: the call writes the number in any case.
            assert_eq!(unsafe { needed.assume_init() }, message.count_bytes() + 1);
            message.to_str().expect("UTF-8").to_owned()
        })
    }

    pub(crate) fn get(&self) -> In<'_, Listing> {
        // SAFETY: it lives until `self` is dropped.
        unsafe { In::from_raw(self.0) }
    }

    pub(crate) fn count(&self, kind: i32) -> usize {
        made(|count| listing::listing_count(self.get(), kind, count)).expect("a kind")
    }

    pub(crate) fn find(&self, kind: i32, name: &CStr) -> Result<usize, Status> {
        made(|index| listing::listing_find(self.get(), kind, from(name.to_bytes_with_nul()), index))
    }

    /// Returns the positions that the listing states.
    pub(crate) fn design(&self) -> Vec<f64> {
        let count = 3 * self.count(POINT);
        let mut points = vec![0.0; count];
        let status = listing::listing_design(self.get(), to(&mut points), count);
        assert_eq!(status, Status::Ok);
        points
    }

    /// Makes a suspension; the error is the failure with its points.
    pub(crate) fn place(&self, points: &[f64]) -> Result<Moving, Failure> {
        let mut failure = MaybeUninit::uninit();
        let corner = made(|corner: Create<'_, Corner>| {
            let failure = (&mut failure).into();
            listing::corner_new(self.get(), from(points), points.len(), corner, failure)
        });
        // SAFETY: a status other than `Ok` means that the failure is written.
        corner
            .map(Moving)
            .map_err(|_| unsafe { failure.assume_init() })
    }
}

impl Drop for Read {
    fn drop(&mut self) {
        // SAFETY: nobody uses it any more.
        let status = listing::listing_destroy(unsafe { Destroy::from_raw(self.0) });
        assert_eq!(status, Status::Ok);
    }
}

/// A suspension, freed when it is dropped.
pub(crate) struct Moving(pub(crate) *mut Corner);

impl Moving {
    pub(crate) fn get(&self) -> In<'_, Corner> {
        // SAFETY: it lives until `self` is dropped.
        unsafe { In::from_raw(self.0) }
    }

    pub(crate) fn get_mut(&mut self) -> InOut<'_, Corner> {
        // SAFETY: as above, and nobody else has access to it meanwhile.
        unsafe { InOut::from_raw(self.0) }
    }

    pub(crate) fn copied(&self) -> Self {
        Self(made(|copy| listing::corner_copy(self.get(), copy)).expect("a corner"))
    }

    pub(crate) fn state(&self) -> Vec<f64> {
        let count = made(|count| listing::corner_state_count(self.get(), count));
        let count = count.expect("a corner");
        let mut state = vec![0.0; count];
        let status = listing::corner_read_state(self.get(), to(&mut state), count);
        assert_eq!(status, Status::Ok);
        state
    }

    pub(crate) fn set_state(&mut self, state: &[f64]) -> Status {
        listing::corner_set_state(self.get_mut(), from(state), state.len())
    }

    pub(crate) fn points(&self) -> [f64; 9 * 20] {
        let mut points = [0.0; 9 * 20];
        let status = listing::corner_read_points(self.get(), to(&mut points), 9 * 20);
        assert_eq!(status, Status::Ok);
        points
    }

    pub(crate) fn time(&self) -> f64 {
        made(|time| listing::corner_time(self.get(), time)).expect("a corner")
    }

    /// Returns the values of the two drives.
    pub(crate) fn drives(&self) -> [f64; 2] {
        let mut drives = [0.0; 2];
        let status = listing::corner_drives(self.get(), to(&mut drives), 2);
        assert_eq!(status, Status::Ok);
        drives
    }

    /// Steps to these values, at rest there.
    pub(crate) fn step(&mut self, values: [f64; 2], stay: bool) -> Result<Report, Failure> {
        let drives = [values, [0.0; 2], [0.0; 2]];
        let drives = from(drives.as_flattened());
        let (mut report, mut failure) = (MaybeUninit::uninit(), MaybeUninit::uninit());
        let (report_out, wrong) = ((&mut report).into(), (&mut failure).into());
        let corner = self.get_mut();
        let status = if stay {
            listing::corner_step(corner, drives, 6, 0.5, report_out, wrong)
        } else {
            listing::corner_advance(corner, drives, 6, 0.5, report_out, wrong)
        };
        match status {
            // SAFETY: the status `Ok` means that the report is written.
            Status::Ok => Ok(unsafe { report.assume_init() }),
            // SAFETY: any other status means that the failure is written.
            _ => Err(unsafe { failure.assume_init() }),
        }
    }
}

impl Drop for Moving {
    fn drop(&mut self) {
        // SAFETY: nobody uses it any more.
        let status = listing::corner_destroy(unsafe { Destroy::from_raw(self.0) });
        assert_eq!(status, Status::Ok);
    }
}

/// The double wishbone with a pushrod: 20 points, two drives, two measures.
const PUSHROD: &str =
    include_str!("../../../suspension-core/src/linkages/double_wishbone_pushrod.linkage");

pub(crate) fn pushrod() -> Read {
    Read::new(PUSHROD).expect("a listing")
}

/// The double wishbone at the points that its listing states.
pub(crate) fn placed() -> Moving {
    let listing = pushrod();
    listing.place(&listing.design()).expect("a geometry")
}

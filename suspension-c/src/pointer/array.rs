//! Arrays of the caller.
#![allow(unsafe_code, reason = "how many they are is C's promise")]

use core::marker::PhantomData;

use super::{In, check};
use crate::status::Status;

/// Numbers of the caller's: a pointer to the first of `count`, which nobody writes as long as this
/// is used.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Numbers<T> {
    numbers: *const T,
    count: usize,
}

impl<T> Numbers<T> {
    pub(crate) fn get(&self) -> Result<&[T], Status> {
        In(self.numbers, PhantomData).many(self.count)
    }
}

impl<T> From<&'static [T]> for Numbers<T> {
    fn from(numbers: &'static [T]) -> Self {
        Self {
            numbers: numbers.as_ptr(),
            count: numbers.len(),
        }
    }
}

/// Whether so many fit into the address space.
fn check_count<T>(count: usize) -> Result<(), Status> {
    if count > isize::MAX as usize / size_of::<T>() {
        Err(Status::Size)
    } else {
        Ok(())
    }
}

impl<'a, T> In<'a, T> {
    /// A pointer to the first of `count`.
    pub(crate) fn many(self, count: usize) -> Result<&'a [T], Status> {
        check(self.0)?;
        check_count::<T>(count)?;
        // SAFETY: neither null nor misaligned, so that by what the header asks for it points to `count`
        // of them which are only read for 'a; they fit into the address space.
        Ok(unsafe { core::slice::from_raw_parts(self.0, count) })
    }
}

#[cfg(feature = "listings")]
mod of_listings {
    use core::ffi::CStr;
    use core::mem::MaybeUninit;

    use super::super::{In, InOut, Out, check};
    use super::check_count;
    use crate::status::Status;

    impl<'a> In<'a, u8> {
        /// A text that a zero closes.
        pub(crate) fn text(self) -> Result<&'a CStr, Status> {
            check(self.0)?;
            // SAFETY: not null, so that by what the header asks for a zero closes it; it is only read
            // for 'a.
            Ok(unsafe { CStr::from_ptr(self.0.cast()) })
        }
    }

    impl<'a, T> InOut<'a, T> {
        /// A pointer to the first of `count`.
        pub(crate) fn many(self, count: usize) -> Result<&'a mut [T], Status> {
            check(self.0)?;
            check_count::<T>(count)?;
            // SAFETY: neither null nor misaligned, so that by what the header asks for it points to `count`
            // of them which are this call's alone for 'a; they fit into the address space.
            Ok(unsafe { core::slice::from_raw_parts_mut(self.0, count) })
        }
    }

    impl<'a, T> Out<'a, T> {
        /// Memory for `count`.
        pub(crate) fn many(self, count: usize) -> Result<&'a mut [MaybeUninit<T>], Status> {
            check(self.0)?;
            check_count::<T>(count)?;
            // SAFETY: neither null nor misaligned, so that by what the header asks for it points to memory
            // for `count` of them which is this call's alone for 'a; they fit into the address space.
            Ok(unsafe { core::slice::from_raw_parts_mut(self.0.cast(), count) })
        }

        /// `None` where C passes NULL.
        pub(crate) fn optional_many(
            self,
            count: usize,
        ) -> Result<Option<&'a mut [MaybeUninit<T>]>, Status> {
            if self.0.is_null() {
                Ok(None)
            } else {
                self.many(count).map(Some)
            }
        }
    }
}

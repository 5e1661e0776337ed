//! Arrays of the caller.
#![allow(unsafe_code, reason = "how many they are is C's promise")]

use core::marker::PhantomData;

use super::{In, check};
use crate::status::Status;

/// An array of the caller: a pointer to the first of `count` numbers, which nobody writes as long as this
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

/// Checks that `count` numbers fit into the address space.
fn check_count<T>(count: usize) -> Result<(), Status> {
    if count > isize::MAX as usize / size_of::<T>() {
        Err(Status::Size)
    } else {
        Ok(())
    }
}

impl<'a, T> In<'a, T> {
    /// Returns the array of `count` numbers at the pointer.
    pub(crate) fn many(self, count: usize) -> Result<&'a [T], Status> {
        check(self.0)?;
        check_count::<T>(count)?;
        // SAFETY: neither null nor misaligned, so by the contract of the header it points to `count`
        // numbers that are only read for 'a; they fit into the address space.
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
        /// Returns the text at the pointer, which is terminated by a zero.
        pub(crate) fn text(self) -> Result<&'a CStr, Status> {
            check(self.0)?;
            // SAFETY: not null, so by the contract of the header it is terminated by a zero and only read
            // for 'a.
            Ok(unsafe { CStr::from_ptr(self.0.cast()) })
        }
    }

    impl<'a, T> InOut<'a, T> {
        /// Returns the array of `count` numbers at the pointer.
        pub(crate) fn many(self, count: usize) -> Result<&'a mut [T], Status> {
            check(self.0)?;
            check_count::<T>(count)?;
            // SAFETY: neither null nor misaligned, so by the contract of the header it points to `count`
            // numbers to which only this call has access for 'a; they fit into the address space.
            Ok(unsafe { core::slice::from_raw_parts_mut(self.0, count) })
        }
    }

    impl<'a, T> Out<'a, T> {
        /// Returns the memory for `count` numbers at the pointer.
        pub(crate) fn many(self, count: usize) -> Result<&'a mut [MaybeUninit<T>], Status> {
            check(self.0)?;
            check_count::<T>(count)?;
            // SAFETY: neither null nor misaligned, so by the contract of the header it points to memory for
            // `count` numbers to which only this call has access for 'a; they fit into the address space.
            Ok(unsafe { core::slice::from_raw_parts_mut(self.0.cast(), count) })
        }

        /// Returns `None` for NULL.
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

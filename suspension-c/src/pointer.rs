//! Pointers from C become references only here and in the submodules.
#![allow(unsafe_code, reason = "what a pointer points to is C's promise")]

use core::marker::PhantomData;
use core::mem::MaybeUninit;

use crate::status::Status;

mod array;
#[cfg(feature = "listings")]
mod heap;

pub use array::Numbers;
#[cfg(feature = "listings")]
pub use heap::{Create, Destroy};

/// `const T *` of a call: null, misaligned, or to a `T` that nobody writes during the call.
#[derive(Debug)]
#[repr(transparent)]
pub struct In<'a, T>(*const T, PhantomData<&'a T>);

/// `T *` of a call: null, misaligned, or to an initialised `T` to which only the call has access.
#[derive(Debug)]
#[repr(transparent)]
pub struct InOut<'a, T>(*mut T, PhantomData<&'a mut T>);

/// `T *` of a call: null, misaligned, or to memory for a `T` to which only the call has access.
#[derive(Debug)]
#[repr(transparent)]
pub struct Out<'a, T>(*mut T, PhantomData<&'a mut MaybeUninit<T>>);

/// An object that C stores but does not interpret. It begins with a tag of its kind, by which the functions
/// recognise memory that never held one.
#[repr(C)]
pub struct Object<V, const TAG: u32> {
    tag: u32,
    value: MaybeUninit<V>,
}

/// Returns the tag of a kind of objects (FNV-1a of its name). It is never zero, the content of static
/// memory.
pub const fn tag(name: &str) -> u32 {
    let mut rest = name.as_bytes();
    let mut hash: u32 = 0x811c_9dc5;
    while let Some((byte, others)) = rest.split_first() {
        hash = (hash ^ *byte as u32).wrapping_mul(0x0100_0193);
        rest = others;
    }
    hash | 1
}

fn check<T>(pointer: *const T) -> Result<(), Status> {
    if pointer.is_null() {
        Err(Status::Null)
    } else if pointer.is_aligned() {
        Ok(())
    } else {
        Err(Status::Misaligned)
    }
}

fn check_object<V, const TAG: u32>(pointer: *const Object<V, TAG>) -> Result<(), Status> {
    check(pointer)?;
    // SAFETY: neither null nor misaligned. No reference is made to an object that may be of another kind.
    let tag = unsafe { (&raw const (*pointer).tag).read() };
    if tag == TAG {
        Ok(())
    } else {
        Err(Status::Object)
    }
}

impl<T> Clone for In<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for In<'_, T> {}

impl<'a, T> In<'a, T> {
    /// Takes a pointer from C.
    ///
    /// # Safety
    ///
    /// As the type says, for `'a`; any pattern of bits is a `T`.
    pub unsafe fn from_raw(pointer: *const T) -> Self {
        Self(pointer, PhantomData)
    }

    #[doc(hidden)]
    #[inline(always)]
    pub fn get(self) -> Result<&'a T, Status> {
        check(self.0)?;
        // SAFETY: neither null nor misaligned, so by the contracts of `from_raw` and of the header it
        // points to a T that is only read for 'a.
        Ok(unsafe { &*self.0 })
    }
}

impl<'a, V, const TAG: u32> In<'a, Object<V, TAG>> {
    #[doc(hidden)]
    #[inline(always)]
    pub fn object(self) -> Result<&'a V, Status> {
        check_object(self.0)?;
        // SAFETY: neither null nor misaligned, and the tag is only written together with the value. The
        // header allows C to copy the bytes, not to change them, and nobody writes them for 'a.
        Ok(unsafe { (*self.0).value.assume_init_ref() })
    }
}

impl<'a, T> From<&'a T> for In<'a, T> {
    fn from(reference: &'a T) -> Self {
        Self(reference, PhantomData)
    }
}

impl<'a, T> InOut<'a, T> {
    /// Takes a pointer from C.
    ///
    /// # Safety
    ///
    /// As the type says, for `'a`; any pattern of bits is a `T`.
    pub unsafe fn from_raw(pointer: *mut T) -> Self {
        Self(pointer, PhantomData)
    }

    #[doc(hidden)]
    #[inline(always)]
    pub fn get(self) -> Result<&'a mut T, Status> {
        check(self.0)?;
        // SAFETY: neither null nor misaligned, so by the contracts of `from_raw` and of the header it
        // points to a T to which only this call has access for 'a.
        Ok(unsafe { &mut *self.0 })
    }
}

impl<'a, V, const TAG: u32> InOut<'a, Object<V, TAG>> {
    #[doc(hidden)]
    #[inline(always)]
    pub fn object(self) -> Result<&'a mut V, Status> {
        check_object(self.0)?;
        // SAFETY: as in `In::object`, and only this call has access to the object for 'a.
        Ok(unsafe { (*self.0).value.assume_init_mut() })
    }
}

impl<'a, T> From<&'a mut T> for InOut<'a, T> {
    fn from(reference: &'a mut T) -> Self {
        Self(reference, PhantomData)
    }
}

impl<'a, T> Out<'a, T> {
    /// Takes a pointer from C.
    ///
    /// # Safety
    ///
    /// As the type says, for `'a`.
    pub unsafe fn from_raw(pointer: *mut T) -> Self {
        Self(pointer, PhantomData)
    }

    #[doc(hidden)]
    #[inline(always)]
    pub fn get(self) -> Result<&'a mut MaybeUninit<T>, Status> {
        check(self.0)?;
        // SAFETY: neither null nor misaligned, so by the contracts of `from_raw` and of the header it
        // points to memory for a T to which only this call has access for 'a; MaybeUninit allows any
        // content.
        Ok(unsafe { &mut *self.0.cast() })
    }

    /// Returns `None` for NULL.
    #[doc(hidden)]
    #[inline(always)]
    pub fn optional(self) -> Result<Option<&'a mut MaybeUninit<T>>, Status> {
        if self.0.is_null() {
            Ok(None)
        } else {
            self.get().map(Some)
        }
    }
}

impl<'a, V, const TAG: u32> Out<'a, Object<V, TAG>> {
    /// Returns the memory for an object. C states the memory's size: another size than that of the
    /// library's object means that C includes the header of another version.
    #[doc(hidden)]
    #[inline(always)]
    pub fn place(self, size: usize) -> Result<Place<'a, V, TAG>, Status> {
        if size == size_of::<Object<V, TAG>>() {
            self.get().map(Place)
        } else {
            Err(Status::Size)
        }
    }
}

/// Memory for an object.
#[doc(hidden)]
pub struct Place<'a, V, const TAG: u32>(&'a mut MaybeUninit<Object<V, TAG>>);

impl<V, const TAG: u32> Place<'_, V, TAG> {
    #[doc(hidden)]
    #[inline(always)]
    pub fn put(self, value: V) {
        self.0.write(Object {
            tag: TAG,
            value: MaybeUninit::new(value),
        });
    }
}

impl<'a, T> From<&'a mut MaybeUninit<T>> for Out<'a, T> {
    fn from(reference: &'a mut MaybeUninit<T>) -> Self {
        Self(reference.as_mut_ptr(), PhantomData)
    }
}

impl<'a, T> From<Option<&'a mut MaybeUninit<T>>> for Out<'a, T> {
    fn from(reference: Option<&'a mut MaybeUninit<T>>) -> Self {
        match reference {
            Some(reference) => reference.into(),
            None => Self(core::ptr::null_mut(), PhantomData),
        }
    }
}

//! Objects that the library keeps on the heap until C frees them.
#![allow(unsafe_code, reason = "how long they live is C's promise")]

use core::marker::PhantomData;
use core::mem::MaybeUninit;
use std::boxed::Box;

use super::{Object, Out, check_object};
use crate::status::Status;

/// `T **` of a call, which receives the pointer to a new object.
pub type Create<'a, T> = Out<'a, *mut T>;

/// `T *` of a call: null, misaligned, to no object of this kind, or to one that the library made and nobody
/// uses any more.
#[derive(Debug)]
#[repr(transparent)]
pub struct Destroy<'a, T>(*mut T, PhantomData<&'a mut T>);

impl<V, const TAG: u32> Object<V, TAG> {
    /// Makes an object that lives until [`Destroy::end`].
    pub(crate) fn on_heap(value: V) -> *mut Self {
        Box::into_raw(Box::new(Self {
            tag: TAG,
            value: MaybeUninit::new(value),
        }))
    }
}

impl<T> Destroy<'_, T> {
    /// Takes a pointer from C.
    ///
    /// # Safety
    ///
    /// As the type says.
    pub unsafe fn from_raw(pointer: *mut T) -> Self {
        Self(pointer, PhantomData)
    }
}

impl<V, const TAG: u32> Destroy<'_, Object<V, TAG>> {
    /// Drops the object; NULL has no effect.
    pub(crate) fn end(self) -> Result<(), Status> {
        if self.0.is_null() {
            return Ok(());
        }
        check_object(self.0)?;
        // SAFETY: only `on_heap` makes objects of this kind, and by the contract of the header each is
        // freed once, when nobody uses it any more.
        let mut object = unsafe { Box::from_raw(self.0) };
        // SAFETY: the tag is written together with the value, which is not used after this.
        unsafe { object.value.assume_init_drop() };
        Ok(())
    }
}

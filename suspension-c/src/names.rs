//! Names for C: terminated by a zero.

use core::ffi::{CStr, c_char};

use suspension_core::listing::Part;

/// `const char *`, or NULL for no text. The text lives as long as the program or, where a header says so,
/// as long as an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub struct Text(*const c_char);

impl Text {
    /// No text.
    pub const NONE: Self = Self(core::ptr::null());

    /// Returns the pointer for C.
    pub fn as_ptr(self) -> *const c_char {
        self.0
    }
}

impl From<&CStr> for Text {
    fn from(text: &CStr) -> Self {
        Self(text.as_ptr())
    }
}

/// Types that know the names of a listing's parts.
pub trait Naming {
    /// Returns the name of a part; NULL if it has none.
    fn name(&self, part: Part) -> Text;
}

/// Without a listing parts have no names.
impl Naming for () {
    fn name(&self, _: Part) -> Text {
        Text::NONE
    }
}

/// Consecutive names, each terminated by a zero.
#[derive(Clone, Copy, Debug)]
pub struct Table(pub &'static [u8]);

impl Table {
    /// Returns the name with this number.
    pub fn at(self, index: usize) -> Text {
        let name = self.0.split_inclusive(|byte| *byte == 0).nth(index);
        match name.map(CStr::from_bytes_with_nul) {
            Some(Ok(name)) => name.into(),
            _ => Text::NONE,
        }
    }
}

/// Returns the number of bytes that [`terminated`] needs.
pub const fn terminated_length(mut names: &[&str]) -> usize {
    let mut length = 0;
    while let Some((name, others)) = names.split_first() {
        length += name.len() + 1;
        names = others;
    }
    length
}

/// Returns consecutive names, each terminated by a zero.
pub const fn terminated<const LENGTH: usize>(mut names: &[&str]) -> [u8; LENGTH] {
    let mut bytes = [0; LENGTH];
    let mut rest: &mut [u8] = &mut bytes;
    while let Some((name, others)) = names.split_first() {
        let Some((place, after)) = rest.split_at_mut_checked(name.len() + 1) else {
            break;
        };
        let (text, _) = place.split_at_mut(name.len());
        text.copy_from_slice(name.as_bytes());
        rest = after;
        names = others;
    }
    bytes
}

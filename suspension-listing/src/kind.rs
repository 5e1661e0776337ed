//! The kinds of parts that names of a listing stand for.

use std::fmt;

/// The kind of part that a name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind(pub(crate) &'static str);

impl Kind {
    pub const CHASSIS_POINT: Self = Self("chassis point");
    pub const FREE_POINT: Self = Self("free point");
    pub const MARKER: Self = Self("marker");
    pub const LINK: Self = Self("link");
    pub const BODY: Self = Self("body");
    pub const HINGE: Self = Self("hinge");
    pub const SLIDE: Self = Self("slide");
    pub const DRIVE: Self = Self("drive");

    pub(crate) fn with_article(self) -> String {
        let article = if self.0.starts_with('a') { "an" } else { "a" };
        format!("{article} {self}")
    }

    pub(crate) fn plural(self) -> String {
        match self.0.strip_suffix('y') {
            Some(stem) => format!("{stem}ies"),
            None => format!("{self}s"),
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

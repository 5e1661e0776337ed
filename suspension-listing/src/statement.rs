//! The statements of a listing, one file each: how it is written, read, checked and lowered to forms.
//!
//! Only the register below distinguishes the statements; all other code uses a
//! statement through [`Statement`](crate::listing::Statement).

mod angle;
mod body;
mod couple;
mod drive;
mod hinge;
mod include;
mod link;
pub(crate) mod marker;
mod measure;
pub(crate) mod mirror;
pub(crate) mod operands;
mod plane;
pub(crate) mod points;
mod quantity;
mod role;
mod slide;
mod sum;
pub(crate) mod word;

use word::Word;

/// The statements by their first words.
pub(crate) const STATEMENTS: &[Word] = &[
    points::FIXED,
    points::FREE,
    link::LINK,
    body::BODY,
    hinge::HINGE,
    slide::SLIDE,
    plane::PLANE,
    couple::COUPLE,
    angle::ANGLE,
    drive::DRIVE,
    measure::MEASURE,
    marker::POINT,
    role::WHEEL,
    role::KINGPIN,
    mirror::MIRROR,
    include::INCLUDE,
];

//! The statements of a listing, one file each: how it is written, read, checked and lowered to forms.
//!
//! The register below is the only place that tells the statements apart; everything else asks a
//! statement what [`Statement`](crate::listing::Statement) has it answer.

mod angle;
mod body;
mod couple;
mod drive;
mod hinge;
mod include;
mod link;
mod marker;
mod measure;
pub(crate) mod mirror;
pub(crate) mod operands;
mod plane;
mod points;
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

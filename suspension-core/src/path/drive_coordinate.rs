//! The coordinate by which a drive enters the equations, and the way back to the drive's value.

use crate::arithmetic::scalar::Real;
use crate::linkage::{Linkage, Values};
use crate::listing::DriveKind;
use crate::model::constraint::{angle_to_coordinate, turn_to_coordinate};
use crate::model::parts;
use crate::signal::Signal;

/// The coordinate `h` of a drive as a function of its value `theta`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum DriveCoordinate<T> {
    /// The value itself.
    Value,
    /// `L cos(theta)`, with `theta` from 0 to pi.
    Cosine { length: T },
    /// `L sin(theta / 4)`, with `theta` less than a whole turn in either direction.
    QuarterSine { length: T },
}

impl<T: Real> DriveCoordinate<T> {
    pub(crate) fn new<L: Linkage<N, Scalar = T>, const N: usize>(
        linkage: &L,
        drive: usize,
    ) -> Self {
        let none = L::Drives::default();
        let at_zero = linkage.coordinates(&Signal {
            value: none,
            rate: none.with(drive, T::one()),
            second_rate: none,
        });
        let entry = |drives: &L::Drives| drives.values().nth(drive).unwrap_or_default();
        match linkage.drive_kind(drive) {
            DriveKind::Coordinate => Self::Value,
            DriveKind::Angle => Self::Cosine {
                length: entry(&at_zero.value),
            },
            DriveKind::Turn => Self::QuarterSine {
                length: entry(&at_zero.rate) * T::constant(4.0),
            },
        }
    }

    /// The largest magnitude that the coordinate of an angle can have; `None` if there is no limit.
    pub(crate) fn largest(self) -> Option<T> {
        match self {
            Self::Value => None,
            Self::Cosine { length } | Self::QuarterSine { length } => Some(length),
        }
    }

    /// Whether value and coordinate increase together.
    pub(crate) fn is_increasing(self) -> bool {
        !matches!(self, Self::Cosine { .. })
    }

    /// The value at a coordinate.
    pub(crate) fn value_at(self, coordinate: T) -> T {
        match self {
            Self::Value => coordinate,
            Self::Cosine { length } => parts::angle(coordinate, length),
            Self::QuarterSine { length } => {
                T::arc_tangent(coordinate, parts::other_leg(coordinate, length)) * T::constant(4.0)
            }
        }
    }

    /// The coordinate at a value.
    pub(crate) fn coordinate(self, value: T) -> T {
        match self {
            Self::Value => value,
            Self::Cosine { length } => angle_to_coordinate(length, Signal::still(value)).value,
            Self::QuarterSine { length } => turn_to_coordinate(length, Signal::still(value)).value,
        }
    }

    /// The value and its first two rates, from those of the coordinate. At the ends of an angle's range the rates are
    /// infinite or NaN.
    pub(crate) fn value(self, coordinate: &Signal<T>) -> Signal<T> {
        let Signal {
            value: h,
            rate,
            second_rate,
        } = *coordinate;
        let value = self.value_at(h);
        match self {
            Self::Value => *coordinate,
            Self::Cosine { length } => {
                let across = parts::other_leg(h, length);
                let angle_rate = -rate / across;
                Signal {
                    value,
                    rate: angle_rate,
                    second_rate: -(second_rate + h * angle_rate * angle_rate) / across,
                }
            }
            Self::QuarterSine { length } => {
                let (along, four) = (parts::other_leg(h, length), T::constant(4.0));
                let quarter_rate = rate / along;
                Signal {
                    value,
                    rate: quarter_rate * four,
                    second_rate: (second_rate + h * quarter_rate * quarter_rate) / along * four,
                }
            }
        }
    }
}

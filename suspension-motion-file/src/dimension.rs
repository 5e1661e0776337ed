//! Dimensions of numbers, and their units.

use suspension_core::listing::{DriveKind, MeasureKind};

use crate::{Angle, Length, Unit};

/// The dimension of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A time.
    Time,
    /// A length or a coordinate.
    Length,
    /// The rate of a length.
    Velocity,
    /// The second rate of a length.
    Acceleration,
    /// An angle.
    Angle,
    /// The rate of an angle.
    AngularVelocity,
    /// The second rate of an angle.
    AngularAcceleration,
    /// A length per angle.
    LengthPerAngle,
    /// An angle per angle.
    AnglePerAngle,
    /// A force.
    Force,
    /// A moment.
    Moment,
    /// A force per length.
    Stiffness,
    /// A moment per angle.
    AngularStiffness,
    /// A mass.
    Mass,
    /// A percentage.
    Percent,
    /// A whole number.
    Count,
}

impl Dimension {
    /// Returns the symbol of the unit in files.
    pub fn symbol(self, unit: Unit) -> String {
        let (length, angle) = (unit.symbol(), unit.angle.symbol());
        match self {
            Self::Time => "s".to_owned(),
            Self::Length => length.to_owned(),
            Self::Velocity => format!("{length}/s"),
            Self::Acceleration => format!("{length}/s^2"),
            Self::Angle => angle.to_owned(),
            Self::AngularVelocity => format!("{angle}/s"),
            Self::AngularAcceleration => format!("{angle}/s^2"),
            Self::LengthPerAngle => format!("{length}/{angle}"),
            Self::AnglePerAngle => format!("{angle}/{angle}"),
            Self::Force => "N".to_owned(),
            Self::Moment => "Nm".to_owned(),
            Self::Mass => "kg".to_owned(),
            Self::Stiffness => format!("N/{length}"),
            Self::AngularStiffness => format!("Nm/{angle}"),
            Self::Percent => "percent".to_owned(),
            Self::Count => String::new(),
        }
    }

    /// Returns whether positions alone determine the number.
    pub fn is_of_positions(self) -> bool {
        let is_rate = matches!(
            self,
            Self::Velocity | Self::Acceleration | Self::AngularVelocity | Self::AngularAcceleration
        );
        !is_rate && !matches!(self, Self::Time | Self::Count)
    }

    /// Returns the factor and the symbol for text and plots, in which angles are in degrees.
    pub fn display_scale(self, unit: Unit) -> (f64, String) {
        let angle = Angle::Degree;
        let people = Unit { angle, ..unit };
        match self {
            Self::Percent => (1.0, "%".to_owned()),
            _ => (people.file_factor(self), self.symbol(people)),
        }
    }

    /// Returns the factor from one unit of length to another.
    pub fn conversion(self, from: Unit, to: Unit) -> f64 {
        match self.powers() {
            [1, _] => to.metre() / from.metre(),
            [-1, _] => from.metre() / to.metre(),
            _ => 1.0,
        }
    }

    /// The powers of the unit of lengths and of that of angles in its unit.
    fn powers(self) -> [i8; 2] {
        match self {
            Self::Length | Self::Velocity | Self::Acceleration => [1, 0],
            Self::Angle | Self::AngularVelocity | Self::AngularAcceleration => [0, 1],
            Self::LengthPerAngle => [1, -1],
            Self::Stiffness => [-1, 0],
            Self::AngularStiffness => [0, -1],
            Self::Time
            | Self::AnglePerAngle
            | Self::Force
            | Self::Moment
            | Self::Mass
            | Self::Percent
            | Self::Count => [0, 0],
        }
    }

    /// The decimals in text.
    pub fn decimals(self, unit: Unit) -> usize {
        match self {
            Self::Count => 0,
            Self::Force | Self::Moment | Self::AngularStiffness => 1,
            Self::Stiffness => match unit.length {
                Length::Millimetre => 3,
                Length::Metre | Length::Inch => 1,
            },
            Self::Time => 4,
            Self::Length | Self::Velocity | Self::Acceleration | Self::LengthPerAngle => {
                unit.length.decimals()
            }
            Self::Angle
            | Self::AngularVelocity
            | Self::AngularAcceleration
            | Self::AnglePerAngle
            | Self::Mass
            | Self::Percent => 3,
        }
    }
}

impl Unit {
    /// Returns the factor from the program's unit to that of the file.
    pub fn file_factor(self, of: impl Into<Dimension>) -> f64 {
        match of.into().powers() {
            [_, 1] => self.angle.radian(),
            [_, -1] => 1.0 / self.angle.radian(),
            _ => 1.0,
        }
    }
}

impl From<DriveKind> for Dimension {
    fn from(kind: DriveKind) -> Self {
        match kind {
            DriveKind::Coordinate => Self::Length,
            DriveKind::Angle | DriveKind::Turn => Self::Angle,
        }
    }
}

impl From<MeasureKind> for Dimension {
    fn from(kind: MeasureKind) -> Self {
        match kind {
            MeasureKind::Length => Self::Length,
            MeasureKind::Angle => Self::Angle,
        }
    }
}

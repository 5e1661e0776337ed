//! What can go wrong, as `Copy` values.
//!
//! They hold numbers of equations, unknowns, points and lengths, which the model turns into the
//! user's names: [`Parts::name`].

use core::fmt;

use crate::listing::{Kind, Part, Parts};

/// An error that concerns a part of a listing.
trait Failure {
    /// The message, with the name or the number of the part.
    fn write(&self, f: &mut fmt::Formatter<'_>, name: &dyn fmt::Display) -> fmt::Result;

    /// The message with the names of a listing, or with numbers.
    fn of(&self, parts: Option<&dyn Parts>, f: &mut fmt::Formatter<'_>) -> fmt::Result;
}

/// An error with the names of a listing, to be printed.
#[derive(Clone, Copy)]
pub struct WithNames<'a, E> {
    error: &'a E,
    parts: &'a dyn Parts,
}

#[allow(private_bounds, reason = "the two errors of this module")]
impl<E: Failure> fmt::Display for WithNames<'_, E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.error.of(Some(self.parts), f)
    }
}

/// A name in a message.
struct Quoted<'a>(&'a str);

impl fmt::Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", self.0)
    }
}

/// Why no configuration was found. The state that was passed in is unchanged.
///
/// On a [`Curve`](crate::path::Curve) of `N` unknowns, unknown `N` is the coordinate of the free
/// drive, and equation `N` that of the quantity that leads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SolveError<T> {
    /// A residual, or a derivative of it, is NaN or infinite: so is an input, the start or the time
    /// step, or it is too large for the number type.
    NotFinite {
        /// The equation whose residual it is.
        equation: usize,
    },
    /// A correction, velocity or acceleration is NaN or infinite: so is a rate of an input, or it
    /// is too large for the number type.
    Overflow {
        /// The unknown whose change it is.
        unknown: usize,
    },
    /// The determinant of the Jacobian has another sign than at the last good motion: a
    /// singularity lies between, and the root belongs to another assembly.
    CrossedSingularity {
        /// The unknown that moved farthest.
        unknown: usize,
    },
    /// `pivot <= threshold`: to rounding, the equations do not determine this unknown.
    Singular {
        /// The unknown whose column has no usable pivot.
        unknown: usize,
        /// The largest candidate for a pivot.
        pivot: T,
        /// What it had to exceed.
        threshold: T,
    },
    /// The point stands on the wrong side of the three that links join it to: the lengths are kept,
    /// and the part that they make is the mirror image of the model's.
    Mirrored {
        /// The point, one of [`Linkage::linked`](crate::Linkage::linked).
        point: usize,
    },
    /// `step > bound`: the correction of this unknown did not shrink as it does near a root, so
    /// the root, if any, might belong to another assembly.
    Diverging {
        /// The unknown with the largest correction.
        unknown: usize,
        /// Its size, in units of length; of a bounded step the norm of all.
        step: T,
        /// What it had to stay within.
        bound: T,
    },
    /// `change > bound`: over the step the Jacobian changes so much that singularities may lie
    /// between, an even number of them too.
    TooFar {
        /// The unknown with the largest change.
        unknown: usize,
        /// Its size, in units of length.
        change: T,
        /// What it had to stay within: the size of the step.
        bound: T,
    },
    /// `step > bound`, both in the unit of time: the series of the motion, of which this unknown has
    /// the largest last term, is not good for so long a step.
    StepTooLong {
        /// The unknown.
        unknown: usize,
        /// The length of the step.
        step: T,
        /// What it had to stay within.
        bound: T,
    },
    /// The quantity that leads the motion turns before it meets its target: beyond its extreme
    /// value there is no configuration on this branch.
    TurningPoint {
        /// The unknown that moves most there.
        unknown: usize,
        /// The target, in the quantity's unit.
        asked: T,
        /// The quantity's extreme value.
        extreme: T,
    },
    /// `residual > tolerance` after all iterations that were allowed.
    NotConverged {
        /// The equation with the largest residual.
        equation: usize,
        /// Its size, in units of length; of a bounded step the norm of all.
        residual: T,
        /// What it had to reach.
        tolerance: T,
        /// Corrections that were made.
        iterations: usize,
    },
}

impl<T> SolveError<T> {
    /// The equation, unknown or point concerned.
    pub fn part(&self) -> Part {
        match *self {
            Self::NotFinite { equation } | Self::NotConverged { equation, .. } => {
                Part::Equation(equation)
            }
            Self::Overflow { unknown }
            | Self::CrossedSingularity { unknown }
            | Self::Singular { unknown, .. }
            | Self::Diverging { unknown, .. }
            | Self::TooFar { unknown, .. }
            | Self::StepTooLong { unknown, .. }
            | Self::TurningPoint { unknown, .. } => Part::Unknown(unknown),
            Self::Mirrored { point } => Part::Point(point),
        }
    }

    /// The name of the equation, unknown or point concerned.
    pub fn culprit<'a>(&self, parts: &'a dyn Parts) -> &'a str {
        let unknowns = parts.count(Kind::Unknown);
        match self.part() {
            Part::Equation(index) if index >= unknowns => "the leading quantity",
            Part::Unknown(index) if index >= unknowns => "the free drive",
            part => parts.name(part),
        }
    }
}

impl<T: fmt::LowerExp> Failure for SolveError<T> {
    fn write(&self, f: &mut fmt::Formatter<'_>, name: &dyn fmt::Display) -> fmt::Result {
        match self {
            Self::NotFinite { .. } => {
                write!(f, "the residual of equation {name} is not a finite number")
            }
            Self::Overflow { .. } => {
                write!(f, "the change of unknown {name} is not a finite number")
            }
            Self::CrossedSingularity { .. } => write!(
                f,
                "a singularity was crossed: unknown {name} moved to another assembly"
            ),
            Self::Mirrored { .. } => write!(
                f,
                "point {name} is mirrored: it stands on the wrong side of the points that links join it to"
            ),
            Self::Singular {
                pivot, threshold, ..
            } => write!(
                f,
                "unknown {name} is not determined: pivot {pivot:.1e}, needed more than {threshold:.1e}"
            ),
            Self::Diverging { step, bound, .. } => write!(
                f,
                "no root near by: the correction of unknown {name} grew to {step:.1e}, allowed {bound:.1e}"
            ),
            Self::TooFar { change, bound, .. } => write!(
                f,
                "the step is too long to tell assemblies apart: the Jacobian changes it by {change:.1e} at unknown {name}, allowed {bound:.1e}"
            ),
            Self::StepTooLong { step, bound, .. } => write!(
                f,
                "the series of unknown {name} is good for a step of {bound:.1e}, not of {step:.1e}"
            ),
            Self::TurningPoint { asked, extreme, .. } => write!(
                f,
                "the leading quantity turns at {extreme:.15e}, on the way to {asked:.15e}"
            ),
            Self::NotConverged {
                residual,
                tolerance,
                iterations,
                ..
            } => write!(
                f,
                "equation {name} is off by {residual:.1e} after {iterations} iterations, allowed {tolerance:.1e}"
            ),
        }
    }

    fn of(&self, parts: Option<&dyn Parts>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match parts {
            Some(parts) => self.write(f, &Quoted(self.culprit(parts))),
            None => self.write(f, &self.part().index()),
        }
    }
}

impl<T: fmt::LowerExp> SolveError<T> {
    /// The error with the names of a listing, to be printed.
    pub fn named<'a>(&'a self, parts: &'a dyn Parts) -> WithNames<'a, Self> {
        WithNames { error: self, parts }
    }
}

impl<T: fmt::LowerExp> fmt::Display for SolveError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.of(None, f)
    }
}

impl<T: fmt::Debug + fmt::LowerExp> core::error::Error for SolveError<T> {}

/// Why a linkage cannot be built. Numbers are those of the listing's points and lengths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GeometryError {
    /// A coordinate of the point is NaN or infinite.
    NotFinite {
        /// The point.
        point: usize,
    },
    /// The length is zero, negative or NaN, or too large or too small to compute with.
    BadLength {
        /// The length.
        length: usize,
    },
    /// The three points that should carry the point lie in line.
    Collinear {
        /// The point carried, or the last of the three.
        point: usize,
    },
    /// The point lies in the plane of the three that links join it to, or too near to tell its sides
    /// apart: the distances are singular there. A `body` is not.
    Flat {
        /// The point.
        point: usize,
    },
    /// The ends of a line on which a point slides, or of a length that is driven, coincide, or are too far
    /// apart to compute with.
    NoLine {
        /// The end of the line.
        point: usize,
    },
    /// No rigid body has the given lengths: they break the triangle inequality, or its like in
    /// space, at this point.
    NotClosed {
        /// The point.
        point: usize,
    },
}

impl GeometryError {
    /// The error with the names of a listing, to be printed.
    pub fn named<'a>(&'a self, parts: &'a dyn Parts) -> WithNames<'a, Self> {
        WithNames { error: self, parts }
    }

    /// The point or length concerned.
    pub fn part(&self) -> Part {
        match *self {
            Self::NotFinite { point }
            | Self::Collinear { point }
            | Self::Flat { point }
            | Self::NoLine { point }
            | Self::NotClosed { point } => Part::Point(point),
            Self::BadLength { length } => Part::Length(length),
        }
    }
}

impl Failure for GeometryError {
    fn write(&self, f: &mut fmt::Formatter<'_>, name: &dyn fmt::Display) -> fmt::Result {
        match self {
            Self::NotFinite { .. } => write!(
                f,
                "point {name} has a coordinate that is not a finite number, or too large to compute with"
            ),
            Self::BadLength { .. } => {
                write!(
                    f,
                    "length {name} is not positive, or too large or too small to compute with"
                )
            }
            Self::Collinear { .. } => {
                write!(
                    f,
                    "the points that carry {name} lie in line; three that form a triangle are needed"
                )
            }
            Self::Flat { .. } => {
                write!(
                    f,
                    "point {name} lies in the plane of the points that links join it to, where their lengths do not hold it; state these points as a `body`"
                )
            }
            Self::NoLine { .. } => {
                write!(
                    f,
                    "the line that ends at {name} has no length; put its ends apart"
                )
            }
            Self::NotClosed { .. } => {
                write!(
                    f,
                    "the lengths to point {name} do not fit together in any rigid body"
                )
            }
        }
    }

    fn of(&self, parts: Option<&dyn Parts>, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let part = self.part();
        match parts {
            Some(parts) => self.write(f, &Quoted(parts.name(part))),
            None => self.write(f, &part.index()),
        }
    }
}

impl fmt::Display for GeometryError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.of(None, f)
    }
}

impl core::error::Error for GeometryError {}

/// `|denominator| <= threshold`: a formula of the paper is 0/0 here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Indeterminate<T> {
    /// The denominator, `w . n` with `w` the angular velocity (eq. 9) or acceleration (eq. 10) and `n`
    /// the normal of the three points.
    pub denominator: T,
    /// What its magnitude had to exceed.
    pub threshold: T,
}

impl<T: fmt::LowerExp> fmt::Display for Indeterminate<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "0/0: the vector that is asked for lies in the plane of the points (denominator {:.1e}, threshold {:.1e})",
            self.denominator, self.threshold
        )
    }
}

impl<T: fmt::Debug + fmt::LowerExp> core::error::Error for Indeterminate<T> {}

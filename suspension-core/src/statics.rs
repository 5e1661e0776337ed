//! Statics: the forces on drives and in equations due to forces at the points.
//!
//! Forces at the points do the work `f . dq` in a small motion of the unknowns. The equations balance them: with the
//! multipliers `m` of `J^T m = f` an equation acts on the unknowns with `-m dF/dq` and on the chassis points with
//! `-m dF/dc`, and the forces do the work `-m dF/du` per unit of a drive (virtual work). One factorisation serves all
//! loads of a position; each load takes one transposed back-substitution.
//!
//! This example has a spring of 60 N/mm at the damper, compressed to 3 kN. It computes the spring's force and rate at
//! the wheel, and the force in the pushrod:
//!
//! ```
//! use suspension_core::linkages::double_wishbone_pushrod::{Corner, Drives, Points, equation};
//!
//! let corner: Corner = Corner::design()?;
//! let (stiffness, force) = (60e3, 3e3);
//! let per_bump = corner.per(Drives { bump: 1.0, ..Drives::default() })?.measures;
//! let (ratio, change) = (per_bump.rate.damper, per_bump.second_rate.damper);
//! let wheel_rate = stiffness * ratio * ratio - force * change; // a ratio that changes has a part in it
//!
//! let at = corner.points().value;
//! let push = (at.damper_outer - at.damper_inner).normalize() * force;
//! let forces = Points { damper_outer: push, damper_inner: -push, ..Points::default() };
//! let loads = corner.statics()?.under(&forces)?;
//! let on_bump = loads.on_drives().bump; // force times ratio: it pushes the wheel down
//! let pushrod = loads.by(equation::PUSHROD..equation::PUSHROD + 1); // what it exerts on the points at its ends
//! let compression = pushrod.pushrod_upper.norm();
//! assert!((on_bump - force * ratio).abs() < 1e-9);
//! assert_eq!(
//!     format!("{:.2} N/mm, {on_bump:.0} N at the wheel, {compression:.0} N in the pushrod", wheel_rate / 1e3),
//!     "22.43 N/mm, -2140 N at the wheel, 2921 N in the pushrod"
//! );
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod configuration;
mod spread;

use core::ops::{Add, Neg, Range};

use nalgebra::{SVector, Vector3};

use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::pivot::least_pivot;
use crate::arithmetic::scalar::Real;
use crate::error::{Failure, SolveError};
use crate::linkage::Linkage;
use crate::listing::{Kind, Part, Parts};
use crate::solve::factored::{Factored, with_factors};
use crate::values::Values;
use configuration::Configuration;

pub use spread::spread;

/// A linkage in one configuration with its factored Jacobian, ready to be loaded. The chassis is at rest.
///
/// ```
/// use suspension_core::linkages::double_wishbone_pushrod::{Corner, Points};
/// use suspension_core::nalgebra::Vector3;
///
/// let corner: Corner = Corner::design()?;
/// let statics = corner.statics()?;
/// let mut forces = Points::default();
/// forces.wheel_centre = Vector3::new(0.0, 0.0, 4000.0); // N at the wheel centre, upwards
/// let loads = statics.under(&forces)?;
/// let on_bump = loads.on_drives().bump; // what holds the wheel where it is must bear it
/// assert!((on_bump - 4000.0).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy)]
pub struct Statics<'a, L: Linkage<N>, const N: usize> {
    at: Configuration<'a, L, N>,
    factored: Factored<L::Factors, L::Scalar, N>,
}

impl<'a, T: Real, L: Linkage<N, Scalar = T>, const N: usize> Statics<'a, L, N> {
    /// Factors the Jacobian at a position that solves the linkage for these values of the drives.
    ///
    /// # Errors
    ///
    /// As [`Tangent::new`](crate::Tangent::new): near a singularity forces are unbounded.
    pub fn new(
        linkage: &'a L,
        drives: L::Drives,
        position: &SVector<T, N>,
    ) -> Result<Self, SolveError<T>> {
        let at = Configuration::new(linkage, drives, position);
        Ok(Self {
            factored: Factored::new(linkage, position, &at.fixed)?,
            at,
        })
    }

    /// Loads the linkage with a force at each of its points, in the axes of the hardpoints. Forces at chassis points go
    /// into the chassis, or into the drive that moves the point. A force at a marker acts on the body that carries it: at
    /// the three points from which the marker is found. A force at any other place of a body must first be [`spread()`]
    /// over three points of that body.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] of the point at which a force is not finite, if the equations or a drive must bear it, or of
    /// the equation or drive that bears a force too large for the number type.
    pub fn under(
        &self,
        forces: &L::Points,
    ) -> Result<Loads<'a, L, N>, Failure<SolveError<T>, L::Listing>> {
        let linkage = self.at.linkage;
        let carried = self.at.carried(forces);
        let on_unknowns = on_unknowns(linkage, &carried);
        let multipliers = self.factored.factors().solve_transposed(&on_unknowns);
        let loads = Loads::checked(self.at, multipliers, &carried);
        loads.map_err(|error| at_point(forces, error).named(linkage.listing()))
    }
}

/// A linkage under forces.
#[derive(Clone, Copy)]
pub struct Loads<'a, L: Linkage<N>, const N: usize> {
    at: Configuration<'a, L, N>,
    multipliers: SVector<L::Scalar, N>,
    on_drives: L::Drives,
}

impl<'a, T: Real, L: Linkage<N, Scalar = T>, const N: usize> Loads<'a, L, N> {
    /// As [`Statics::under`] for one load, on a small stack: the factors are not kept.
    ///
    /// # Errors
    ///
    /// [`SolveError::Overflow`] of the equation or drive that bears a force that is not finite: a search for the point of
    /// the force would make firmware larger. [`SolveError::Singular`] if a pivot is not above 8 times the square root of `EPSILON`.
    /// [`Statics::new`] also considers the effect of the position's rounding errors, which takes more code: it
    /// refuses a little farther from a lock.
    pub fn new(
        linkage: &'a L,
        drives: L::Drives,
        position: &SVector<T, N>,
        forces: &L::Points,
    ) -> Result<Self, SolveError<T>> {
        let at = Configuration::new(linkage, drives, position);
        let carried = at.carried(forces);
        let on_unknowns = on_unknowns(linkage, &carried);
        let fixed = &at.fixed;
        let multipliers = with_factors(linkage, position, fixed, least_pivot(), |factors| {
            factors.solve_transposed(&on_unknowns)
        })?;
        Self::checked(at, multipliers, &carried)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn checked(
        at: Configuration<'a, L, N>,
        multipliers: SVector<T, N>,
        forces: &L::Points,
    ) -> Result<Self, SolveError<T>> {
        let refused = |part| SolveError::Overflow { part };
        magnitude(&multipliers).map_err(|equation| refused(Part::Equation(equation)))?;
        let on_drives = at.on_drives(&multipliers, forces);
        match on_drives.values().position(|load| !load.is_finite()) {
            Some(drive) => Err(refused(Part::Drive(drive))),
            None => Ok(Self {
                on_drives,
                at,
                multipliers,
            }),
        }
    }

    /// The multiplier of each equation. That of a link is the force in it, positive in tension; if a drive prescribes the
    /// link's angle from an axis, the part of the force along the link that the drive causes is not included.
    ///
    /// ```
    /// use suspension_core::linkages::double_wishbone::{Corner, Points, equation};
    /// use suspension_core::nalgebra::Vector3;
    ///
    /// let corner: Corner = Corner::design()?;
    /// let forces = Points { tie_ball: Vector3::new(0.0, 1000.0, 0.0), ..Points::default() }; // N, outboard
    /// let loads = corner.statics()?.under(&forces)?;
    /// assert!(loads.multipliers()[equation::TIE_ROD] > 900.0); // most of it pulls at the tie rod
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn multipliers(&self) -> &SVector<T, N> {
        &self.multipliers
    }

    /// The work of the forces per unit of each drive: a force along a drive that is a length, a moment about a drive
    /// that is an angle. It is borne by whatever moves the drive.
    pub fn on_drives(&self) -> L::Drives {
        self.on_drives
    }

    /// The forces that some equations, for example those of one statement, exert on chassis points and free points;
    /// zero at markers. A force at a marker acts at three points of its body and is not in those of the body there: the
    /// force in a joint of a loaded body is what the equations of the other parts exert on the point.
    pub fn by(&self, equations: Range<usize>) -> L::Points {
        let forces = self.on_points(|terms| self.work(terms, equations.clone()));
        L::Points::from_values(forces.map(Vector3::from))
    }

    /// The forces that each equation exerts on each chassis point and then on each free point: x, y and z, each for all
    /// equations. [`by`](Self::by) is the sum over some of them. For many statements this is faster: most of the time goes into
    /// derivatives with respect to chassis points, which this computes only once.
    pub fn by_equation(&self) -> impl Iterator<Item = [SVector<T, N>; 3]> {
        self.on_points(|terms| self.multipliers.component_mul(terms))
    }

    /// What a linear function of terms, one for each equation, is for the forces on chassis points and free points: along x, y
    /// and z.
    fn on_points<R: Add<Output = R> + Neg<Output = R>>(
        &self,
        of: impl Fn(&SVector<T, N>) -> R,
    ) -> impl Iterator<Item = [R; 3]> {
        let Configuration {
            linkage,
            fixed,
            position,
            ..
        } = &self.at;
        let [chassis, free] = [Kind::ChassisPoint, Kind::FreePoint].map(|kind| linkage.count(kind));
        let jacobian = linkage.jacobian(position, fixed);
        (0..chassis + free).map(move |point| match point.checked_sub(chassis) {
            None => [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| {
                let rate = L::Fixed::default().with(point, axis);
                let driven = linkage.drive_rate(position, fixed, &rate, &L::Drives::default());
                of(&driven) + of(&linkage.chassis_rate(position, fixed, &rate))
            }),
            Some(free) => [0, 1, 2].map(|axis| {
                let column = column_of(&jacobian, 3 * free + axis);
                -of(&column.unwrap_or_else(SVector::zeros))
            }),
        })
    }

    /// The multipliers of some equations times terms of these equations.
    fn work(&self, terms: &SVector<T, N>, equations: Range<usize>) -> T {
        let pairs = self.multipliers.iter().zip(terms.iter()).enumerate();
        let those = pairs.filter(|(equation, _)| equations.contains(equation));
        those.fold(T::zero(), |sum, (_, (multiplier, term))| {
            sum + *multiplier * *term
        })
    }
}

/// The error of the first given force that is not finite, or else that of what bears the forces.
#[cold]
#[inline(never)]
fn at_point<T: Real, P: Values<Vector3<T>>>(forces: &P, error: SolveError<T>) -> SolveError<T> {
    let is_finite = |force: Vector3<T>| force.iter().all(|number| number.is_finite());
    let point = forces.values().position(|force| !is_finite(force));
    point.map_or(error, |point| SolveError::Overflow {
        part: Part::Point(point),
    })
}

/// The forces on the coordinates of the free points. Unknowns that are not coordinates, such as a place along a line,
/// bear none.
#[cfg_attr(not(debug_assertions), inline(always))]
fn on_unknowns<T: Real, L: Linkage<N, Scalar = T>, const N: usize>(
    linkage: &L,
    forces: &L::Points,
) -> SVector<T, N> {
    let mut on_unknowns = linkage.unknowns(forces);
    let others = on_unknowns.iter_mut();
    for other in others.skip(3 * linkage.count(Kind::FreePoint)) {
        *other = T::zero();
    }
    on_unknowns
}

fn column_of<T: Real, const N: usize>(
    matrix: &nalgebra::SMatrix<T, N, N>,
    column: usize,
) -> Option<SVector<T, N>> {
    matrix
        .data
        .0
        .get(column)
        .map(|column| SVector::from(*column))
}

//! A proof that exactly one root lies near a position.
//!
//! The equations are quadratic: `J(q + d) = J(q) + C(d, .)` with a constant `C`
//! ([`constraint`](crate::model::constraint)). Let `A` be any matrix and let, in the maximum norm,
//!
//! ```text
//! |A F(q)| <= Y     |I - A J(q)| <= Z < 1     |A C(v, w)| <= K |v| |w|     2 K Y < (1 - Z)^2
//! ```
//!
//! Then `T(x) = x - A F(x)` maps the ball of each radius `r` about `q` with
//! `K r^2 / 2 - (1 - Z) r + Y <= 0` into itself. It therefore has a fixed point there (Brouwer), which
//! is a root, because `A` is regular if `Z < 1`. Two roots `x`, `y` obey
//! `x - y = (I - A J((x + y) / 2)) (x - y)` exactly, so there is only one if
//! `K (|x - q| + |y - q|) / 2 < 1 - Z`. With `h = 2 K Y / (1 - Z)^2`
//!
//! ```text
//! radius = 2 Y / ((1 - Z) (2 - h))        unique_within = 2 (1 - Z) / K - radius
//! ```
//!
//! meet both conditions. There `|I - A J| < 1` too, so the root is regular. This is the theorem of
//! Newton and Kantorovich (Ortega 1968, Amer. Math. Monthly 75; Deuflhard 2011, Newton Methods for
//! Nonlinear Problems, section 2.1) in the form of radii polynomials (Day, Lessard and Mischaikow
//! 2007, SIAM J. Numer. Anal. 45), for quadratic equations, where its proof is elementary.
//!
//! `F`, `J` and `C` are evaluated with [`Enclosed`] numbers and the bounds are rounded upwards. The proof
//! therefore includes rounding; a wrong `A` makes it fail, not false. It holds for the equations
//! with lengths, constants of bodies, chassis points and drives exactly as they are stored, and with the
//! true cosine of driven angles. It does not cover the rounding of chassis points by
//! [`RigidMotion`](crate::chassis::RigidMotion).

use nalgebra::{SVector, Vector3};

use crate::arithmetic::magnitude::magnitude;
use crate::arithmetic::pivot::is_healthy;
use crate::arithmetic::scalar::Real;
use crate::arithmetic::trigonometry::{FORMULA_ERROR, LARGEST_ANGLE};
use crate::error::SolveError;
use crate::linkage::{Factors, Linkage, Listing, Values};
use crate::listing::DriveKind;
use crate::path::DriveCoordinate;
use crate::signal::{ChassisMotion, Inputs, Signal};
use crate::solve::factored::with_pivoting;
use crate::solve::motion::Prescribed;

mod bounds;
mod enclosed;
mod inverse;
mod verdict;

use bounds::Bounds;
pub use enclosed::Enclosed;
use inverse::Columns;
pub use verdict::{Certificate, Unproved};

/// The model of a linkage in enclosed numbers.
type Enclosing<L, const N: usize> =
    <<L as Linkage<N>>::Listing as Listing<N>>::Model<Enclosed<<L as Linkage<N>>::Scalar>>;

/// Proves roots of one model. Make it once and use it for many positions.
///
/// ```
/// use suspension_core::nalgebra::Vector3;
/// use suspension_core::{Build, Inputs, Signal};
/// use suspension_core::certificate::{Certificate, Certifier};
///
/// suspension_core::linkage! {
///     mod rod {
///         fixed: a;
///         free:  p;
///         link rod: a -> p;
///         drive y: p.y;
///         drive z: p.z;
///     }
/// }
/// use rod::{Drives, Model, Points};
///
/// let design = Points { a: Vector3::zeros(), p: Vector3::new(3.0, 0.0, 4.0) };
/// let certifier = Certifier::new(&Model::new(&design)?);
/// let inputs = |z| {
///     let value = Drives { y: 0.0, z };
///     Inputs::still(Signal { value, ..Signal::default() })
/// };
/// // The root is a millimetre away, its mirror image six metres.
/// let near = certifier.certify(&inputs(4.0), &Vector3::new(3.001, 0.0, 4.0));
/// let Certificate::Proved { radius, unique_within } = near else { panic!("{near:?}") };
/// assert!((0.001..0.00101).contains(&radius) && (1.0..6.0).contains(&unique_within));
/// // Nowhere on the rod of five metres.
/// let beyond = certifier.certify(&inputs(5.0 + 1e-12), &Vector3::new(1e-6, 0.0, 5.0));
/// assert!(!beyond.is_proved());
/// # Ok::<(), suspension_core::GeometryError>(())
/// ```
#[derive(Clone, Copy)]
pub struct Certifier<L, const N: usize>
where
    L: Linkage<N, Scalar: Real>,
{
    linkage: L,
    enclosing: Enclosing<L, N>,
    /// Bounds of `|C_k(v, w)|` for `|v|, |w| <= 1`.
    curvatures: [L::Scalar; N],
    /// How the Jacobian is inverted.
    columns: Columns<N>,
}

impl<T, L, const N: usize> Certifier<L, N>
where
    T: Real,
    L: Linkage<N, Scalar = T, Listing: Listing<N, Model<T> = L>> + Copy,
{
    /// The certifier of a model.
    pub fn new(linkage: &L) -> Self {
        let enclosing = L::Listing::converted(linkage, Enclosed::exact);
        let number = Enclosed::within(T::zero(), T::one());
        let any = SVector::from([number; N]);
        let at_rest = Default::default();
        let anywhere = Values::from_values(core::iter::repeat(Vector3::repeat(number)));
        // The Jacobian is affine in the positions, so an entry that is exactly zero or one here is so at all
        // positions.
        let columns = Columns::new(&enclosing.jacobian(&any, &anywhere));
        let [curvatures] = enclosing.curvature(&any, &at_rest, &any, &at_rest).data.0;
        Self {
            linkage: *linkage,
            enclosing,
            curvatures: curvatures.map(Enclosed::magnitude),
            columns,
        }
    }

    /// Proves that a root for `inputs`, whose rates are not used, lies near `q`, or says why no proof was found.
    /// Takes about as long as four steps to tolerance.
    pub fn certify<C>(&self, inputs: &Inputs<C, L::Drives>, q: &SVector<T, N>) -> Certificate<T>
    where
        C: ChassisMotion<L::Fixed>,
    {
        match self.bounds(inputs, q) {
            Ok(bounds) => verdict::judge(&bounds),
            Err(cause) => Certificate::Unproved {
                why: Unproved::NoBounds { cause },
            },
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn bounds<C>(
        &self,
        inputs: &Inputs<C, L::Drives>,
        q: &SVector<T, N>,
    ) -> Result<Bounds<T>, SolveError<T>>
    where
        C: ChassisMotion<L::Fixed>,
    {
        let drives = self.coordinates(&inputs.drives.value);
        let chassis = inputs.chassis.signal(self.linkage.fixed()).value;
        let fixed = self.enclosing.drive_anchors(
            Values::from_values(chassis.values().map(|point| point.map(Enclosed::exact))),
            &drives,
        );
        let [position] = q.data.0;
        let position = SVector::from(position.map(Enclosed::exact));
        let residual = self.enclosing.residual(&position, &fixed, &drives);
        let [enclosed] = residual.data.0;
        magnitude(&SVector::from(enclosed.map(Enclosed::magnitude)))
            .map_err(SolveError::not_finite)?;
        let jacobian = self.enclosing.jacobian(&position, &fixed);
        let at = Prescribed::new(&self.linkage, inputs).fixed.value;
        // `with_factors` is not used here: back-substitutions called through a `dyn` take a third longer.
        let mut inverse = [[T::zero(); N]; N];
        let factors = self.linkage.factor(q, &at);
        if is_healthy(factors.growth_squared()) {
            self.columns.invert(&factors, &jacobian, &mut inverse);
        } else {
            let factors = with_pivoting(&self.linkage, q, &at, T::zero())?;
            self.columns.invert(&factors, &jacobian, &mut inverse);
        }
        Bounds::new(&residual, &jacobian, &self.curvatures, &inverse)
    }

    /// The coordinates that drives prescribe.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coordinates(&self, drives: &L::Drives) -> <Enclosing<L, N> as Linkage<N>>::Drives {
        let exact = Values::from_values(drives.values().map(Enclosed::exact));
        let computed = self.enclosing.coordinates(&Signal {
            value: exact,
            ..Signal::default()
        });
        let each = computed.value.values().zip(drives.values()).enumerate();
        Values::from_values(each.map(|(index, (coordinate, drive))| {
            let is_covered = drive.abs() <= T::constant(LARGEST_ANGLE);
            match self.linkage.drive_kind(index) {
                DriveKind::Coordinate => coordinate,
                DriveKind::Angle if is_covered => {
                    coordinate.widened(self.linkage.size() * T::constant(FORMULA_ERROR))
                }
                DriveKind::Turn if is_covered => {
                    let length = DriveCoordinate::new(&self.linkage, index).largest();
                    let length = length.unwrap_or_else(T::zero);
                    coordinate.widened(length * T::constant(FORMULA_ERROR))
                }
                DriveKind::Angle | DriveKind::Turn => coordinate / Enclosed::exact(T::zero()),
            }
        }))
    }
}

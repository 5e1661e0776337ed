//! The link that keeps a mechanism from following its drives, and the length that it would need; or the hinge.

use nalgebra::SVector;
use suspension_core::solve::lu::Lu;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Inputs, Linkage, Still, Values};

use crate::file::Unit;
use crate::mechanism::motion::drive_laws::DriveLaws;
use crate::mechanism::parts::hinge::Hinge;
use crate::mechanism::parts::names::Names;
use crate::mechanism::parts::words::listed;
use crate::mechanism::suspension::Suspension;
use crate::number::rounded;

/// A link whose length does not allow a configuration; or several links, such as the two of a wishbone, for each of
/// which that is true.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BlockingLink {
    /// The names, first that of the link whose lengths are known.
    names: Vec<String>,
    /// Whether it is too short to go on.
    is_short: bool,
    /// Its actual length, and the length nearest to it with which there is a configuration at the place asked for, if
    /// that is known.
    lengths: Option<[f64; 2]>,
}

/// The number of instants on the way from the last configuration to the requested one.
const INSTANTS: i32 = 40;

/// The largest number of corrections at each of them.
const CORRECTIONS: usize = 30;

/// The change of the configuration below which the corrections end, as a fraction of the mechanism's size.
const CORRECTED: f64 = 1e-9;

/// The longest step along the configurations that all other equations allow, as a fraction of the mechanism's size.
const LONGEST: f64 = 0.1;

/// How far other equations may be off at the end, as a fraction of the mechanism's size.
const CLOSED: f64 = 1e-6;

/// The share in the end of a motion from which a link or a hinge is named as its cause.
const LEAST_SHARE: f64 = 0.1;

/// The difference up to which shares are alike: rounding does not decide which of two links is named first.
const ALIKE: f64 = 1e-6;

/// The fraction of the named link's share from which another link is named with it.
const BESIDE: f64 = 0.5;

impl BlockingLink {
    /// The link that ends a motion between two times, of which only the first has a configuration, `q`; `None` if no
    /// link's length is the cause.
    pub(crate) fn find<L: Suspension<N>, const N: usize>(
        model: &L,
        names: &Names,
        drives: &DriveLaws,
        times: [f64; 2],
        q: &SVector<f64, N>,
    ) -> Option<Self> {
        let at_lock = AtDrives::new(model, drives, times[0]).analyse_lock(q)?;
        let shares = &at_lock.shares;
        // A line of a driven or held angle would have another angle if it were longer.
        let is_link = |row: &usize| names.is_free_link(&names.equations[*row]);
        let links = || (0..names.equations.len()).filter(is_link);
        let equation = greatest(links().map(|row| (row, shares[row])))?;
        let is_beside = |row: &usize| *row != equation && shares[*row] / shares[equation] > BESIDE;
        let named = [equation].into_iter().chain(links().filter(is_beside));
        let length = names.link(&names.equations[equation])?;
        let has = model.lengths().values().nth(length)?;
        let is_short = shares[equation] > 0.0;
        let needs = needed_length(model, drives, times, *q, at_lock.along, (equation, has));
        let is_like_fault = |needs: &f64| (has < *needs) == is_short;
        Some(Self {
            names: named.map(|row| names.equations[row].clone()).collect(),
            is_short,
            lengths: needs.filter(is_like_fault).map(|needs| [has, needs]),
        })
    }

    /// A description of whether it is too long or too short.
    pub(crate) fn fault(&self) -> String {
        let fault = if self.is_short { "short" } else { "long" };
        let are = if self.names.len() == 1 { "is" } else { "are" };
        let names = listed(self.names.iter().map(|name| format!("`{name}`")));
        format!("{names} {are} too {fault}")
    }

    /// The fault, and the lengths if the digits shown differ.
    pub(crate) fn in_words(&self, unit: Unit) -> String {
        const DIGITS: usize = 6;
        let (fault, symbol) = (self.fault(), unit.symbol());
        let lengths = self
            .lengths
            .map(|each| each.map(|length| rounded(length, DIGITS)));
        let Some([has, needs]) = lengths.filter(|[has, needs]| has != needs) else {
            return fault;
        };
        let it = match self.names.as_slice() {
            [first, _, ..] => format!("`{first}`"),
            _ => "it".to_owned(),
        };
        format!(
            "{fault}: {it} has {has} {symbol} and would need {needs} {symbol} at the place asked for"
        )
    }
}

/// The length nearest to its own with which a link, given by its equation and its length, lets the drives be where they
/// are asked to be at the second time; the first time has the configuration `q`.
fn needed_length<L: Suspension<N>, const N: usize>(
    model: &L,
    drives: &DriveLaws,
    [reached, asked]: [f64; 2],
    mut q: SVector<f64, N>,
    mut along: SVector<f64, N>,
    (equation, has): (usize, f64),
) -> Option<f64> {
    for instant in 1..=INSTANTS {
        let part = f64::from(instant) / f64::from(INSTANTS);
        let place = AtDrives::new(model, drives, reached + (asked - reached) * part);
        q = place.nearest(q, equation, &mut along)?;
    }
    let off = AtDrives::new(model, drives, asked).residual(&q);
    let closed = CLOSED * model.size();
    let is_closed = (0..N).all(|row| row == equation || off[row].abs() <= closed);
    // The equation of a distance is (d^2 - L^2) / (2 L).
    is_closed.then(|| (has * (has + 2.0 * off[equation])).sqrt())
}

/// The hinge with the greatest share in the end of a motion, at the time `reached` and the configuration `q`; `None`
/// if no share is large.
pub(crate) fn find_hinge_at_lock<'n, L: Suspension<N>, const N: usize>(
    model: &L,
    names: &'n Names,
    drives: &DriveLaws,
    reached: f64,
    q: &SVector<f64, N>,
) -> Option<&'n Hinge> {
    let AtLock { shares, along, .. } = AtDrives::new(model, drives, reached).analyse_lock(q)?;
    let hinges = names.hinges.iter().filter(|hinge| hinge.moves(&along));
    let share = |hinge: &Hinge| {
        let rows = (0..N).filter(|row| hinge.has(*row));
        rows.map(|row| shares[row]).sum()
    };
    greatest(hinges.map(|hinge| (hinge, share(hinge))))
}

/// The item with the greatest share, of either sign, if that is large; of several alike the first.
fn greatest<T>(shares: impl Iterator<Item = (T, f64)>) -> Option<T> {
    let greatest = shares.reduce(|greatest, next| {
        let more = next.1.abs() - greatest.1.abs();
        if more > ALIKE { next } else { greatest }
    });
    let (named, _) = greatest.filter(|(_, share)| share.abs() > LEAST_SHARE)?;
    Some(named)
}

/// A mechanism at its lock. The rows of its Jacobian `J` are linearly dependent, `f^T J = 0`, and a motion `v`
/// changes no equation to first order, `J v = 0`. To second order a drive `s` with `f^T dF/ds = 1` has
/// `s'' = -f^T C(v, v)` along it: the equations with large `f_k C_k(v, v)` prevent the drive from going further. The
/// forces `f` alone do not show which these are: a link that bears much and does not rotate has `C_k(v, v) = 0`.
pub(crate) struct AtLock<const N: usize> {
    /// `f`, a unit vector.
    pub(crate) forces: SVector<f64, N>,
    /// The share of each equation, `f_k C_k(v, v) / f^T C(v, v)`. Their sum is one; equations with a negative share
    /// let the drive go on. A link has `C_k(v, v) > 0`: if its share is positive, the drive would go on if it were longer,
    /// otherwise if it were shorter.
    shares: SVector<f64, N>,
    /// `v`, a unit vector.
    along: SVector<f64, N>,
}

/// A mechanism whose drives have the values of a time.
pub(crate) struct AtDrives<'a, L: Linkage<N>, const N: usize> {
    model: &'a L,
    fixed: L::Fixed,
    drives: L::Drives,
}

impl<'a, L: Suspension<N>, const N: usize> AtDrives<'a, L, N> {
    fn new(model: &'a L, drives: &DriveLaws, t: f64) -> Self {
        Self::of(model, &drives.inputs(t))
    }

    /// The place with these drives.
    pub(crate) fn of(model: &'a L, inputs: &Inputs<Still, L::Drives>) -> Self {
        let Prescribed { fixed, drives } = Prescribed::new(model, inputs);
        Self {
            model,
            fixed: fixed.value,
            drives: drives.value,
        }
    }

    pub(crate) fn residual(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.model.residual(q, &self.fixed, &self.drives)
    }

    /// `f` and `v` by inverse iteration: they are the singular vectors of the smallest singular value.
    pub(crate) fn analyse_lock(&self, q: &SVector<f64, N>) -> Option<AtLock<N>> {
        let still = L::Fixed::default();
        let factors = Lu::factor(&self.model.jacobian(q, &self.fixed)).ok()?;
        let mut forces = SVector::<f64, N>::from_element(1.0);
        let mut along = forces;
        for _ in 0..3 {
            along = factors.solve(&forces).normalize();
            forces = factors.solve_transposed(&along).normalize();
        }
        let bend = self.model.curvature(&along, &still, &along, &still);
        let shares = forces.component_mul(&bend) / forces.dot(&bend);
        Some(AtLock {
            forces,
            shares,
            along,
        })
    }

    /// The configuration where all equations but that of a link hold and the error of this one is as small as
    /// possible. The configurations that the others allow form a curve, with a direction near `along`; Newton's
    /// method moves on it to where the link's error is stationary.
    fn nearest(
        &self,
        mut q: SVector<f64, N>,
        link: usize,
        along: &mut SVector<f64, N>,
    ) -> Option<SVector<f64, N>> {
        let still = L::Fixed::default();
        let size = self.model.size();
        let others = |mut rows: SVector<f64, N>| {
            rows[link] = 0.0;
            rows
        };
        let mut alone = SVector::zeros();
        alone[link] = 1.0;
        for _ in 0..CORRECTIONS {
            let mut jacobian = self.model.jacobian(&q, &self.fixed);
            let of_link = jacobian.row(link).transpose();
            jacobian.set_row(link, &along.transpose());
            let factors = Lu::factor(&jacobian).ok()?;
            let tangent = factors.solve(&alone);
            let residual = self.residual(&q);
            let onto_curve = factors.solve(&others(residual));
            let bend = self.model.curvature(&tangent, &still, &tangent, &still);
            let bent = factors.solve(&others(bend));
            let off = residual[link] - of_link.dot(&onto_curve);
            let slope = of_link.dot(&tangent);
            let second_slope = bend[link] - of_link.dot(&bent);
            let step = if off * second_slope > 0.0 {
                slope / second_slope
            } else {
                (off * slope).signum() * LONGEST * size
            };
            let step = step.clamp(-LONGEST * size, LONGEST * size);
            let correction = onto_curve + tangent * step;
            q -= correction;
            *along = tangent.normalize();
            if correction.amax() < CORRECTED * size {
                break;
            }
        }
        Some(q)
    }
}

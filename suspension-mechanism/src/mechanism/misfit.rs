//! Which link keeps a mechanism from following its drives, and how long it would have to be; or which hinge.

use nalgebra::SVector;
use suspension_core::solve::lu::Lu;
use suspension_core::solve::motion::Prescribed;
use suspension_core::{Linkage, Values};

use crate::mechanism::drives::DriveLaws;
use crate::mechanism::hinge::Hinge;
use crate::mechanism::names::{Names, Suspension};
use crate::number::rounded;
use suspension_motion_file::Unit;

/// A link whose length does not allow a configuration, or several of which each one does not, as the two of a wishbone.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Misfit {
    /// First the one whose lengths are known.
    names: Vec<String>,
    /// The length that it has.
    has: f64,
    /// The nearest to it with which there is a configuration.
    needs: f64,
}

/// Instants on the way from the last configuration to the one that was asked for.
const INSTANTS: i32 = 40;

/// Corrections at each of them, at most.
const CORRECTIONS: usize = 30;

/// A change of the configuration after which there is no other, as a part of the mechanism's size.
const CORRECTED: f64 = 1e-9;

/// The longest step along the configurations that all other equations allow, as a part of it.
const LONGEST: f64 = 0.1;

/// How far other equations may be off at the end, as a part of it.
const CLOSED: f64 = 1e-6;

/// Of what turns a drive at its lock, the part that a link or a hinge must have to be the one that ends the motion.
const TURNS: f64 = 0.1;

/// Of the share of the link that is named, the least with which another is named beside it.
const BESIDE: f64 = 0.5;

impl Misfit {
    /// The link that ends a motion between two times, of which the mechanism has a configuration, `q`, at the
    /// first alone. `None` where it is no link's length.
    pub(crate) fn between<L: Suspension<N>, const N: usize>(
        model: &L,
        names: &Names,
        drives: &DriveLaws,
        [reached, asked]: [f64; 2],
        q: &SVector<f64, N>,
    ) -> Option<Self> {
        let place = Place::at(model, drives, reached);
        let Turning { shares, mut along } = place.turning(q)?;
        // A line of an angle that is driven or held would have another angle if it were longer.
        let is_link = |row: &usize| names.is_free_link(&names.equations[*row]);
        let links = || (0..names.equations.len()).filter(is_link);
        let equation = greatest(links().map(|row| (row, shares[row])))?;
        let mut q = *q;
        for instant in 1..=INSTANTS {
            let part = f64::from(instant) / f64::from(INSTANTS);
            let place = Place::at(model, drives, reached + (asked - reached) * part);
            q = place.nearest(q, equation, &mut along)?;
        }
        let off = Place::at(model, drives, asked).residual(&q);
        let closed = CLOSED * model.size();
        if (0..N).any(|row| row != equation && off[row].abs() > closed) {
            return None;
        }
        let is_beside = |row: &usize| *row != equation && shares[*row] / shares[equation] > BESIDE;
        let named = [equation].into_iter().chain(links().filter(is_beside));
        let length = names.link(&names.equations[equation])?;
        let has = model.lengths().values().nth(length)?;
        // The equation of a distance is (d^2 - L^2) / (2 L).
        let needs = (has * (has + 2.0 * off[equation])).sqrt();
        Some(Self {
            names: named.map(|row| names.equations[row].clone()).collect(),
            has,
            needs,
        })
    }

    /// Whether it is too long or too short, in words.
    pub(crate) fn fault(&self) -> String {
        let fault = if self.has > self.needs {
            "long"
        } else {
            "short"
        };
        let names: Vec<String> = self.names.iter().map(|name| format!("`{name}`")).collect();
        let are = if names.len() == 1 { "is" } else { "are" };
        format!("{} {are} too {fault}", names.join(" and "))
    }

    /// The fault, and the lengths where the digits shown differ.
    pub(crate) fn in_words(&self, unit: Unit) -> String {
        const DIGITS: usize = 6;
        let [has, needs] = [self.has, self.needs].map(|length| rounded(length, DIGITS));
        let (fault, symbol) = (self.fault(), unit.symbol());
        if has == needs {
            return fault;
        }
        let it = match self.names.as_slice() {
            [first, _, ..] => format!("`{first}`"),
            _ => "it".to_owned(),
        };
        format!(
            "{fault}: {it} has {has} {symbol} and would need {needs} {symbol} at the place asked for"
        )
    }
}

/// The hinge that turns the drive most at the last configuration, `q`, of a motion that ends at the time `reached`; `None` where none does
/// much.
pub(crate) fn turning_hinge<'n, L: Suspension<N>, const N: usize>(
    model: &L,
    names: &'n Names,
    drives: &DriveLaws,
    reached: f64,
    q: &SVector<f64, N>,
) -> Option<&'n Hinge> {
    let Turning { shares, along } = Place::at(model, drives, reached).turning(q)?;
    let hinges = names.hinges.iter().filter(|hinge| hinge.moves(&along));
    let share = |hinge: &Hinge| {
        let rows = (0..N).filter(|row| hinge.has(*row));
        rows.map(|row| shares[row]).sum()
    };
    greatest(hinges.map(|hinge| (hinge, share(hinge))))
}

/// The part with the greatest share, of either sign, where that is large.
fn greatest<T>(shares: impl Iterator<Item = (T, f64)>) -> Option<T> {
    let greatest = shares.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
    let (part, _) = greatest.filter(|(_, share)| share.abs() > TURNS)?;
    Some(part)
}

/// How a mechanism turns where it locks.
struct Turning<const N: usize> {
    /// The share of each equation in turning the drive: the force that it bears there times what the motion changes it by to the second
    /// order. The sum of all is one; that of a link which folds onto what it turns is below zero.
    shares: SVector<f64, N>,
    /// The motion that the drive, held there, leaves to the mechanism.
    along: SVector<f64, N>,
}

/// A model at an instant.
struct Place<'a, L: Linkage<N>, const N: usize> {
    model: &'a L,
    fixed: L::Fixed,
    drives: L::Drives,
}

impl<'a, L: Suspension<N>, const N: usize> Place<'a, L, N> {
    fn at(model: &'a L, drives: &DriveLaws, t: f64) -> Self {
        let inputs = drives.inputs::<L::Drives>(t);
        let Prescribed { fixed, drives } = Prescribed::new(model, &inputs);
        Self {
            model,
            fixed: fixed.value,
            drives: drives.value,
        }
    }

    fn residual(&self, q: &SVector<f64, N>) -> SVector<f64, N> {
        self.model.residual(q, &self.fixed, &self.drives)
    }

    /// Where a mechanism locks the rows of its Jacobian depend on each other, with forces that balance within the mechanism as factors, and a
    /// motion changes no equation to the first order.
    fn turning(&self, q: &SVector<f64, N>) -> Option<Turning<N>> {
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
        Some(Turning { shares, along })
    }

    /// Where all equations but that of a link hold and this is off as little as can be. The configurations that the others
    /// allow are a curve, with a direction near `along`; on it by Newton's method to where the link's error is stationary.
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

//! The link that keeps a mechanism from following its drives, and the length that it would need; or the hinge.

use nalgebra::SVector;
use suspension_core::Values;

use crate::file::Unit;
use crate::mechanism::lock::at_drives::{AtDrives, AtLock};
use crate::mechanism::motion::drive_laws::DriveLaws;
use crate::mechanism::parts::hinge::Hinge;
use crate::mechanism::parts::names::Names;
use crate::mechanism::parts::words::quoted;
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

/// How far other equations may be off at the end, as a fraction of the mechanism's size.
const CLOSED: f64 = 1e-6;

/// The share in the end of a motion from which a link or a hinge is named as its cause.
const LEAST_SHARE: f64 = 0.1;

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
        let at_lock = AtDrives::new(model, &drives.inputs(times[0])).analyse_lock(q)?;
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
        format!("{} {are} too {fault}", quoted(&self.names))
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
        let time = reached + (asked - reached) * part;
        let place = AtDrives::new(model, &drives.inputs(time));
        q = place.nearest(q, equation, &mut along)?;
    }
    let off = AtDrives::new(model, &drives.inputs(asked)).residual(&q);
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
    let AtLock { shares, along, .. } =
        AtDrives::new(model, &drives.inputs(reached)).analyse_lock(q)?;
    let hinges = names.hinges.iter().filter(|hinge| hinge.moves(&along));
    let share = |hinge: &Hinge| {
        let rows = (0..N).filter(|row| hinge.has(*row));
        rows.map(|row| shares[row]).sum()
    };
    greatest(hinges.map(|hinge| (hinge, share(hinge))))
}

/// The item with the greatest share, of either sign, if that is large; of equal ones, as in a symmetric suspension, the
/// first.
fn greatest<T>(shares: impl Iterator<Item = (T, f64)> + Clone) -> Option<T> {
    /// The part of the greatest share within which others count as equal: more than their rounding at a lock.
    const EQUAL: f64 = 1e-3;
    let sizes = shares.clone().map(|(_, share)| share.abs());
    let greatest = sizes.fold(0.0, f64::max);
    let mut large = shares.filter(|(_, share)| share.abs() > LEAST_SHARE);
    let (named, _) = large.find(|(_, share)| share.abs() >= greatest * (1.0 - EQUAL))?;
    Some(named)
}

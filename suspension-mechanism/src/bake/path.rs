//! The exact motion as a function of one drive.

use std::fmt;

use suspension_core::stepper::Stopped;
use suspension_core::{Linkage, Motion, SolveError, Values};

use crate::bake::driven::{Derivatives, Driven, Output, Wish};
use crate::mechanism::Suspension;
use crate::number::number;

/// The mechanism moved by one drive, the others held.
#[derive(Clone, Debug)]
pub struct Path<'a, L: Linkage<N>, const N: usize> {
    driven: Driven<'a, L>,
    held: L::Drives,
    drive: usize,
    /// Configurations evenly over the range, with the drive's value.
    anchors: Vec<(f64, Motion<f64, N>)>,
}

/// The mechanism does not go through the range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfReach {
    /// The drive's first and last value towards the range that the mechanism reaches.
    pub reached: [f64; 2],
    /// Why it goes no further.
    pub cause: Option<SolveError<f64>>,
}

impl fmt::Display for OutOfReach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [from, to] = self.reached.map(number);
        write!(f, "the mechanism takes the drive from {from} to {to} only")?;
        self.cause.map_or(Ok(()), |cause| write!(f, ": {cause}"))
    }
}

impl std::error::Error for OutOfReach {}

/// A motion along a drive, whatever its linkage.
pub trait Exact {
    /// What the outputs are.
    fn outputs(&self) -> Vec<Output>;

    /// The outputs where the drive has the value `at`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`].
    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach>;
}

pub(super) const ANCHORS: u32 = 65;

impl<'a, L: Suspension<N>, const N: usize> Path<'a, L, N> {
    /// The path of drive number `drive` over `range`, with the other drives held at `held`. The
    /// mechanism is driven there from the configuration `start` at `held`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] where the mechanism cannot be driven through the range.
    pub fn new(
        model: &'a L,
        start: &Motion<f64, N>,
        held: L::Drives,
        drive: usize,
        range: [f64; 2],
        wish: Wish,
    ) -> Result<Self, OutOfReach> {
        let mut path = Self {
            driven: Driven::new(model, wish),
            held,
            drive,
            anchors: Vec::new(),
        };
        let now = held.values().nth(drive).unwrap_or_default();
        let [mut first, mut last] = [*start; 2];
        let [from, to] = range;
        let ways = [
            path.follow([now, from], &mut first),
            path.follow([now, to], &mut last),
        ];
        if let Some(cause) = ways.iter().find_map(|way| way.err()) {
            let [down, up] = ways.map(|way| way.err().map(|(reached, _)| reached));
            return Err(OutOfReach {
                reached: [down.unwrap_or(from), up.unwrap_or(to)],
                cause: cause.1,
            });
        }
        let (mut at, mut motion) = (from, first);
        for part in 0..ANCHORS {
            let next = from + (to - from) * f64::from(part) / f64::from(ANCHORS - 1);
            path.drive([at, next], &mut motion)?;
            path.anchors.push((next, motion));
            at = next;
        }
        Ok(path)
    }

    fn follow(&self, [from, to]: [f64; 2], motion: &mut Motion<f64, N>) -> Result<(), Stop> {
        let ends = [from, to].map(|at| self.held.with(self.drive, at));
        let followed = self.driven.follow([&ends[0], &ends[1]], motion);
        followed.map_err(|Stopped { reached, refused }| {
            let reached = from + (to - from) * reached;
            (reached, refused.map(|(_, cause)| cause))
        })
    }

    fn drive(&self, way: [f64; 2], motion: &mut Motion<f64, N>) -> Result<(), OutOfReach> {
        let followed = self.follow(way, motion);
        followed.map_err(|(reached, cause)| OutOfReach {
            reached: [way[0], reached],
            cause,
        })
    }
}

/// The drive's value where the mechanism stopped, and why.
type Stop = (f64, Option<SolveError<f64>>);

impl<L: Suspension<N>, const N: usize> Exact for Path<'_, L, N> {
    fn outputs(&self) -> Vec<Output> {
        self.driven.outputs()
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let distance = |(from, _): &&(f64, Motion<f64, N>)| (from - at).abs();
        let nearest = self
            .anchors
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let Some((from, mut motion)) = nearest.copied() else {
            return Ok(Vec::new());
        };
        self.drive([from, at], &mut motion)?;
        let value = self.held.with(self.drive, at);
        let unit = L::Drives::default().with(self.drive, 1.0);
        let read = self.driven.derivatives(&motion, value, [unit]);
        let [along] = read.map_err(|cause| OutOfReach {
            reached: [from, at],
            cause: Some(cause),
        })?;
        Ok(along)
    }
}

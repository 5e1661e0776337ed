//! The exact motion as a function of one drive.

use suspension_core::{Linkage, Motion, Values};

use crate::bake::anchors::Anchors;
use crate::bake::driven::{Derivatives, Driven, Output, RequestedPoints};
use crate::bake::exact::{Exact, OutOfReach, Stop};
use crate::mechanism::Suspension;

/// The mechanism moved by one drive, with the others held.
#[derive(Clone)]
pub struct Path<'a, L: Linkage<N>, const N: usize> {
    way: Way<'a, L, N>,
    anchors: Anchors<Motion<f64, N>>,
}

/// The way along the drive.
#[derive(Clone)]
struct Way<'a, L: Linkage<N>, const N: usize> {
    driven: Driven<'a, L>,
    held: L::Drives,
    drive: usize,
}

impl<'a, L: Suspension<N>, const N: usize> Path<'a, L, N> {
    /// The path of drive number `drive` over `range`, with the other drives held at `held`. The
    /// mechanism is driven there from the configuration `start` at `held`.
    ///
    /// # Errors
    ///
    /// [`OutOfReach`] if the mechanism cannot be driven through the range.
    pub fn new(
        model: &'a L,
        start: &Motion<f64, N>,
        held: L::Drives,
        drive: usize,
        range: [f64; 2],
        points: RequestedPoints,
    ) -> Result<Self, OutOfReach> {
        let way = Way {
            driven: Driven::new(model, points),
            held,
            drive,
        };
        let now = held.values().nth(drive).unwrap_or_default();
        let anchors = Anchors::new(range, (now, *start), |ends, motion| {
            way.follow(ends, motion)
        })?;
        Ok(Self { way, anchors })
    }
}

impl<L: Suspension<N>, const N: usize> Way<'_, L, N> {
    fn follow(&self, [from, to]: [f64; 2], motion: &mut Motion<f64, N>) -> Result<(), Stop> {
        let ends = [from, to].map(|at| self.held.with(self.drive, at));
        let followed = self.driven.follow([&ends[0], &ends[1]], motion);
        followed.map_err(|stopped| {
            let reached = from + (to - from) * stopped.reached;
            (reached, stopped.refused.map(|(_, cause)| cause))
        })
    }
}

impl<L: Suspension<N>, const N: usize> Exact for Path<'_, L, N> {
    fn outputs(&self) -> Vec<Output> {
        self.way.driven.outputs()
    }

    fn at(&self, at: f64) -> Result<Vec<Derivatives>, OutOfReach> {
        let Way {
            driven,
            held,
            drive,
        } = &self.way;
        let follow = |ends, motion: &mut _| self.way.follow(ends, motion);
        let motion = self.anchors.led_to(at, follow)?;
        let unit = L::Drives::default().with(*drive, 1.0);
        let read = driven.derivatives(&motion, held.with(*drive, at), [unit]);
        let [along] = read.map_err(|cause| OutOfReach {
            reached: [at; 2],
            cause: Some(cause),
        })?;
        Ok(along)
    }
}

//! Configurations evenly over a range, from which the others of it are reached.

use crate::bake::exact::{OutOfReach, Stop};

const COUNT: u32 = 65;

/// Configurations, each with the value that leads there.
#[derive(Clone, Debug)]
pub(super) struct Anchors<S>(Vec<(f64, S)>);

impl<S: Copy> Anchors<S> {
    /// The anchors of a range, to which the mechanism is led from `now`. `follow` leads from one value to another.
    pub(super) fn new(
        [from, to]: [f64; 2],
        (now, start): (f64, S),
        follow: impl Fn([f64; 2], &mut S) -> Result<(), Stop>,
    ) -> Result<Self, OutOfReach> {
        let [mut first, mut last] = [start; 2];
        let ways = [
            follow([now, from], &mut first),
            follow([now, to], &mut last),
        ];
        if let Some((_, cause)) = ways.iter().find_map(|way| way.err()) {
            let [down, up] = ways.map(|way| way.err().map(|(reached, _)| reached));
            let reached = [down.unwrap_or(from), up.unwrap_or(to)];
            return Err(OutOfReach { reached, cause });
        }
        let (mut at, mut configuration) = (from, first);
        let mut anchors = Vec::new();
        for part in 0..COUNT {
            let next = from + (to - from) * f64::from(part) / f64::from(COUNT - 1);
            let followed = follow([at, next], &mut configuration);
            followed.map_err(|stop| OutOfReach::from_stop(at, stop))?;
            anchors.push((next, configuration));
            at = next;
        }
        Ok(Self(anchors))
    }

    /// The configuration at a value, led there from the nearest anchor.
    pub(super) fn led_to(
        &self,
        at: f64,
        follow: impl Fn([f64; 2], &mut S) -> Result<(), Stop>,
    ) -> Result<S, OutOfReach> {
        let distance = |(from, _): &&(f64, S)| (from - at).abs();
        let anchors = self.0.iter();
        let nearest = anchors.min_by(|a, b| distance(a).total_cmp(&distance(b)));
        let (from, mut configuration) = *nearest.unwrap_or(&self.0[0]);
        let followed = follow([from, at], &mut configuration);
        followed.map_err(|stop| OutOfReach::from_stop(from, stop))?;
        Ok(configuration)
    }
}

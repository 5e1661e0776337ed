//! A motion along two drives.

use crate::bake::{BakedSurface, Continuity, MOST_PATCHES, UnmetSurface, WantedSurface};
use crate::commands::bake::baking::{Baking, Variable};
use crate::failure::Failure;
use crate::mechanism::advice;
use crate::number::{number, rounded};

impl Baking<'_> {
    pub(super) fn surface(&self, along: [&Variable; 2]) -> Result<BakedSurface, Failure> {
        if self.continuity == Continuity::Acceleration {
            return Err(self.refuse("over two drives --continuity is 0 or 1"));
        }
        let metre = self.mechanism.unit.metre();
        let wanted = WantedSurface {
            drives: along.map(|along| along.drive),
            ranges: along.map(|along| along.local),
            tolerance: self.tolerance * metre,
            metre,
            smooth: self.continuity == Continuity::Velocity,
            points: self.points,
        };
        let baked = self.mechanism.bake_surface(&wanted, self.interrupted);
        let baked = baked.map_err(|unmet| self.unmet_surface(along, &unmet))?;
        let ranges = along.map(|along| along.range);
        Ok(baked.moved(self.mechanism.origin.into(), ranges))
    }

    fn unmet_surface(&self, along: [&Variable; 2], unmet: &UnmetSurface) -> Failure {
        let ranges = along.map(|along| {
            let [from, to] = along.local.map(|end| number(self.in_file(along, end)));
            let symbol = self.dimension(along).symbol(self.mechanism.unit);
            format!("{} = {from} to {to} {symbol}", self.name(along))
        });
        let reason = match unmet {
            UnmetSurface::Interrupted => return Failure::nothing_written(self.file),
            UnmetSurface::OutOfReach { drives, cause } => {
                let place = along.iter().zip(drives);
                let place = place.map(|(along, local)| self.in_words(along, *local));
                let place = place.collect::<Vec<_>>().join(", ");
                let cause = self.cause(*cause);
                let advice = advice(self.file);
                format!("the mechanism does not reach {place}{cause}; {advice}")
            }
            UnmetSurface::TooManyPatches => format!(
                "{MOST_PATCHES} patches do not meet {} m; take a larger --tolerance or shorter ranges",
                rounded(self.tolerance, 3)
            ),
        };
        Failure::Solver(format!(
            "{}: {} cannot be baked: {reason}",
            self.file,
            ranges.join(", ")
        ))
    }
}

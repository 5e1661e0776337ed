//! A motion along two drives.

use crate::bake::surface::MOST_PATCHES;
use crate::bake::{BakedSurface, Continuity, UnmetSurface, WantedSurface};
use crate::commands::bake::request::{Along, Baking, interrupted};
use crate::failure::Failure;
use crate::file::Dimension;
use crate::mechanism::{Drive, advice};
use crate::number::{number, rounded};

impl Baking<'_> {
    pub(super) fn surface(&self, along: [&Along; 2]) -> Result<BakedSurface, Failure> {
        if self.request.continuity == Continuity::Acceleration {
            return Err(self.refuse("over two drives --continuity is 0 or 1"));
        }
        let metre = self.mechanism.unit.metre();
        let wanted = WantedSurface {
            drives: along.map(|along| along.drive),
            ranges: along.map(|along| along.local),
            tolerance: self.request.tolerance * metre,
            metre,
            smooth: self.request.continuity == Continuity::Velocity,
            wish: self.request.wish,
        };
        let baked = self.mechanism.bake_surface(&wanted, self.interrupted);
        let baked = baked.map_err(|unmet| self.unmet(along, &unmet))?;
        let ranges = along.map(|along| along.range);
        Ok(baked.moved(self.mechanism.origin.into(), ranges))
    }

    fn unmet(&self, along: [&Along; 2], unmet: &UnmetSurface) -> Failure {
        let ranges = along.map(|Along { drive, local, .. }| {
            let (Drive { name, kind }, unit) =
                (&self.mechanism.names.drives[*drive], self.mechanism.unit);
            let dimension = Dimension::from(*kind);
            let [from, to] =
                local.map(|end| number(self.given(*drive, end) * dimension.file_factor(unit)));
            format!("{name} = {from} to {to} {}", dimension.symbol(unit))
        });
        let reason = match unmet {
            UnmetSurface::Interrupted => return interrupted(self.file),
            UnmetSurface::OutOfReach { drives, cause } => {
                let place = along.iter().zip(drives).map(|(along, local)| {
                    self.in_words(along.drive, self.given(along.drive, *local))
                });
                let place = place.collect::<Vec<_>>().join(", ");
                let cause = cause.map(|cause| format!(" ({})", self.mechanism.names.cause(&cause)));
                format!(
                    "the mechanism does not reach {place}{}; {}",
                    cause.unwrap_or_default(),
                    advice(self.file)
                )
            }
            UnmetSurface::TooManyPatches => format!(
                "{MOST_PATCHES} patches do not meet {} m; take a larger --tolerance or shorter ranges",
                rounded(self.request.tolerance, 3)
            ),
        };
        Failure::Solver(format!(
            "{}: {} cannot be baked: {reason}",
            self.file,
            ranges.join(", ")
        ))
    }
}

//! What a user of the command line orders, carried out on a mechanism.

use std::f64::consts::PI;

use suspension_core::{DriveKind, Inputs, Named, Still, Values};

use crate::bake::driven::Wish;
use crate::bake::fit::{Baked, MOST_SEGMENTS, Unmet, Wanted, bake};
use crate::bake::path::{OutOfReach, Path};
use crate::bake::scheme::Continuity;
use crate::bake::source::Sheet;
use crate::bake::widest::widest;
use crate::failure::Failure;
use crate::input::drives::unit_of;
use crate::input::instants::Instants;
use crate::number::{exact, number, rounded};
use crate::study::{Assembled, Suspension, cause};

/// An order: what to bake of the mechanism of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// The drive; `None` where there is only one.
    pub drive: Option<String>,
    /// The drive's first and last value; the ends of the file's motion where not given.
    pub range: [Option<f64>; 2],
    /// How far a point may be off, m.
    pub tolerance: f64,
    /// How segments join.
    pub continuity: Continuity,
    /// Which points.
    pub wish: Wish,
}

/// A mechanism and its file.
pub(crate) struct Ordered<'a, L: Suspension<N>, const N: usize> {
    pub(crate) file: &'a str,
    pub(crate) assembled: &'a Assembled<L, N>,
    pub(crate) instants: &'a Instants,
    pub(crate) order: &'a Order,
}

impl<L: Suspension<N>, const N: usize> Ordered<'_, L, N> {
    /// Bakes.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where drive, range or tolerance make no sense, [`Failure::Solver`] where
    /// the mechanism does not go through the range or the tolerance is not met.
    pub(crate) fn sheet(&self) -> Result<Sheet, Failure> {
        let Assembled { linkage, unit, .. } = *self.assembled;
        let names = <L::Drives as Named<f64>>::NAMES;
        let drive = self.drive()?;
        let metre = unit.metre();
        let range = self.range(drive)?;
        let offset = self.assembled.drive_offset(drive);
        let wanted = Wanted {
            range: range.map(|end| end - offset),
            tolerance: self.order.tolerance * metre,
            metre,
            continuity: self.order.continuity,
        };
        if !(wanted.tolerance > 0.0 && wanted.tolerance.is_finite()) {
            return Err(self.refuse("a tolerance is a positive number of metres"));
        }
        let others = (0..names.len()).filter(|other| *other != drive);
        let held = others
            .map(|other| {
                let value = exact(self.given(other, self.first(other)));
                format!("{} = {value} {}", names[other], self.unit_of(other))
            })
            .collect::<Vec<_>>();
        Ok(Sheet {
            baked: self
                .bake(drive, &wanted)?
                .moved(self.assembled.origin.position().into(), range),
            file: self.file.to_owned(),
            linkage: linkage.to_owned(),
            drive: names[drive].to_owned(),
            drive_unit: self.unit_of(drive),
            unit: unit.symbol(),
            held: held.join(", "),
        })
    }

    fn drive(&self) -> Result<usize, Failure> {
        let names = <L::Drives as Named<f64>>::NAMES;
        let all = names.join(", ");
        match (&self.order.drive, names) {
            (None, [_]) => Ok(0),
            (None, _) => Err(self.refuse(&format!("--drive must say which: {all}"))),
            (Some(wanted), _) => names
                .iter()
                .position(|name| name == wanted)
                .ok_or_else(|| self.refuse(&format!("unknown drive `{wanted}`; known are {all}"))),
        }
    }

    fn range(&self, drive: usize) -> Result<[f64; 2], Failure> {
        let times = self.instants.iter();
        let through = times.map(|t| self.given(drive, self.value(drive, t)));
        let (low, high) = through.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
            (low.min(value), high.max(value))
        });
        let [from, to] = self.order.range;
        let range = [from.unwrap_or(low), to.unwrap_or(high)];
        let in_words = range.map(|end| self.in_words(drive, end)).join(" to ");
        if !(range[0] < range[1] && range.iter().all(|end| end.is_finite())) {
            return Err(self.refuse(&format!(
                "{in_words} is no range; --from must be less than --to"
            )));
        }
        let angle = self.assembled.model.drive_kind(drive) == DriveKind::Angle;
        if angle && !(0.0 <= range[0] && range[1] <= PI) {
            return Err(self.refuse(&format!(
                "{in_words}: the angle of a link from an axis lies between 0 and pi"
            )));
        }
        Ok(range)
    }

    fn bake(&self, drive: usize, wanted: &Wanted) -> Result<Baked, Failure> {
        let path = self.path(drive, wanted.range);
        let (reason, inside) = match path {
            Ok(path) => match bake(wanted, &path) {
                Ok(baked) => return Ok(baked),
                Err(Unmet::OutOfReach(error)) => (self.out_of_reach(drive, &error), error.reached),
                Err(Unmet::TooManySegments { at }) => (
                    format!(
                        "{MOST_SEGMENTS} segments do not meet {} m about {}",
                        rounded(self.order.tolerance, 3),
                        self.in_words(drive, self.given(drive, at))
                    ),
                    wanted.range,
                ),
            },
            Err(error) => (self.out_of_reach(drive, &error), error.reached),
        };
        let possible = self.possible(
            drive,
            &Wanted {
                range: inside,
                ..*wanted
            },
        );
        let [from, to] = wanted.range.map(|end| number(self.given(drive, end)));
        let advice = possible.map_or_else(
            || "no part of the range can be baked".to_owned(),
            |[from, to]| format!("possible is --from {} --to {}", number(from), number(to)),
        );
        let name = <L::Drives as Named<f64>>::NAMES[drive];
        Err(Failure::Solver(format!(
            "{}: {name} cannot be baked from {from} to {to}: {reason}; {advice}",
            self.file
        )))
    }

    /// The part of a range that can be baked, in a few digits and the file's coordinates.
    fn possible(&self, drive: usize, wanted: &Wanted) -> Option<[f64; 2]> {
        /// Of a range: how close to a turning point the mechanism is solved.
        const CLOSE: f64 = 1e-6;
        let [from, to] = wanted.range;
        let range = [from + CLOSE * (to - from), to - CLOSE * (to - from)];
        let path = self.path(drive, range).ok()?;
        let widest = widest(&Wanted { range, ..*wanted }, &path).ok()??;
        let [from, to] = widest.map(|end| self.given(drive, end));
        let steps_a_unit = 10_f64.powf(3.0 - (to - from).log10().floor());
        let (from, to) = (from * steps_a_unit, to * steps_a_unit);
        Some([from.ceil(), to.floor()].map(|end| end / steps_a_unit))
    }

    fn path(&self, drive: usize, range: [f64; 2]) -> Result<Path<'_, L, N>, OutOfReach> {
        let Assembled { model, start, .. } = self.assembled;
        let held = L::Drives::from_values((0..).map(|drive| self.first(drive)));
        Path::new(model, start, held, drive, range, self.order.wish)
    }

    fn out_of_reach(&self, drive: usize, error: &OutOfReach) -> String {
        let [from, to] = error.reached.map(|end| number(self.given(drive, end)));
        let why = error
            .cause
            .map(|error| format!(" ({})", cause::<L, N>(&error, self.assembled.unit)));
        let name = <L::Drives as Named<f64>>::NAMES[drive];
        format!(
            "the mechanism takes {name} from {from} to {to} only{}",
            why.unwrap_or_default()
        )
    }

    /// A drive's value in the file's coordinates, from a local one.
    fn given(&self, drive: usize, local: f64) -> f64 {
        local + self.assembled.drive_offset(drive)
    }

    /// A drive's local value at the first instant.
    fn first(&self, drive: usize) -> f64 {
        self.value(drive, self.instants.ends()[0])
    }

    fn value(&self, drive: usize, t: f64) -> f64 {
        let inputs: Inputs<Still, L::Drives> = self.assembled.drives.inputs(t);
        inputs.drives.value.values().nth(drive).unwrap_or_default()
    }

    fn in_words(&self, drive: usize, value: f64) -> String {
        let name = <L::Drives as Named<f64>>::NAMES[drive];
        format!("{name} = {} {}", number(value), self.unit_of(drive))
    }

    fn unit_of(&self, drive: usize) -> &'static str {
        unit_of(self.assembled.model.drive_kind(drive), self.assembled.unit)
    }

    fn refuse(&self, message: &str) -> Failure {
        Failure::Input(format!("{}: {message}", self.file))
    }
}

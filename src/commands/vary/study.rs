//! The study: the suspension at each value of what is varied.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::characteristics::{
    Curves, DesignNumber, Rise, Span, all_curves, check_spans, columns, mode_states, parameters,
};
use crate::commands::vary::varied::{Varied, label};
use crate::failure::Failure;
use crate::kinematics::{Kinematics, Unbuilt};
use crate::mechanism::listed;
use crate::number::without_rounding;
use crate::output::notes::{print_notes, print_unmet_range};
use crate::output::progress::Progress;
use crate::quantities::Column;
use crate::sensitivities::design_values;

/// Smaller differences are rounding, absolute or relative to a larger number.
pub(super) const ROUNDING: f64 = 1e-9;

/// The most values of which the page has curves, but for the last and the design: more are no clearer, and make the page slow.
const MOST_DRAWN: usize = 100;

/// The suspension at a value.
pub(super) struct Variant {
    /// The change from the design, in the unit of the file; zero for the design itself.
    pub(super) value: f64,
    /// For each column its value at the design position, and its derivatives with respect to each drive.
    pub(super) numbers: Vec<Vec<f64>>,
    /// Curves over travel and steering, if they are asked for and the page shows those of this value.
    pub(super) curves: Vec<Curves>,
}

impl Variant {
    /// Returns a number in its printed unit; NaN if there is none.
    pub(super) fn shown(&self, number: &DesignNumber) -> f64 {
        let of_column = self.numbers.get(number.column);
        let value = of_column.and_then(|numbers| numbers.get(number.number));
        value.map_or(f64::NAN, |value| value * number.scale)
    }
}

/// The suspension at all values.
pub(super) struct Study {
    pub(super) columns: Vec<Column>,
    pub(super) variants: Vec<Variant>,
    /// Of how many values one has curves, beside the first, the last and the design.
    pub(super) stride: usize,
    /// The values with which there is no suspension.
    unbuilt: Vec<(f64, Unbuilt)>,
    /// Sentences on curves that end before the range does.
    pub(super) cut_short: Vec<String>,
    /// The failure to report of them.
    locked: Option<Failure>,
    /// The number of values that an interrupt left out.
    left_out: usize,
}

/// The ranges of travel and steering of the curves.
pub(super) type Spans = [Option<Span>; 2];

impl Study {
    /// Computes the suspension at each of the `values`, with curves if their ranges are given. An interrupt ends the work.
    pub(super) fn compute(
        varied: &Varied<'_>,
        values: &[f64],
        spans: Option<Spans>,
        interrupted: &AtomicBool,
    ) -> Result<Self, Failure> {
        let mut study = Self {
            columns: columns(varied.mechanism),
            variants: Vec::new(),
            stride: values.len().div_ceil(MOST_DRAWN).max(1),
            unbuilt: Vec::new(),
            cut_short: Vec::new(),
            locked: None,
            left_out: 0,
        };
        if let Some(spans) = spans {
            let unit = varied.mechanism.unit;
            print_notes(check_spans(varied.mechanism, varied.file, spans, unit)?);
        }
        let mut progress = Progress::new(values.len(), "values");
        for (done, value) in values.iter().enumerate() {
            let is_drawn = done % study.stride == 0 || done + 1 == values.len() || *value == 0.0;
            study.add(varied, *value, spans.filter(|_| is_drawn), interrupted);
            if interrupted.load(Ordering::Relaxed) {
                study.variants.truncate(done);
                study.left_out = values.len() - done;
                break;
            }
            progress.step();
        }
        Ok(study)
    }

    /// Adds the suspension at a value.
    fn add(
        &mut self,
        varied: &Varied<'_>,
        value: f64,
        spans: Option<Spans>,
        interrupted: &AtomicBool,
    ) {
        let design = varied.mechanism;
        if value == 0.0 {
            return self.add_built(varied, (value, design), spans, interrupted);
        }
        match design.changed(&varied.change.per_unit.times(value)) {
            Ok(built) => self.add_built(varied, (value, &*built), spans, interrupted),
            Err(why) => self.unbuilt.push((value, why)),
        }
    }

    fn add_built(
        &mut self,
        varied: &Varied<'_>,
        (value, mechanism): (f64, &dyn Kinematics),
        spans: Option<Spans>,
        interrupted: &AtomicBool,
    ) {
        let numbers = design_values(mechanism, &self.columns).unwrap_or_default();
        let mut curves = Vec::new();
        if let Some(spans) = spans {
            let unit = mechanism.unit;
            let mut modes = mode_states(mechanism, spans, unit, interrupted);
            let rises = Rise::of_drives(mechanism, &parameters(mechanism, unit), unit);
            curves = all_curves(mechanism, &modes, &rises);
            let failures = modes
                .iter()
                .filter_map(|mode| mode.visited.failure(varied.file));
            let failures = failures.map(|failure| varied.with_value(value, failure).to_string());
            let cut_short: Vec<String> = failures.collect();
            // That a usual range is longer than the reach is stated once, not for each value.
            modes.retain(|mode| self.cut_short.is_empty() || !mode.is_usual);
            let locked = || print_unmet_range(&modes, varied.file);
            let locked = || locked().map(|failure| varied.with_value(value, failure));
            self.locked = self.locked.take().or_else(locked);
            self.cut_short.extend(cut_short);
        }
        self.variants.push(Variant {
            value,
            numbers,
            curves,
        });
    }

    /// Returns the variants with curves.
    pub(super) fn drawn(&self) -> Vec<&Variant> {
        let variants = self.variants.iter();
        variants
            .filter(|variant| !variant.curves.is_empty())
            .collect()
    }

    /// Returns whether a number has a value in one of the variants.
    pub(super) fn has_value(&self, number: &DesignNumber) -> bool {
        let mut variants = self.variants.iter();
        variants.any(|variant| variant.shown(number).is_finite())
    }

    /// Returns whether a number is other than zero in one of the variants.
    pub(super) fn is_not_zero(&self, number: &DesignNumber) -> bool {
        let mut variants = self.variants.iter();
        variants.any(|variant| without_rounding(variant.shown(number)) != 0.0)
    }

    /// The numbers of the design, if it is among the variants.
    pub(super) fn design(&self) -> Option<&Variant> {
        self.variants.iter().find(|variant| variant.value == 0.0)
    }

    /// Returns whether all variants have the numbers of the design, and there are others.
    pub(super) fn changes_nothing(&self) -> bool {
        let Some(design) = self.design().filter(|_| self.variants.len() > 1) else {
            return false;
        };
        let is_same = |(a, b): (&f64, &f64)| {
            (a.is_nan() && b.is_nan()) || (a - b).abs() <= ROUNDING * a.abs().max(1.0)
        };
        let flat = |variant: &Variant| variant.numbers.concat();
        let same = |other: &Variant| flat(design).iter().zip(&flat(other)).all(is_same);
        self.variants.iter().all(same)
    }

    /// Says with which values there is no suspension, and why; `None` if there is one with all.
    pub(super) fn describe_unbuilt(&self, varied: &Varied<'_>) -> Option<String> {
        /// The most values that are named.
        const MOST_NAMED: usize = 8;
        let (first, why) = self.unbuilt.first()?;
        let values = self.unbuilt.iter().map(|(value, _)| label(*value));
        let values = match self.unbuilt.len() {
            ..=MOST_NAMED => listed(values),
            count => {
                let more = format!("{} more", count - MOST_NAMED);
                listed(values.take(MOST_NAMED).chain([more]))
            }
        };
        let at = match self.unbuilt.len() {
            1 => String::new(),
            _ => format!("at {}: ", label(*first)),
        };
        Some(format!(
            "no suspension can be assembled with {} {values} {} from the design: {at}{}",
            varied.change.name,
            varied.mechanism.unit.symbol(),
            why.in_words(&varied.mechanism.names)
        ))
    }

    /// Says how many values an interrupt left out; `None` if it left out none.
    pub(super) fn describe_interrupt(&self) -> Option<String> {
        let left_out = self.left_out;
        (left_out > 0)
            .then(|| format!("interrupted; the last {left_out} of the values are left out"))
    }

    /// Returns the failure of a study of which a part is missing.
    pub(super) fn failure(self, varied: &Varied<'_>) -> Option<Failure> {
        let file = varied.file;
        if let Some(interrupt) = self.describe_interrupt() {
            return Some(Failure::Interrupted(format!("{file}: {interrupt}")));
        }
        let unbuilt = self.describe_unbuilt(varied);
        let unbuilt = unbuilt.map(|why| format!("{file}: {why}"));
        match (unbuilt, self.locked) {
            (None, locked) => locked,
            (Some(unbuilt), None) => Some(Failure::Solver(unbuilt)),
            (Some(unbuilt), Some(locked)) => Some(Failure::Solver(format!("{unbuilt}\n{locked}"))),
        }
    }
}

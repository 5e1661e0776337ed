//! Logarithmic axes.

/// The gap between an end and the first value, in decades, so that the frame does not cut points.
const MARGIN: f64 = 0.08;

/// A logarithmic axis of a figure: whole decades between two places of the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// Exponents of ten at its ends.
    decades: [i32; 2],
    /// The places of its ends in the drawing.
    places: [f64; 2],
}

impl Axis {
    /// Makes an axis of whole decades that contains the values, all of which are positive and finite.
    pub fn around(values: impl Iterator<Item = f64>, places: [f64; 2]) -> Self {
        let ends = values.map(f64::log10).fold(None, |ends, exponent| {
            let (low, high) = ends.unwrap_or((exponent, exponent));
            Some((exponent.min(low), exponent.max(high)))
        });
        let (low, high) = ends.unwrap_or_default();
        let low = (low - MARGIN).floor() as i32;
        let high = (high + MARGIN).ceil() as i32;
        Self::between([low, high], places)
    }

    /// Makes an axis between two powers of ten.
    pub fn between([low, high]: [i32; 2], places: [f64; 2]) -> Self {
        Self {
            decades: [low, high.max(low + 1)],
            places,
        }
    }

    /// Returns the place of a value in the drawing.
    pub fn place(&self, value: f64) -> f64 {
        let [low, high] = self.decades.map(f64::from);
        let [from, to] = self.places;
        from + (value.log10() - low) / (high - low) * (to - from)
    }

    /// Decades: exponent and place.
    pub fn decades(&self) -> impl Iterator<Item = (i32, f64)> {
        let [low, high] = self.decades;
        let axis = *self;
        (low..=high).map(move |exponent| (exponent, axis.place(10_f64.powi(exponent))))
    }

    /// Places of two to nine in each decade.
    pub fn minor(&self) -> impl Iterator<Item = f64> {
        let [low, high] = self.decades;
        let axis = *self;
        (low..high).flat_map(move |exponent| {
            (2..10).map(move |k| axis.place(f64::from(k) * 10_f64.powi(exponent)))
        })
    }
}

/// A power of ten as a time: `10 ns`, `1 µs`.
pub fn nanoseconds(exponent: i32) -> String {
    let (unit, base) = match exponent {
        ..3 => ("ns", 0),
        3..6 => ("µs", 3),
        6..9 => ("ms", 6),
        _ => ("s", 9),
    };
    format!("{} {unit}", 10_f64.powi(exponent - base))
}

/// A power of ten: `10⁻¹⁵`.
pub fn power(exponent: i32) -> String {
    let digits = exponent.to_string();
    let raised = digits.chars().map(|digit| match digit.to_digit(10) {
        Some(digit) => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit as usize],
        None => '⁻',
    });
    format!("10{}", raised.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_axis_spans_the_decades_around_its_values() {
        let axis = Axis::around([3.0, 250.0].into_iter(), [0.0, 300.0]);
        let decades: Vec<_> = axis.decades().collect();
        assert_eq!(decades, [(0, 0.0), (1, 100.0), (2, 200.0), (3, 300.0)]);
        assert_eq!(axis.minor().count(), 24);
    }

    #[test]
    fn decades_are_labelled_with_units_or_powers_of_ten() {
        assert_eq!(nanoseconds(1), "10 ns");
        assert_eq!(nanoseconds(5), "100 µs");
        assert_eq!(nanoseconds(-1), "0.1 ns");
        assert_eq!(power(-15), "10⁻¹⁵");
    }
}

//! Numbers in messages.

/// Formats a time, a length or a drive's value with six significant digits.
pub fn number(value: f64) -> String {
    rounded(value, 6)
}

/// Formats a number with the digits needed to read back the same number.
pub fn exact(value: f64) -> String {
    rounded(value, 17)
}

/// Formats a number with `decimals` decimals; -0 becomes 0.
pub fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// Returns the number, or zero if it is no more than rounding: of coordinates in millimetres, as of a long car, too.
pub fn without_rounding(value: f64) -> f64 {
    const ROUNDING: f64 = 1e-11;
    if value.abs() < ROUNDING { 0.0 } else { value }
}

/// Returns the number, zero without a sign.
pub fn unsigned_zero(value: f64) -> f64 {
    value + 0.0
}

/// Formats a count, for example `1 segment` and `2 segments`.
pub fn counted(count: usize, thing: &str) -> String {
    let ending = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{ending}")
}

/// Aligns numbers at their decimal points, with `space` as wide as a digit and `point` as wide as a decimal point.
pub fn aligned(numbers: Vec<String>, [space, point]: [char; 2]) -> Vec<String> {
    let count = |text: &str| text.chars().count();
    let whole = |number: &String| count(number.split('.').next().unwrap_or_default());
    let widest = |width: &dyn Fn(&String) -> usize| numbers.iter().map(width).max().unwrap_or(0);
    let before = widest(&whole);
    let behind = widest(&|number| count(number) - whole(number));
    let spaces = |count: usize| space.to_string().repeat(count);
    let padded = |number: &String| {
        let fraction = count(number) - whole(number);
        let left = spaces(before - whole(number));
        let right = match fraction {
            0 if behind > 0 => format!("{point}{}", spaces(behind - 1)),
            _ => spaces(behind - fraction),
        };
        format!("{left}{number}{right}")
    };
    numbers.iter().map(padded).collect()
}

/// Formats a number with at most `digits` significant digits and at least one, with an exponent if plain digits would not
/// show them.
pub fn rounded(value: f64, digits: usize) -> String {
    let places = digits.saturating_sub(1);
    // The shortest digits of a rounded number are those to which it was rounded.
    let value = format!("{value:.places$e}").parse().unwrap_or(value);
    let value = unsigned_zero(value);
    let plain = 1e-4..10_f64.powi(digits as i32);
    if value == 0.0 || plain.contains(&value.abs()) {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_printed_with_up_to_six_digits() {
        for (value, expected) in [
            (0.025948799999999998, "0.0259488"),
            (1.978_367_769_180_123, "1.97837"),
            (-0.071_234_567, "-0.0712346"),
            (-2.0, "-2"),
            (0.0, "0"),
            (-0.0, "0"),
            (445.872, "445.872"),
            (1e300, "1e300"),
            (1.5e-5, "1.5e-5"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(value), expected);
        }
    }

    /// Rounding of a coordinate of 2600 mm is 5e-13 mm, and several of them add up.
    #[test]
    fn rounding_of_millimetres_is_zero() {
        assert_eq!(number(without_rounding(-1.16957e-12)), "0");
        assert_eq!(number(without_rounding(1e-9)), "1e-9");
    }

    #[test]
    fn a_number_rounded_to_zero_is_printed_without_sign() {
        for (value, expected) in [
            (-1e-9, "0.00000"),
            (-0.0, "0.00000"),
            (-2e-5, "-0.00002"),
            (0.25, "0.25000"),
        ] {
            assert_eq!(fixed(value, 5), expected);
        }
    }

    #[test]
    fn a_count_of_one_is_printed_in_the_singular() {
        let counts = [0, 1, 2].map(|count| counted(count, "place"));
        assert_eq!(counts, ["0 places", "1 place", "2 places"]);
    }

    #[test]
    fn decimal_points_of_a_column_are_aligned() {
        let numbers = ["12.5", "-0.125", "3", "–", ""].map(str::to_owned);
        let expected = ["12.5  ", "-0.125", " 3_   ", " –_   ", "  _   "];
        let aligned = aligned(numbers.into(), [' ', '_']);
        assert_eq!(aligned, expected);
    }

    #[test]
    fn exact_numbers_are_printed_with_all_necessary_digits() {
        for value in [0.1 + 0.2, 2.150_312_5, 1.0 / 3.0, -7.25e-9, 1e300, 75.0] {
            assert_eq!(exact(value).parse(), Ok(value));
        }
        assert_eq!(exact(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(exact(75.0), "75");
    }

    #[test]
    fn rounded_numbers_are_printed_to_two_digits() {
        for (value, expected) in [
            (8.123e7, "8.1e7"),
            (41.26, "41"),
            (0.03271, "0.033"),
            (3.27e-9, "3.3e-9"),
        ] {
            assert_eq!(rounded(value, 2), expected);
        }
    }
}

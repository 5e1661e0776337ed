//! Numbers in messages.

/// A time, a length or a drive's value, to the digits that a limit of the motion is known to.
pub fn number(value: f64) -> String {
    rounded(value, 12)
}

/// To as many digits as it takes to read the same number.
pub fn exact(value: f64) -> String {
    rounded(value, 17)
}

/// To at most so many significant digits, at least one; with an exponent where plain digits
/// would not show them.
pub fn rounded(value: f64, digits: usize) -> String {
    let places = digits.saturating_sub(1);
    // The shortest digits of a rounded number are those that it was rounded to.
    let value = format!("{value:.places$e}").parse().unwrap_or(value);
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
    fn twelve_digits_and_no_more_than_it_takes() {
        for (value, expected) in [
            (0.025948799999999998, "0.0259488"),
            (1.978_367_769_180_123, "1.97836776918"),
            (-2.0, "-2"),
            (0.0, "0"),
            (445.872, "445.872"),
            (1e300, "1e300"),
            (1.5e-5, "1.5e-5"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(number(value), expected);
        }
    }

    #[test]
    fn as_many_digits_as_it_takes() {
        for value in [0.1 + 0.2, 2.150_312_5, 1.0 / 3.0, -7.25e-9, 1e300, 75.0] {
            assert_eq!(exact(value).parse(), Ok(value));
        }
        assert_eq!(exact(0.1 + 0.2), "0.30000000000000004");
        assert_eq!(exact(75.0), "75");
    }

    #[test]
    fn a_residual_to_two_digits() {
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

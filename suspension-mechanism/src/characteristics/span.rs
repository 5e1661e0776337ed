//! The range over which a drive is moved, from an option.

use std::str::FromStr;

/// A span from the design position, such as `-0.06:0.06`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span(pub [f64; 2]);

impl FromStr for Span {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.trim().parse().ok().filter(|x: &f64| x.is_finite());
        let ends = text.split_once(':');
        let ends = ends.and_then(|(from, to)| Some([number(from)?, number(to)?]));
        match ends {
            Some([from, to]) if from < to => Ok(Self([from, to])),
            Some(_) => Err("FROM must be less than TO, as in -0.06:0.06".to_owned()),
            None => Err("write FROM:TO, as -0.06:0.06 in m or -60:60 in mm".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_invalid_range_option_is_refused_with_the_reason() {
        assert_eq!("-0.03 : 0.04".parse(), Ok(Span([-0.03, 0.04])));
        for (text, expected) in [
            ("0.03", "write FROM:TO, as -0.06:0.06 in m or -60:60 in mm"),
            ("a:1", "write FROM:TO, as -0.06:0.06 in m or -60:60 in mm"),
            ("0:inf", "write FROM:TO, as -0.06:0.06 in m or -60:60 in mm"),
            ("0.03:-0.03", "FROM must be less than TO, as in -0.06:0.06"),
            ("0:0", "FROM must be less than TO, as in -0.06:0.06"),
        ] {
            assert_eq!(text.parse::<Span>(), Err(expected.to_owned()));
        }
    }
}

//! The range over which a drive is moved, from an option, and the places in it.

use std::str::FromStr;

use crate::mechanism::evenly_spaced;

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

/// `count` changes from the design position, evenly spaced from the first to the last, except that one of them is the design
/// position itself if this is between the ends: curves are read there, and cross zero where they count from it.
pub fn through_design([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let mut changes = evenly_spaced([from, to], count);
    if from < 0.0 && to > 0.0 {
        let inner = changes.iter_mut().skip(1).take(count.saturating_sub(2));
        if let Some(nearest) = inner.min_by(|a, b| a.abs().total_cmp(&b.abs())) {
            *nearest = 0.0;
        }
    }
    changes
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

    #[test]
    fn one_place_is_the_design_position_and_the_order_stays() {
        for ends in [[-80.0, 130.0], [-0.1, 50.0], [-50.0, 1e-9], [-60.0, 60.0]] {
            let changes = through_design(ends, 61);
            assert_eq!((changes.len(), [changes[0], changes[60]]), (61, ends));
            assert!(changes.contains(&0.0), "{changes:?}");
            assert!(changes.is_sorted_by(|a, b| a < b), "{changes:?}");
        }
        assert_eq!(
            through_design([10.0, 50.0], 61),
            evenly_spaced([10.0, 50.0], 61)
        );
    }
}

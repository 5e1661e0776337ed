//! The grid of drives that options ask for.

use std::str::FromStr;

use crate::failure::Failure;
use crate::file::Dimension;
use crate::kinematics::Kinematics;
use crate::mechanism::{
    CountedFrom, Description, DriveAtDesign, Grid, GridAxis, MOST_PLACES, Unit, evenly_spaced,
    extent,
};
use crate::output::notes::print_notes_on;

/// The name of what moves, a drive for example, and its values: `bump=-0.08:0.08:161`.
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    name: String,
    from: f64,
    to: f64,
    count: usize,
}

impl FromStr for Swept {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = "write NAME=FROM:TO:COUNT, as bump=-0.08:0.08:161, or NAME=VALUE";
        Self::parse(text, wanted)
    }
}

impl Swept {
    /// Parses a name with its values; `wanted` says what to write.
    ///
    /// # Errors
    ///
    /// A sentence on what is wrong.
    pub fn parse(text: &str, wanted: &str) -> Result<Self, String> {
        let (name, values) = text.split_once('=').ok_or(wanted)?;
        let number = |text: &str| {
            let number = text
                .trim()
                .parse()
                .ok()
                .filter(|value: &f64| value.is_finite());
            number.ok_or_else(|| format!("`{text}` is not a finite number; {wanted}"))
        };
        let (from, to, count) = match values.split(':').collect::<Vec<_>>().as_slice() {
            [value] => (number(value)?, number(value)?, 1),
            [from, to, count] => {
                let (first, last) = (number(from)?, number(to)?);
                let count = count.trim().parse().ok().filter(|count: &usize| *count > 1);
                let count = count.ok_or_else(|| {
                    format!("COUNT is a whole number, at least 2; one value is {name}={from}")
                })?;
                if count > MOST_PLACES {
                    return Err(format!(
                        "COUNT is {count}; at most {MOST_PLACES} are allowed"
                    ));
                }
                if first == last {
                    return Err(format!(
                        "FROM and TO are the same; one value is {name}={from}"
                    ));
                }
                (first, last, count)
            }
            _ => return Err(wanted.to_owned()),
        };
        Ok(Self {
            name: name.trim().to_owned(),
            from,
            to,
            count,
        })
    }

    /// Returns the name, or several names joined by commas.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the number of values.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the values in order.
    pub fn values(&self) -> Vec<f64> {
        evenly_spaced([self.from, self.to], self.count)
    }
}

/// Returns the grid that options describe, for the file `source`. Prints notes on doubtful values to standard error.
///
/// # Errors
///
/// [`Failure::Input`] if an option is wrong.
pub fn grid(
    mechanism: &dyn Kinematics,
    source: &str,
    swept: &[Swept],
    from: CountedFrom,
) -> Result<Grid, Failure> {
    let refuse = |message: String| Failure::input(source, message);
    let axes = axes(mechanism, swept, from).map_err(refuse)?;
    let doubts = doubts(mechanism, (swept, &axes), from);
    let grid = Grid::new(mechanism, axes, from).map_err(refuse)?;
    print_notes_on(source, doubts);
    Ok(grid)
}

/// Returns what the values of drives count from: their own zero with the option `--absolute`, else the design position.
pub fn counted_from(absolute: bool) -> CountedFrom {
    match absolute {
        true => CountedFrom::Zero,
        false => CountedFrom::Start,
    }
}

fn axes(
    mechanism: &Description,
    swept: &[Swept],
    from: CountedFrom,
) -> Result<Vec<GridAxis>, String> {
    let is_absolute = from == CountedFrom::Zero;
    let mut axes: Vec<GridAxis> = Vec::new();
    for of_one in swept {
        let axis = GridAxis::named(mechanism, &of_one.name, &of_one.values(), &axes)?;
        let mut before = axes.iter().flat_map(|axis| &axis.drives);
        let again = before.find(|(drive, _)| axis.drives.iter().any(|(own, _)| own == drive));
        if let Some((drive, _)) = again.filter(|_| is_absolute) {
            let name = &mechanism.names.drives[*drive].name;
            return Err(format!(
                "the drive `{name}` is given twice, and --absolute states the drives' own values; leave --absolute out to add changes"
            ));
        }
        let opposite = axis.drives.iter().find(|(_, part)| *part < 0.0);
        if let Some((drive, _)) = opposite.filter(|_| is_absolute) {
            let name = &mechanism.names.drives[*drive].name;
            return Err(format!(
                "-{name} moves the opposite way from the design position, but --absolute states the drives' own values; leave --absolute out"
            ));
        }
        axes.push(axis);
    }
    Ok(axes)
}

/// Returns sentences on doubtful values of drives in options, each with its axis.
fn doubts(
    mechanism: &dyn Kinematics,
    (swept, axes): (&[Swept], &[GridAxis]),
    from: CountedFrom,
) -> Vec<String> {
    let of_one = |(of_one, axis): (&Swept, &GridAxis)| {
        let (drive, _) = axis.drives.first()?;
        let ends = [of_one.from.min(of_one.to), of_one.from.max(of_one.to)];
        doubt_of_option(mechanism, *drive, (ends, mechanism.unit), from)
    };
    let doubts = swept.iter().zip(axes).filter_map(of_one);
    doubts.map(|doubt| format!("--drive: {doubt}")).collect()
}

/// Returns a sentence if the range of a drive in a unit is doubtful with or without the option `--absolute`.
pub fn doubt_of_option(
    mechanism: &dyn Kinematics,
    drive: usize,
    range: ([f64; 2], Unit),
    from: CountedFrom,
) -> Option<String> {
    let way = match from {
        CountedFrom::Zero => "; leave out --absolute to state changes",
        CountedFrom::Start => "; use --absolute to state its own values",
    };
    doubt(mechanism, drive, range, from, way)
}

/// Returns a sentence if the range of a drive between `ends`, in the unit of the file that states it and counted `from`, is
/// doubtful; `way` says what to write instead.
pub fn doubt(
    mechanism: &dyn Kinematics,
    drive: usize,
    (ends, unit): ([f64; 2], Unit),
    from: CountedFrom,
    way: &str,
) -> Option<String> {
    let named = &mechanism.names.drives[drive];
    let dimension = Dimension::from(named.kind);
    let converted = |of: Dimension, number: f64| number * of.conversion(mechanism.unit, unit);
    let size = extent(mechanism.points()).norm();
    let at_design = DriveAtDesign {
        drive: named,
        design: converted(dimension, mechanism.design[drive]),
        size: converted(Dimension::Length, size),
        unit,
        seconds: 1.0,
    };
    let scale = unit.file_factor(dimension);
    at_design.doubt(ends.map(|end| end / scale), from, way)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn grid_values_are_evenly_spaced_and_exact_at_the_ends() {
        let swept: Swept = "bump=-0.08:0.08:161".parse().expect("a drive");
        let values = swept.values();
        assert_eq!((values[0], values[80], values[160]), (-0.08, 0.0, 0.08));
        assert_eq!(values[1], -0.079);
        for (text, place, expected) in [
            ("z=-0.006:0.006:5", 3, "0.003"),
            ("z=-0.3:0.6:4", 1, "0"),
            ("z=-0.06:0.06:121", 61, "0.001"),
            ("z=-60:60:121", 61, "1"),
            ("z=0:1e-300:3", 1, "5e-301"),
        ] {
            let swept: Swept = text.parse().expect("values");
            let expected: f64 = expected.parse().expect("a number");
            assert_eq!(
                swept.values()[place].to_bits(),
                expected.to_bits(),
                "{text}"
            );
        }
        let held: Swept = "steer = 0.01".parse().expect("a drive");
        assert_eq!((held.name.as_str(), held.values()), ("steer", vec![0.01]));
    }

    #[test]
    fn an_invalid_grid_is_refused_with_the_syntax_to_write() {
        for (text, expected) in [
            ("bump", "write NAME=FROM:TO:COUNT"),
            ("bump=1:2", "write NAME=FROM:TO:COUNT"),
            ("bump=a:2:3", "`a` is not a finite number"),
            (
                "bump=0:1:10000000000000",
                "COUNT is 10000000000000; at most 1000000 are allowed",
            ),
            ("bump=0:inf:3", "`inf` is not a finite number"),
            (
                "bump=0:0:1",
                "COUNT is a whole number, at least 2; one value is bump=0",
            ),
        ] {
            let refused = text.parse::<Swept>().expect_err(text);
            assert!(refused.contains(expected), "{refused}");
        }
    }
}

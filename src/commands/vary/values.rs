//! What is varied, and its values.

use std::str::FromStr;

use crate::grid::Swept;
use crate::kinematics::Kinematics;
use crate::mechanism::extent;
use crate::number::number;

/// The most values.
const MOST: usize = 1000;

/// A name with values, for example `rack.z=-0.006:0.006:5`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Values(Swept);

impl FromStr for Values {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = "write NAME=FROM:TO:COUNT, as rack.z=-0.006:0.006:5, or NAME=VALUE";
        let swept = Swept::parse(text, wanted)?;
        let count = swept.count();
        if count > MOST {
            return Err(format!(
                "COUNT is {count}; at most {MOST} are allowed, of which each has a column in the table"
            ));
        }
        if swept.values() == [0.0] {
            return Err(format!(
                "{}=0 is the design itself, from which the values count; {wanted}",
                swept.name()
            ));
        }
        Ok(Self(swept))
    }
}

impl Values {
    pub(super) fn name(&self) -> &str {
        self.0.name()
    }

    /// Returns the values with that of the design, in order.
    pub(super) fn with_design(&self) -> Vec<f64> {
        let mut values = self.0.values();
        if !values.contains(&0.0) {
            let is_rising = values.first() <= values.last();
            let place = values.partition_point(|value| (*value < 0.0) == is_rising);
            values.insert(place, 0.0);
        }
        values
    }

    /// Returns a note on values that seem to be in another unit.
    pub(super) fn doubt(&self, mechanism: &dyn Kinematics) -> Option<String> {
        let size = extent(mechanism.points()).norm();
        let values = self.0.values();
        let mut sizes = values.iter().map(|value| value.abs());
        let (unit, name) = (mechanism.unit.symbol(), self.name());
        let change = match values[..] {
            [from, .., to] => format!("from {} to {} {unit}", number(from), number(to)),
            _ => format!(
                "by {} {unit}",
                values.iter().copied().map(number).collect::<String>()
            ),
        };
        sizes.any(|value| value > size).then(|| {
            let size = number(size);
            format!("{name} changes {change}, more than the size of the suspension, {size} {unit}: is it in another unit?")
        })
    }
}

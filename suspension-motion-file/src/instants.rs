//! The instants of a motion.

/// Instants in seconds, in order, forwards or backwards.
#[derive(Clone, Debug, PartialEq)]
pub enum Instants {
    /// A list of instants.
    Listed(Vec<f64>),
    /// Evenly spaced instants.
    Even {
        /// The first instant.
        first: f64,
        /// The number of instants, at least one.
        count: usize,
        /// The last instant.
        last: f64,
    },
}

/// A stop this near to a multiple of the step is an instant; a part of the step.
const SLACK: f64 = 1e-6;

impl Instants {
    /// Returns the number of instants from `first` towards `stop` in steps of `step`. It may be infinite or NaN for extreme
    /// numbers.
    pub(crate) fn count_stepped(first: f64, stop: f64, step: f64) -> f64 {
        ((stop - first) / step + SLACK).floor() + 1.0
    }

    /// Makes the instants from `first` towards `stop` in steps of `step`, which is not zero and has the sign of the
    /// difference.
    pub fn stepped(first: f64, stop: f64, step: f64) -> Self {
        let steps = (stop - first) / step;
        let count = Self::count_stepped(first, stop, step);
        let whole = count - 1.0;
        let last = if (steps - whole).abs() <= SLACK {
            stop
        } else {
            first + whole * step
        };
        let count = count as usize;
        Self::Even { first, count, last }
    }

    /// Makes `count` instants, at least two, from `first` to `last`.
    pub fn dense(first: f64, last: f64, count: usize) -> Self {
        Self::Even { first, count, last }
    }

    /// Returns the number of instants.
    pub fn count(&self) -> usize {
        match self {
            Self::Listed(instants) => instants.len(),
            Self::Even { count, .. } => *count,
        }
    }

    /// Returns the first and the last instant.
    pub fn ends(&self) -> [f64; 2] {
        [0, self.count() - 1].map(|index| self.at(index))
    }

    /// Iterates over the instants.
    pub fn iter(&self) -> impl Iterator<Item = f64> {
        (0..self.count()).map(|index| self.at(index))
    }

    fn at(&self, index: usize) -> f64 {
        match self {
            Self::Listed(instants) => instants[index],
            Self::Even { count, last, .. } if index + 1 == *count => *last,
            // Interpolation has smaller rounding errors than multiples of the step, which is seldom an exact f64.
            Self::Even { first, count, last } => {
                first + (last - first) * index as f64 / (count - 1) as f64
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_at_a_multiple_of_the_step_is_met_exactly() {
        let instants = Instants::stepped(0.0, 1.95, 0.05);
        assert_eq!(instants.count(), 40);
        assert_eq!(instants.ends(), [0.0, 1.95]);
        assert_eq!(instants.iter().nth(3), Some(0.15));
    }

    #[test]
    fn instants_do_not_pass_a_stop_between_two_steps() {
        let instants = Instants::stepped(1.0, 0.0, -0.4);
        let all: Vec<f64> = instants.iter().collect();
        assert_eq!(all.len(), 3);
        assert!((all[2] - 0.2).abs() < 1e-15);
    }
}

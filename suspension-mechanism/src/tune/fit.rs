//! Least squares within boxes: Levenberg-Marquardt steps over the unknowns that their boxes do not hold,
//! cut where they leave the boxes. We found no library that has boxes and uses the `nalgebra` of this crate.

use std::sync::atomic::{AtomicBool, Ordering};

use nalgebra::{DMatrix, DVector};

/// The bounds of an unknown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    pub(super) least: f64,
    pub(super) greatest: f64,
}

impl Bounds {
    fn width(self) -> f64 {
        self.greatest - self.least
    }

    /// The end that is farther from a value.
    pub(super) fn farther_end(self, at: f64) -> f64 {
        if at - self.least < self.greatest - at {
            self.greatest
        } else {
            self.least
        }
    }

    /// Whether the unknown is at the bound that prevents it from reducing the sum of squares further.
    fn holds(self, at: f64, gradient: f64) -> bool {
        (at <= self.least && gradient > 0.0) || (at >= self.greatest && gradient < 0.0)
    }
}

pub(super) struct Fit {
    /// The place where the sum of squares is smallest; `None` if there are no residuals at the start.
    pub(super) at: Option<DVector<f64>>,
    /// Whether the user interrupted.
    pub(super) is_cut: bool,
}

/// The largest number of steps; a dozen are usual.
pub const MOST_STEPS: usize = 100;

/// The step of differences, as a fraction of a box.
const STEP: f64 = 1e-4;

/// The fraction of the residuals at the start up to which differences are rounding: over the whole box they would add
/// up to 5e-6 of the residuals.
const ROUNDING: f64 = 1e-9;

/// The fraction by which sums of squares must differ to count as different.
const SAME: f64 = 1e-9;

/// Minimizes the sum of squares of `residuals`, starting from [`start`]. If there are no residuals, nothing is
/// searched.
pub(super) fn fit(
    boxes: &[Bounds],
    residuals: impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
    interrupted: &AtomicBool,
    mut on_step: impl FnMut(),
) -> Fit {
    let start = start(boxes);
    let Some(first) = residuals(&start) else {
        return Fit {
            at: None,
            is_cut: false,
        };
    };
    let mut here = Here {
        at: start,
        rounding: ROUNDING * first.norm(),
        residuals: first,
        damping: 1e-3,
    };
    let mut is_cut = false;
    for _ in 0..MOST_STEPS {
        is_cut = interrupted.load(Ordering::Relaxed);
        if is_cut || !here.step(boxes, &residuals) {
            break;
        }
        on_step();
    }
    Fit {
        at: Some(here.at),
        is_cut,
    }
}

/// Zero, or the nearest value to it in the boxes.
pub(super) fn start(boxes: &[Bounds]) -> DVector<f64> {
    clamp_to_boxes(boxes, &DVector::zeros(boxes.len()))
}

struct Here {
    at: DVector<f64>,
    residuals: DVector<f64>,
    /// The size up to which differences mean nothing.
    rounding: f64,
    damping: f64,
}

impl Here {
    /// Makes one more step; `false` if nothing can be gained.
    fn step(
        &mut self,
        boxes: &[Bounds],
        residuals: &impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
    ) -> bool {
        const MOST_DAMPING: f64 = 1e12;
        let jacobian = self.jacobian(boxes, residuals);
        let gradient = jacobian.tr_mul(&self.residuals);
        let held =
            (0..boxes.len()).filter(|&each| boxes[each].holds(self.at[each], gradient[each]));
        let held: Vec<usize> = held.collect();
        let normal = jacobian.tr_mul(&jacobian);
        let before = self.residuals.norm_squared();
        while self.damping < MOST_DAMPING {
            let step = damped_step(&normal, &gradient, &held, self.damping);
            let at = clamp_to_boxes(boxes, &(&self.at + step));
            let trial = residuals(&at).filter(|trial| trial.norm_squared() < before);
            if let Some(trial) = trial {
                let gained = before - trial.norm_squared();
                (self.at, self.residuals) = (at, trial);
                self.damping *= 0.1;
                return gained > SAME * before;
            }
            self.damping *= 4.0;
        }
        false
    }

    /// The Jacobian by central differences; zero where these are only rounding, and where neighbours have no
    /// residuals.
    fn jacobian(
        &self,
        boxes: &[Bounds],
        residuals: &impl Fn(&DVector<f64>) -> Option<DVector<f64>>,
    ) -> DMatrix<f64> {
        let column = |(unknown, bounds): (usize, &Bounds)| {
            let step = STEP * bounds.width();
            let at = |sign: f64| {
                let mut at = self.at.clone();
                at[unknown] += sign * step;
                residuals(&at)
            };
            let difference = at(-1.0).zip(at(1.0));
            let difference = difference.map(|(before, behind)| behind - before);
            let difference = difference.filter(|difference| difference.norm() > self.rounding);
            difference.map_or_else(
                || DVector::zeros(self.residuals.len()),
                |difference| difference / (2.0 * step),
            )
        };
        let columns: Vec<DVector<f64>> = boxes.iter().enumerate().map(column).collect();
        DMatrix::from_columns(&columns)
    }
}

/// The step that minimizes the damped squares of the linear residuals, zero along what is held.
fn damped_step(
    normal: &DMatrix<f64>,
    gradient: &DVector<f64>,
    held: &[usize],
    damping: f64,
) -> DVector<f64> {
    let mut matrix = normal.clone();
    let mut right = -gradient;
    // Unknowns that nothing depends on stay where they are.
    let smallest = normal.diagonal().max() * 1e-12 + f64::MIN_POSITIVE;
    for each in 0..normal.nrows() {
        matrix[(each, each)] += damping * normal[(each, each)].max(smallest);
    }
    for &each in held {
        matrix.row_mut(each).fill(0.0);
        matrix.column_mut(each).fill(0.0);
        matrix[(each, each)] = 1.0;
        right[each] = 0.0;
    }
    let solution = matrix.cholesky().map(|factors| factors.solve(&right));
    solution.unwrap_or_else(|| DVector::zeros(gradient.len()))
}

fn clamp_to_boxes(boxes: &[Bounds], at: &DVector<f64>) -> DVector<f64> {
    let each = boxes.iter().zip(at.iter());
    let clamped = each.map(|(bounds, at)| at.clamp(bounds.least, bounds.greatest));
    DVector::from_vec(clamped.collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(boxes: &[Bounds], residuals: impl Fn(&DVector<f64>) -> Vec<f64>) -> DVector<f64> {
        let never = AtomicBool::new(false);
        let evaluate = |at: &DVector<f64>| Some(DVector::from_vec(residuals(at)));
        fit(boxes, evaluate, &never, || ()).at.expect("a fit")
    }

    fn square(half: f64) -> [Bounds; 2] {
        [Bounds {
            least: -half,
            greatest: half,
        }; 2]
    }

    /// Rosenbrock's valley, 1960: the least is at (1, 1), the way there is bent.
    #[test]
    fn a_minimum_inside_the_box_is_found() {
        let valley = |at: &DVector<f64>| vec![10.0 * (at[1] - at[0] * at[0]), 1.0 - at[0]];
        let at = found(&square(2.0), valley);
        assert!(
            (at[0] - 1.0).abs() < 1e-6 && (at[1] - 1.0).abs() < 1e-6,
            "{at}"
        );
    }

    /// On the side `x = 0.5` of the box Rosenbrock's valley is deepest at `y = x^2`.
    #[test]
    fn with_one_unknown_at_its_bound_the_others_reach_the_minimum() {
        let valley = |at: &DVector<f64>| vec![10.0 * (at[1] - at[0] * at[0]), 1.0 - at[0]];
        let at = found(&square(0.5), valley);
        assert!(
            (at[0] - 0.5).abs() < 1e-12 && (at[1] - 0.25).abs() < 1e-7,
            "{at}"
        );
    }

    #[test]
    fn an_unknown_without_influence_stays() {
        let at = found(&square(1.0), |at| vec![at[0] - 0.25]);
        assert!((at[0] - 0.25).abs() < 1e-9 && at[1] == 0.0, "{at}");
    }

    #[test]
    fn an_unknown_that_changes_rounding_alone_stays() {
        let rounded = |at: &DVector<f64>| vec![at[0] - 0.25, 3.0 + 1e-13 * (1e7 * at[1]).sin()];
        let at = found(&square(1.0), rounded);
        assert!((at[0] - 0.25).abs() < 1e-6 && at[1] == 0.0, "{at}");
    }

    /// There are no residuals beyond 0.7, as beyond a lock of a mechanism.
    #[test]
    fn a_minimum_is_found_beside_a_region_without_residuals() {
        let never = AtomicBool::new(false);
        let evaluate =
            |at: &DVector<f64>| (at[0] < 0.7).then(|| DVector::from_vec(vec![at[0] - 0.6]));
        let fit = fit(&square(1.0), evaluate, &never, || ());
        let at = fit.at.expect("a fit");
        assert!((at[0] - 0.6).abs() < 1e-6, "{at}");
    }
}

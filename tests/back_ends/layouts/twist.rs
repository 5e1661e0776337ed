//! The velocity of a rigid upright from its constraints: without the solver's equations.

use nalgebra::{SMatrix, SVector, Vector3};

use super::layout::{Layout, Pose};

/// The velocity at the origin, the angular velocity, and the pace at which an arm turns.
const SIZE: usize = 7;

/// Linear conditions on those.
#[derive(Default)]
pub(crate) struct Twist {
    rows: SMatrix<f64, SIZE, SIZE>,
    right: SVector<f64, SIZE>,
    count: usize,
}

impl Twist {
    /// The velocity of the upright at a point, along a direction, less `arm` times the arm's pace is `pace`.
    pub(crate) fn along(
        mut self,
        at: Vector3<f64>,
        direction: Vector3<f64>,
        arm: f64,
        pace: f64,
    ) -> Self {
        let mut row = self.rows.row_mut(self.count);
        for axis in 0..3 {
            row[axis] = direction[axis];
            row[3 + axis] = at.cross(&direction)[axis];
        }
        row[6] = -arm;
        self.right[self.count] = pace;
        self.count += 1;
        self
    }

    /// The upright moves at a point only along a line.
    pub(crate) fn only_along(self, at: Vector3<f64>, line: Vector3<f64>) -> Self {
        let across = line.cross(&Vector3::x()) + line.cross(&Vector3::z());
        self.along(at, across, 0.0, 0.0)
            .along(at, line.cross(&across), 0.0, 0.0)
    }

    /// No arm beside the upright turns.
    pub(crate) fn without_arm(mut self) -> Self {
        self.rows[(self.count, 6)] = 1.0;
        self.count += 1;
        self
    }

    /// The wheel rises: these points of the upright move in the pose as the conditions say.
    #[track_caller]
    pub(crate) fn moves(self, pose: &Pose, points: &[&str]) {
        let twist = self.along(pose.at("wheel_centre"), Vector3::z(), 0.0, 1.0);
        assert_eq!(twist.count, SIZE);
        let found = twist.rows.lu().solve(&twist.right).expect("regular");
        let [velocity, omega] = [0, 3].map(|first| found.fixed_rows::<3>(first).into_owned());
        for point in points {
            let expected = velocity + omega.cross(&pose.at(point));
            let off = (pose.per("bump", point) - expected).norm();
            assert!(off < 1e-10, "{point} is off by {off:e}");
        }
    }
}

/// The direction in which a point of a hinged arm moves, by its distance from the hinge's line.
pub(crate) fn about(layout: &Layout, hinge: [&str; 2], at: Vector3<f64>) -> Vector3<f64> {
    let [from, to] = hinge.map(|point| layout.at(point));
    (to - from).normalize().cross(&(at - from))
}

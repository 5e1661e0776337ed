//! A mechanism in 32 digits at places that are small steps of its drives apart.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::{Factors as _, Listing as _};
use suspension_core::listing::{DriveKind, Kind, Part, Parts};
use suspension_core::{Linkage, Signal, Values};
use suspension_double_double::DoubleDouble;
use suspension_runtime::Fitted;

use super::wheel::Vector;

/// The step of the drives between places, m or rad.
const STEP: f64 = 2e-5;

/// A correction that leaves 30 digits.
const LAST_CORRECTION: f64 = 1e-24;

/// The number of unknowns for which there is room: models of one size serve all layouts, and are compiled once.
const ROOM: usize = 60;

pub(super) type Model<'m, T> = suspension_runtime::Model<'m, T, ROOM>;

/// Steps of each drive from the place of a row.
pub(super) type Steps = Vec<i32>;

/// Vectors of all points that were computed once.
type Known<K> = RefCell<HashMap<K, Rc<[Vector]>>>;

/// A mechanism about the place of a row.
pub(super) struct Lattice<'m> {
    pub(super) exact: Model<'m, DoubleDouble>,
    drives: Vec<f64>,
    /// The factors at the start, with which all places near it are corrected.
    factors: <Model<'m, f64> as Linkage<ROOM>>::Factors,
    start: SVector<f64, ROOM>,
    solved: Known<Steps>,
    moved: Known<(Steps, usize)>,
}

impl<'m> Lattice<'m> {
    /// The free points and the drives are those of a row.
    pub(super) fn about(
        rounded: &'m Model<'m, f64>,
        design: &<Model<'m, f64> as Linkage<ROOM>>::Points,
        row: &BTreeMap<String, f64>,
    ) -> Self {
        let free = rounded.count(Kind::ChassisPoint)
            ..rounded.count(Kind::ChassisPoint) + rounded.count(Kind::FreePoint);
        let at = |(place, point)| {
            let name = rounded.name(Part::Point(place));
            if free.contains(&place) {
                Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{name}_{axis}")]))
            } else {
                point
            }
        };
        let drive = |place| {
            let unit = match rounded.drive_kind(place) {
                DriveKind::Coordinate => "m",
                DriveKind::Angle | DriveKind::Turn => "rad",
            };
            row[&format!("{}_{unit}", rounded.name(Part::Drive(place)))]
        };
        let points = Values::from_values(design.values().enumerate().map(at));
        let drives = (0..rounded.count(Kind::Drive)).map(drive).collect();
        Self::near(rounded, rounded.unknowns(&points), drives)
    }

    /// The configuration with these drives that is near another.
    pub(super) fn near(
        rounded: &'m Model<'m, f64>,
        start: SVector<f64, ROOM>,
        drives: Vec<f64>,
    ) -> Self {
        let coordinates = rounded.coordinates(&Signal::still(Values::from_values(drives.clone())));
        let anchors = rounded.drive_anchors(*rounded.fixed(), &coordinates.value);
        Self {
            exact: Fitted::converted(rounded, |x: f64| DoubleDouble::from(x)),
            drives,
            factors: rounded.factor(&start, &anchors),
            start,
            solved: RefCell::default(),
            moved: RefCell::default(),
        }
    }

    pub(super) fn drive_names(&self) -> Vec<&str> {
        let drives = 0..self.drives.len();
        drives
            .map(|drive| self.exact.name(Part::Drive(drive)))
            .collect()
    }

    /// Returns steps of one drive.
    pub(super) fn beside(&self, drive: usize, steps: i32) -> Steps {
        let mut beside = vec![0; self.drives.len()];
        beside[drive] = steps;
        beside
    }

    /// All points at a place.
    pub(super) fn points(&self, at: &Steps) -> Rc<[Vector]> {
        let known = self.solved.borrow().get(at).cloned();
        known.unwrap_or_else(|| {
            let points = self.solve(at);
            self.solved.borrow_mut().insert(at.clone(), points.clone());
            points
        })
    }

    /// The velocities of all points with respect to a drive.
    pub(super) fn velocities(&self, at: &Steps, drive: usize) -> Rc<[Vector]> {
        let place = (at.clone(), drive);
        let known = self.moved.borrow().get(&place).cloned();
        known.unwrap_or_else(|| {
            let velocities = self.differences_of_points(at, drive);
            self.moved.borrow_mut().insert(place, velocities.clone());
            velocities
        })
    }

    fn differences_of_points(&self, at: &Steps, drive: usize) -> Rc<[Vector]> {
        let beside = [-3, -2, -1, 0, 1, 2, 3].map(|steps| {
            let mut at = at.clone();
            at[drive] += steps;
            self.points(&at)
        });
        let coordinate = |point: usize, axis: usize| {
            first_difference(&beside.each_ref().map(|points| points[point][axis]))
        };
        let velocity = |point| Vector3::from_fn(|axis, _| coordinate(point, axis));
        (0..beside[0].len()).map(velocity).collect()
    }

    fn solve(&self, steps: &Steps) -> Rc<[Vector]> {
        let Self { exact, factors, .. } = self;
        let drives = self.coordinates(steps);
        let anchors = exact.drive_anchors(*exact.fixed(), &drives);
        let mut root = self.start.map(DoubleDouble::from);
        for _ in 0..60 {
            let residual = exact.residual(&root, &anchors, &drives);
            let correction = factors.solve(&residual.map(DoubleDouble::nearest));
            root -= correction.map(DoubleDouble::from);
            if correction.amax() < LAST_CORRECTION {
                return exact.points(&root, &anchors).values().collect();
            }
        }
        panic!("no root at {steps:?} of {:?}", self.drives);
    }

    /// Returns the prescribed coordinates, with cosines of all digits.
    fn coordinates(&self, steps: &Steps) -> <Model<'m, DoubleDouble> as Linkage<ROOM>>::Drives {
        // At an angle of zero the coordinate of a link is its length, and the rate of an angle about an axis a
        // quarter of it.
        let one = DoubleDouble::from(1.0);
        let at_zero = self.exact.coordinates(&Signal {
            rate: Values::from_values(std::iter::repeat(one)),
            ..Signal::default()
        });
        let quarters = at_zero.rate.values();
        let lengths = at_zero.value.values().zip(quarters);
        let drives = self.drives.iter().zip(steps).zip(lengths);
        let each = drives
            .enumerate()
            .map(|(place, ((drive, steps), (length, quarter)))| {
                let drive = DoubleDouble::from(*drive)
                    + DoubleDouble::from(STEP) * DoubleDouble::from(f64::from(*steps));
                match self.exact.drive_kind(place) {
                    DriveKind::Coordinate => drive,
                    DriveKind::Angle => length * drive.sine_cosine().1,
                    DriveKind::Turn => {
                        let four = DoubleDouble::from(4.0);
                        quarter * four * (drive / four).sine_cosine().0
                    }
                }
            });
        Values::from_values(each)
    }
}

/// The first derivative at the middle of seven numbers a step apart, of sixth order.
pub(super) fn first_difference([a, b, c, _, e, f, g]: &[DoubleDouble; 7]) -> DoubleDouble {
    let number = DoubleDouble::from;
    let sum = (*g - *a) - number(9.0) * (*f - *b) + number(45.0) * (*e - *c);
    sum / (number(60.0) * number(STEP))
}

/// Both derivatives.
pub(super) fn differences(numbers: &[DoubleDouble; 7]) -> [f64; 2] {
    let [a, b, c, d, e, f, g] = numbers;
    let number = DoubleDouble::from;
    let sum = number(2.0) * (*a + *g) - number(27.0) * (*b + *f) + number(270.0) * (*c + *e)
        - number(490.0) * *d;
    let second = sum / (number(180.0) * number(STEP) * number(STEP));
    [first_difference(numbers), second].map(DoubleDouble::nearest)
}

//! The steering rack: a line of points that steering alone moves, straight and equally far.

use nalgebra::Vector3;
use suspension_core::listing::DriveKind;

use crate::kinematics::Kinematics;
use crate::mechanism::{Place, State, extent};

/// A steering rack, or the part of it that a corner has.
#[derive(Clone, Copy, Debug)]
pub struct Rack {
    /// The points at its ends, by their indices; both are the same in a corner.
    pub ends: [usize; 2],
    /// How far the rack goes beyond the second one.
    pub beyond: Vector3<f64>,
}

/// The largest part of a velocity that is rounding; those of points are about one.
const ROUNDING: f64 = 1e-9;

/// The largest curvature of a straight way, as a part of one over the mechanism's extent: an arm has a larger one.
const STRAIGHT: f64 = 1e-6;

/// How far the ends of a rack may be from a line along which it slides, as a part of their distance.
const OBLIQUE: f64 = 0.1;

/// The length of the part that is drawn in a corner, as a part of the mechanism's extent.
const PART: f64 = 0.2;

impl Rack {
    /// Returns its ends for points at these places.
    pub(super) fn line(&self, at: &[Vector3<f64>]) -> Option<[Vector3<f64>; 2]> {
        let [from, to] = self.ends;
        Some([*at.get(from)?, at.get(to)? + self.beyond])
    }
}

/// Returns the racks of all drives that steer.
pub(super) fn racks(mechanism: &dyn Kinematics) -> Vec<Rack> {
    let names = &mechanism.names;
    let steer = names.vehicle.steer.iter().copied();
    let slides = |drive: &usize| names.drives[*drive].kind == DriveKind::Coordinate;
    let steer: Vec<usize> = steer.filter(slides).collect();
    let mut read = |place: &dyn Place| {
        let state = place.state();
        let sliding = steer
            .iter()
            .filter_map(|drive| Sliding::new(place, &state, *drive));
        sliding.flat_map(|sliding| sliding.racks()).collect()
    };
    mechanism.at_start(&mut read).unwrap_or_default()
}

/// The points that a drive moves along straight lines, and no other drive of the vehicle moves. Those of bell cranks, which
/// steering alone moves too, and the ends of a rod that ties two arms move on arcs.
struct Sliding<'a> {
    state: &'a State,
    velocities: Vec<Vector3<f64>>,
    points: Vec<usize>,
    /// The extent of the mechanism.
    extent: f64,
}

impl<'a> Sliding<'a> {
    fn new(place: &dyn Place, state: &'a State, drive: usize) -> Option<Self> {
        let per = place.per(drive)?.points;
        let extent = extent(state.points.value.iter().copied()).max();
        let is_straight = |point: &usize| {
            let (along, bend) = (per.rate[*point], per.second_rate[*point]);
            along.cross(&bend).norm() * extent < STRAIGHT * along.norm().powi(3)
        };
        let mut points = moved_alone(state, drive);
        points.retain(is_straight);
        Some(Self {
            state,
            velocities: per.rate.to_vec(),
            points,
            extent,
        })
    }

    /// Returns the racks between two points or more, or otherwise the parts of those that end at the only points.
    fn racks(&self) -> Vec<Rack> {
        let mut rest = self.points.clone();
        let mut racks = Vec::new();
        while let Some(first) = rest.first().copied() {
            let (rack, others): (Vec<_>, Vec<_>) = rest
                .into_iter()
                .partition(|point| self.are_of_one([first, *point]));
            racks.extend(self.outermost(&rack));
            rest = others;
        }
        if racks.iter().any(|[from, to]| from != to) {
            racks.retain(|[from, to]| from != to);
        }
        let rack = |ends: [usize; 2]| {
            let beyond = match ends {
                [from, to] if from == to => self.inboard(from)?,
                _ => Vector3::zeros(),
            };
            Some(Rack { ends, beyond })
        };
        racks.into_iter().filter_map(rack).collect()
    }

    /// Whether two points move equally and lie in the line of their motion.
    fn are_of_one(&self, [one, other]: [usize; 2]) -> bool {
        let [along, as_well] = [one, other].map(|point| self.velocities[point]);
        let apart = self.state.points.value[other] - self.state.points.value[one];
        let off = apart - along * (apart.dot(&along) / along.norm_squared());
        (as_well - along).norm() < ROUNDING * along.norm() && off.norm() <= OBLIQUE * apart.norm()
    }

    fn outermost(&self, points: &[usize]) -> Option<[usize; 2]> {
        let along = self.velocities[*points.first()?];
        let place = |point: &usize| self.state.points.value[*point].dot(&along);
        let by_place = |a: &&usize, b: &&usize| place(a).total_cmp(&place(b));
        Some([
            *points.iter().min_by(by_place)?,
            *points.iter().max_by(by_place)?,
        ])
    }

    /// Returns a step from a point towards the middle of the vehicle, as its rack goes on from there; `None` if the point
    /// is in the middle or does not move across the vehicle.
    fn inboard(&self, point: usize) -> Option<Vector3<f64>> {
        let along = self.velocities[point].normalize();
        let to_the_middle = -self.state.position(point).y / along.y;
        let length = to_the_middle.abs().min(PART * self.extent);
        (to_the_middle.is_finite() && length > 0.0).then(|| along * length.copysign(to_the_middle))
    }
}

/// Returns the points that a drive moves and no other drive of the vehicle.
fn moved_alone(state: &State, drive: usize) -> Vec<usize> {
    let is_moved = |point: usize, by: usize| {
        let moved = state.moved_by(by);
        moved.is_some_and(|moved| moved.value[point].norm() > ROUNDING)
    };
    let drives = 0..state.velocities.len();
    let is_moved_alone = |point: &usize| {
        drives
            .clone()
            .all(|by| is_moved(*point, by) == (by == drive))
    };
    let points = 0..state.points.value.len();
    points.filter(is_moved_alone).collect()
}

//! The motion of a wheel for vehicle models: in metres and radians, in the axes of ISO 8855.

use nalgebra::Vector3;
use suspension_core::body::{angular_velocity, pose};
use suspension_core::wheel::{camber, steer_rate, toe};

use crate::characteristics::ModeStates;
use crate::kinematics::Kinematics;
use crate::mechanism::{self, Axle, Place, State};
use crate::number::without_rounding;

/// The motion of a wheel.
pub(super) struct WheelMotion {
    /// The name; empty if the wheel has none.
    pub(super) name: String,
    /// 1 on the left, -1 on the right.
    pub(super) side: f64,
    /// Whether it is on neither side, as on a motorcycle.
    pub(super) is_in_middle: bool,
    /// The angle at the design position.
    pub(super) camber: f64,
    pub(super) toe: f64,
    /// The rotation about x at the design position, after the rotation about z by toe: the angle between the spin axis and
    /// the xy plane. Camber is the projection of that angle into the front view.
    pub(super) about_x: f64,
    /// The changes at places of the travel, from the lowest.
    pub(super) changes: Vec<Change>,
    pub(super) per_compression: Rates,
    /// The axle of the wheel, if the file or the wheel's name states it.
    pub(super) axle: Option<Axle>,
    /// The drive that steers the wheel, if one does.
    pub(super) steer: Option<usize>,
    /// If a drive steers the wheel: derivatives per metre or radian of it towards the left, the wheel held at its height.
    pub(super) per_steer: Option<Rates>,
}

/// The changes from the design position at a place of the travel.
pub(super) struct Change {
    /// The displacement of the wheel centre.
    pub(super) moved: Vector3<f64>,
    pub(super) camber: f64,
    pub(super) toe: f64,
    /// The forward rotation of the carrier in the side view.
    pub(super) dive: f64,
}

/// Derivatives at the design position.
#[derive(Clone, Debug)]
pub(super) struct Rates {
    /// The derivative of the wheel centre's position.
    pub(super) velocity: Vector3<f64>,
    /// The derivatives of the carrier's angles about x, y and z, for rotations about z, then x, then the spin axis: the
    /// first angle is [`WheelMotion::about_x`], the last one belongs to toe.
    pub(super) angles: Vector3<f64>,
    /// The derivatives of the measures.
    pub(super) measures: Vec<f64>,
}

impl Rates {
    fn times(&self, factor: f64) -> Self {
        Self {
            velocity: self.velocity * factor,
            angles: self.angles * factor,
            measures: self.measures.iter().map(|rate| rate * factor).collect(),
        }
    }

    fn plus(&self, other: &Self) -> Self {
        let measures = self.measures.iter().zip(&other.measures);
        Self {
            velocity: self.velocity + other.velocity,
            angles: self.angles + other.angles,
            measures: measures.map(|(a, b)| a + b).collect(),
        }
    }

    /// Returns whether these are the derivatives of the mirrored wheel; `way` is -1 if the variable changes its sign in the
    /// mirror.
    fn are_mirrored(&self, other: &Self, way: f64) -> bool {
        let along = Vector3::new(way, -way, way);
        let pairs = [
            (self.velocity, other.velocity.component_mul(&along)),
            (self.angles, other.angles.component_mul(&-along)),
        ];
        pairs.iter().all(|(a, b)| (a - b).amax() < ALIKE)
    }
}

/// Points of the wheel at a state.
struct Points {
    carrier: [Vector3<f64>; 3],
    axis: Vector3<f64>,
    centre: Vector3<f64>,
}

impl Points {
    fn read(wheel: &mechanism::Wheel, state: &State, metre: f64) -> Self {
        let at = |point: usize| state.axes.turned(state.position(point)) / metre;
        let [inner, centre] = wheel.points.axis.map(at);
        Self {
            carrier: wheel.points.carrier.map(at),
            axis: centre - inner,
            centre,
        }
    }
}

/// The largest difference that counts as rounding, in metres and radians.
const ALIKE: f64 = 1e-6;

impl WheelMotion {
    /// Returns the word for its side.
    pub(super) fn side_in_words(&self) -> &'static str {
        if self.side < 0.0 { "right" } else { "left" }
    }

    /// Returns the wheel with the word for its place.
    pub(super) fn in_words(&self) -> String {
        match self.is_in_middle {
            true => "wheel in the middle".to_owned(),
            false => format!("{} wheel", self.side_in_words()),
        }
    }

    /// Returns whether this is the mirrored wheel.
    pub(super) fn is_mirrored(&self, other: &Self) -> bool {
        let steered = match (&self.per_steer, &other.per_steer) {
            (Some(a), Some(b)) => a.are_mirrored(b, -1.0),
            (a, b) => a.is_none() && b.is_none(),
        };
        let design = [self.camber - other.camber, self.toe - other.toe];
        design.iter().all(|off| off.abs() < ALIKE)
            && self
                .per_compression
                .are_mirrored(&other.per_compression, 1.0)
            && steered
    }

    /// Computes the motion of a wheel along its travel; `None` if the mechanism is singular at its design position.
    pub(super) fn compute(
        mechanism: &dyn Kinematics,
        number: usize,
        travel: &ModeStates,
    ) -> Option<Self> {
        let wheel = &mechanism.names.wheels[number];
        let metre = mechanism.unit.metre();
        let is_angle = |drive: usize| mechanism.names.drives[drive].kind.is_angle();
        let in_metres = |drive: usize| if is_angle(drive) { 1.0 } else { metre };
        let mut read = |place: &dyn Place| {
            let state = place.state();
            let rates = |drive: usize| rates(wheel, &place.per(drive)?, &state, drive, metre);
            let of_travel = travel
                .drives
                .iter()
                .map(|(drive, part)| Some(rates(*drive)?.times(*part)));
            let of_travel = of_travel.reduce(|sum, next| Some(sum?.plus(&next?)))??;
            let of_steer = match wheel.steer {
                Some(drive) => Some(rates(drive)?.times(in_metres(drive))),
                None => None,
            };
            Some((state, of_travel, of_steer))
        };
        let (design, of_travel, of_steer) = mechanism.at_start(&mut read)??;
        let per_compression = of_travel.times(1.0 / of_travel.velocity.z);
        let at_height = |steer: Rates| steer.plus(&per_compression.times(-steer.velocity.z));
        let to_the_left = |steer: Rates| steer.times(steer.angles.z.signum());
        let design = Points::read(wheel, &design, metre);
        let reached = travel.visited.places.iter().flatten();
        let changes = reached
            .filter_map(|(state, _)| Change::between(&design, &Points::read(wheel, state, metre)));
        let mut changes: Vec<Change> = changes.collect();
        // If z points down, the drive rises as the wheel falls.
        changes.sort_by(|a, b| a.moved.z.total_cmp(&b.moved.z));
        Some(Self {
            name: wheel.name.clone(),
            side: design.axis.y.signum(),
            is_in_middle: wheel.is_in_middle,
            camber: without_rounding(camber(&design.axis)),
            about_x: without_rounding(about_x(&design.axis)),
            toe: without_rounding(toe(&design.axis)),
            changes,
            steer: wheel.steer,
            per_steer: of_steer.map(at_height).map(to_the_left),
            axle: wheel.axle.or(Axle::from_wheel_name(&wheel.name)),
            per_compression,
        })
    }
}

impl Change {
    fn between(design: &Points, now: &Points) -> Option<Self> {
        let upright = pose(&design.carrier, &now.carrier)?.rotation * Vector3::z();
        Some(Self {
            moved: now.centre - design.centre,
            camber: camber(&now.axis) - camber(&design.axis),
            toe: toe(&now.axis) - toe(&design.axis),
            dive: upright.x.atan2(upright.z),
        })
    }
}

/// Returns the derivatives with respect to a drive.
fn rates(
    wheel: &mechanism::Wheel,
    per: &State,
    state: &State,
    drive: usize,
    metre: f64,
) -> Option<Rates> {
    let velocities = &state.moved_by(drive)?.value;
    let turned = |vectors: &[Vector3<f64>], point: usize| state.axes.turned(vectors[point]);
    let [inner, centre] = wheel.points.axis;
    let at_axis = [inner, centre].map(|point| turned(&state.points.value, point));
    let carrier = wheel.points.carrier;
    let at = carrier.map(|point| turned(&state.points.value, point));
    let moving = carrier.map(|point| turned(velocities, point));
    let omega = angular_velocity(&at, &moving)?;
    Some(Rates {
        velocity: turned(velocities, centre) / metre,
        angles: angle_rates(&omega, &(at_axis[1] - at_axis[0])),
        measures: per.measures.rate.iter().map(|rate| rate / metre).collect(),
    })
}

/// Returns the rates of [`Rates::angles`] for a carrier with the angular velocity `omega`.
fn angle_rates(omega: &Vector3<f64>, spin_axis: &Vector3<f64>) -> Vector3<f64> {
    let axis_rate = omega.cross(spin_axis);
    let side = spin_axis.y.signum();
    let about_x = side * axis_rate.z / spin_axis.xy().norm();
    let about_z = steer_rate(spin_axis, &axis_rate);
    // The x axis after the rotation by toe, and the spin axis to the left.
    let ahead = Vector3::new(spin_axis.y, -spin_axis.x, 0.0).normalize() * side;
    let left = spin_axis.normalize() * side;
    let about_y = (omega - Vector3::z() * about_z - ahead * about_x).dot(&left);
    Vector3::new(about_x, about_y, about_z)
}

fn about_x(spin_axis: &Vector3<f64>) -> f64 {
    spin_axis.y.signum() * spin_axis.z.atan2(spin_axis.xy().norm())
}

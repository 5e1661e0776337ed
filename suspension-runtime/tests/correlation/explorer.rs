//! Suspension Explorer 0.6.2: three corners, 78 states each, and the sweep that the project keeps.
//!
//! Lengths in mm, angles in degrees, derivatives in those units; x forward, y left. Its own solver leaves
//! residuals of up to 1e-6 mm.

mod double_wishbone;
mod five_link;
mod macpherson;

use nalgebra::{Matrix3, Vector3};
use suspension_core::signal::Number as _;
use suspension_core::wheel::{Heading, SteeringAxis, camber, caster, kingpin_angle, toe};

use crate::agreement::Agreement;
use crate::published::{Row, vector};
use crate::suspension::{Moving, Number, Position, values};

/// mm.
const LENGTH: f64 = 1e-5;
/// Degrees.
const ANGLE: f64 = 1e-6;
/// Of the largest number in the column.
const RELATIVE: f64 = 1e-6;

/// A row of results and what is compared with it.
struct State<'a, 'l> {
    agreement: &'a mut Agreement,
    rows: &'a [Row],
    row: &'a Row,
    at: Position<'l>,
    radius: f64,
    /// The gate for angles.
    angle: f64,
}

impl State<'_, '_> {
    fn length(&mut self, column: &str, ours: Number) {
        let difference = ours.value - self.row[column];
        self.agreement.note(column, LENGTH, difference);
    }

    fn angle(&mut self, column: &str, ours: Number) {
        let difference = ours.value.to_degrees() - self.row[column];
        self.agreement.note(column, self.angle, difference);
    }

    /// A derivative, where the row has it.
    fn derivative(&mut self, column: &str, ours: f64) {
        let Some(published) = self.row.get(column) else {
            return;
        };
        let all = self.rows.iter().map(|row| row[column].abs());
        let largest = all.fold(0.0, f64::max);
        let difference = (ours - published) / largest;
        self.agreement.note(column, RELATIVE, difference);
    }

    /// Points by the names of their columns.
    fn points(&mut self, points: &[(&str, &str)], gate: f64) {
        let moving = self.at.in_bump();
        for (name, column) in points {
            let published = vector(self.row, &format!("{column}_?"));
            let difference = values(&moving.point(name)) - published;
            self.agreement.note(column, gate, difference.amax());
        }
    }

    /// What all corners have of the wheel.
    fn wheel(&mut self) {
        let [bump, steer] = [self.at.in_bump(), self.at.in_steering()];
        let contact = bump.contact(self.radius);
        let published = vector(self.row, "wheel_contact_centre_?");
        let difference = (values(&contact) - published).amax();
        self.agreement.note("contact", LENGTH, difference);
        self.length("half_track", contact.y);
        let angles = |moving: &Moving<'_>| [camber, toe].map(|of| of(&moving.spin_axis()));
        let [camber, toe] = angles(&bump);
        self.angle("camber", camber);
        self.angle("toe_angle", toe);
        self.derivative("deriv_camber_wrt_hub_z", camber.rate.to_degrees());
        self.derivative("deriv_toe_angle_wrt_hub_z", toe.rate.to_degrees());
        self.derivative("deriv_half_track_wrt_hub_z", contact.y.rate);
        self.derivative("deriv_wheel_center_x_wrt_hub_z", bump.centre().x.rate);
        let [camber, toe] = angles(&steer).map(|angle| angle.rate.to_degrees());
        self.derivative("deriv_camber_wrt_rack_displacement", camber);
        self.derivative("deriv_toe_angle_wrt_rack_displacement", toe);
    }

    /// The damper as the wheel rises.
    fn damper(&mut self, length: Number) {
        self.length("damper_length", length);
        self.derivative("deriv_damper_length_wrt_hub_z", length.rate);
    }

    /// The steering axis as the wheel rises, in columns with a suffix.
    fn steering_axis(&mut self, axis: &SteeringAxis<Number>, suffix: &str) {
        let moving = self.at.in_bump();
        let (spin, contact) = (moving.spin_axis(), moving.contact(self.radius));
        let column = |name: &str| format!("{name}{suffix}");
        let caster = caster(&axis.direction);
        self.angle(&column("caster"), caster);
        self.derivative("deriv_caster_wrt_hub_z", caster.rate.to_degrees());
        let kingpin = kingpin_angle(&axis.direction, &spin);
        self.angle(&column("kpi"), kingpin);
        self.derivative("deriv_kpi_wrt_hub_z", kingpin.rate.to_degrees());
        let heading = Heading::of(&spin);
        let trail = axis.ahead_of(&contact, &heading);
        self.length(&column("mechanical_trail"), trail);
        let offset = axis.inboard_of(&contact, &heading);
        self.length(&column("steering_axis_offset_ground"), offset);
        // Its scrub radius is the whole distance on the ground.
        let distance = (trail * trail + offset * offset).square_root();
        self.length(&column("scrub_radius"), distance);
    }

    /// Instant centres and swing arms by the planes in which the outer joints move, given by a point and a normal:
    /// those lie where the planes meet; the track rod has no part in them.
    fn instant_centres(&mut self, [lower, upper]: [[Vector3<f64>; 2]; 2]) {
        let moving = self.at.in_bump();
        let [centre, contact] = [moving.centre(), moving.contact(self.radius)];
        let [centre, contact] = [centre, contact].each_ref().map(values);
        // Where both planes meet that through the wheel centre, normal to an axis.
        let meet = |axis: Vector3<f64>| {
            let planes = [lower, upper, [centre, axis]];
            let rows = planes.map(|[_, normal]| normal.transpose());
            let right = planes.map(|[point, normal]| normal.dot(&point));
            let inverse = Matrix3::from_rows(&rows).try_inverse();
            inverse.map(|inverse| inverse * Vector3::from(right))
        };
        let (Some(front), Some(side)) = (meet(Vector3::x()), meet(Vector3::y())) else {
            return;
        };
        // The front swing arm is the distance to the contact point in the plane, the side one that along x.
        let front_arm = (contact - front).yz().norm();
        let side_arm = side.x - contact.x;
        self.far("fvic_y", front.y, front_arm);
        self.far("fvic_z", front.z, front_arm);
        let signed = front_arm.copysign(contact.y - front.y);
        self.far("fvsa_length", signed, front_arm);
        self.far("svic_x", side.x, side_arm);
        self.far("svic_z", side.z, side_arm);
        self.far("svsa_length", side_arm, side_arm);
    }

    /// What belongs to an instant centre, where the row has it: an error of the points grows with the square of the arm.
    fn far(&mut self, column: &str, ours: f64, arm: f64) {
        if let Some(published) = self.row.get(column) {
            let beyond = (arm.abs() / 10_000.0).max(1.0);
            let difference = (ours - published) / (arm * beyond);
            self.agreement.note(column, RELATIVE, difference);
        }
    }
}

/// The line through two points.
fn line(moving: &Moving<'_>, ends: [&str; 2]) -> SteeringAxis<Number> {
    SteeringAxis::through(ends.map(|name| moving.point(name)))
}

/// The plane of three points: one of them, and the normal.
fn plane(moving: &Moving<'_>, points: [&str; 3]) -> [Vector3<f64>; 2] {
    let [a, b, c] = points.map(|name| values(&moving.point(name)));
    [a, (b - a).cross(&(c - a))]
}

//! The rear suspension of the Formula Renault 2.0 of 2009 (chassis manual, 30-9): hardpoints, and kinematics over travel with two
//! decimals.
//!
//! Its definitions are not ours. Travel is the rise of the lowest point of the wheel. Camber is the static camber less the change
//! of the kingpin angle, as if the track rod did not turn the wheel. Toe is that of an axis which is level at the design
//! position. The roll centre is where the planes of the arms meet.

use nalgebra::{Matrix2, Vector2, Vector3};
use suspension_core::wheel::{caster, kingpin_angle, toe};

use crate::agreement::Agreement;
use crate::suspension::{Moving, Position, Suspension, values};

const STATEMENTS: &str = "
    fixed: lower_inboard_front, lower_inboard_rear, upper_inboard_front, upper_inboard_rear, trackrod_inboard,
           rocker_low, rocker_high, damper_inboard;
    free:  lower_outboard, upper_outboard, trackrod_outboard, axle_outboard,
           pushrod_outboard, pushrod_inboard, damper_outboard;

    hinge lower_arm: lower_inboard_front, lower_inboard_rear -> lower_outboard, pushrod_outboard;
    hinge upper_arm: upper_inboard_front, upper_inboard_rear -> upper_outboard;
    hinge rocker:    rocker_low, rocker_high -> pushrod_inboard, damper_outboard;
    link pushrod:    pushrod_outboard -> pushrod_inboard;
    link trackrod:   trackrod_inboard -> trackrod_outboard;
    body upright:    lower_outboard, upper_outboard, trackrod_outboard, axle_outboard;
    point axle_inboard: upright;

    drive bump:  axle_outboard.z;
    drive steer: trackrod_inboard.y;
    measure damper: length(damper_inboard -> damper_outboard);";

/// Hardpoints of the left wheel, mm; x forward, y left, z up from the ground.
fn hardpoint(name: &str) -> Vector3<f64> {
    let at = match name {
        "lower_inboard_front" => [264.30, 105.50, 178.50],
        "lower_inboard_rear" => [-110.49, 105.50, 162.30],
        "upper_inboard_front" => [214.30, 106.44, 348.08],
        "upper_inboard_rear" => [-214.30, 106.44, 350.47],
        "trackrod_inboard" => [-110.49, 105.50, 152.30],
        "rocker_low" => [21.90, 125.03, 355.64],
        "rocker_high" => [21.90, 149.43, 410.46],
        "damper_inboard" => [-297.97, 47.63, 390.34],
        "lower_outboard" => [77.88, 587.57, 180.53],
        "upper_outboard" => [-5.90, 516.35, 409.31],
        "trackrod_outboard" => [-69.16, 583.78, 170.13],
        "pushrod_outboard" => [76.66, 507.59, 200.51],
        "pushrod_inboard" => [63.80, 87.41, 388.81],
        "damper_outboard" => [21.90, 45.25, 407.58],
        "axle_inboard" => [0.0, 534.73, RADIUS],
        _ => [0.0, 634.73, RADIUS],
    };
    at.into()
}

/// Half a unit of the last digit.
const DIGIT: f64 = 0.005;

const RADIUS: f64 = 283.92;
const CAMBER: f64 = -5.0;

/// Travel; camber, toe, roll centre, damper, recession, change of half track, caster, kingpin angle; mm and degrees.
const PRINTED: [[f64; 9]; 3] = [
    [
        -30.0, -4.19, 0.19, 79.37, 342.19, -0.87, -2.61, 20.38, 16.48,
    ],
    [
        -20.0, -4.45, 0.13, 67.76, 335.48, -0.58, -1.57, 20.29, 16.74,
    ],
    [
        -10.0, -4.72, 0.07, 56.17, 328.23, -0.29, -0.70, 20.20, 17.01,
    ],
];

/// The suspension as the manual sees it.
struct Seen<'l> {
    at: Moving<'l>,
    camber: f64,
    contact: Vector3<f64>,
}

impl<'l> Seen<'l> {
    fn new(at: &Position<'l>, design_kingpin: f64) -> Self {
        let at = at.in_bump();
        let camber = CAMBER + design_kingpin - kingpin(&at);
        let down = Vector3::new(0.0, -camber.to_radians().sin(), -camber.to_radians().cos());
        let contact = values(&at.centre()) + down * RADIUS;
        Self {
            at,
            camber,
            contact,
        }
    }

    /// The height above the ground, on the middle of the vehicle, of the line from the contact point to the instant centre in the
    /// front view, where the planes of the arms meet that through the wheel centre.
    fn roll_centre(&self) -> f64 {
        let x = values(&self.at.centre()).x;
        let arms = ["lower", "upper"].map(|arm| {
            let points = ["inboard_front", "inboard_rear", "outboard"];
            let [a, b, c] = points.map(|at| values(&self.at.point(&format!("{arm}_{at}"))));
            let normal = (b - a).cross(&(c - a));
            (normal.yz(), normal.dot(&a) - normal.x * x)
        });
        let rows = Matrix2::from_rows(&arms.map(|(normal, _)| normal.transpose()));
        let right = Vector2::from(arms.map(|(_, right)| right));
        let centre = rows.lu().solve(&right).expect("arms that meet");
        let slope = (centre.y - self.contact.z) / (self.contact.y - centre.x);
        slope * self.contact.y
    }
}

fn steering_axis(at: &Moving<'_>) -> Vector3<f64> {
    values(&(at.point("upper_outboard") - at.point("lower_outboard")))
}

fn kingpin(at: &Moving<'_>) -> f64 {
    kingpin_angle(&steering_axis(at), &values(&at.spin_axis())).to_degrees()
}

#[test]
fn formula_renault() {
    let suspension = Suspension::new(STATEMENTS, hardpoint);
    let design_kingpin = kingpin(&suspension.design().in_bump());
    let seen = |travel: f64| Seen::new(&suspension.design().moved([travel, 0.0]), design_kingpin);
    let design = seen(0.0);
    let mut agreement = Agreement::default();
    for [
        travel,
        camber,
        turned,
        roll_centre,
        damper,
        recession,
        track,
        leaning,
        inclined,
    ] in PRINTED
    {
        let rise = |of_centre: f64| seen(of_centre).contact.z - design.contact.z;
        let of_centre = (0..20).fold(travel, |of_centre, _| of_centre + travel - rise(of_centre));
        let now = seen(of_centre);
        let axis = steering_axis(&now.at);
        let length = values(&(now.at.point("damper_outboard") - now.at.point("damper_inboard")));
        for (name, gate, ours, printed) in [
            ("camber", DIGIT, now.camber, camber),
            (
                "toe",
                DIGIT,
                toe(&values(&now.at.spin_axis())).to_degrees(),
                turned,
            ),
            ("roll centre", 0.05, now.roll_centre(), roll_centre),
            ("damper", DIGIT, length.norm(), damper),
            ("recession", DIGIT, -values(&now.at.centre()).x, recession),
            ("half track", DIGIT, now.contact.y - design.contact.y, track),
            ("caster", DIGIT, caster(&axis).to_degrees(), leaning),
            ("kingpin", DIGIT, kingpin(&now.at), inclined),
        ] {
            agreement.note(name, gate, ours - printed);
        }
    }
    agreement.holds("Formula Renault 2.0, rear", 24);
}

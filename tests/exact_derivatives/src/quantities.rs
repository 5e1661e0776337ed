//! Quantities of points and velocities in 32 digits, under their names in tables.

use std::rc::Rc;

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts, WheelPlaces};
use suspension_core::signal::Number as _;
use suspension_core::wheel::{Carrier, Turn, contact, steer_angle, toe};
use suspension_double_double::DoubleDouble as Number;
use suspension_listing::name::Name;
use suspension_listing::system::{Quantity, System};

use super::lattice::{Lattice, Steps};
use super::wheel::{
    Named, PER_TURN, RADIUS, Vector, coordinates, moving_carrier, of_steering, of_wheel, on_ground,
};

/// Wheelbase, m.
const WHEELBASE: f64 = 2.5;
/// Wheelbase over height of the centre of gravity, and the axle's shares.
const LEVER: f64 = 5.0;
const BRAKE_SHARE: f64 = 0.625;
const DRIVE_SHARE: f64 = 0.25;

/// Quantities that wheels which move each other lack.
const OF_INDEPENDENT: [&str; 2] = ["roll_centre_m", "jacking_percent"];

/// The axle of the suspension in a car.
#[derive(Clone, Copy, Debug)]
pub(super) enum Car {
    Front,
    Rear,
}

impl Car {
    /// Returns the line of a motion file that describes the vehicle. By default `steer` is the drive of steering, and the
    /// drives of travel have the names of the wheels.
    pub(super) fn vehicle(self, travel: &str, steers: bool) -> String {
        let axle = match self {
            Self::Front => "front",
            Self::Rear => "rear",
        };
        let travel = match travel {
            "bump_left" => String::new(),
            travel => format!("travel = \"{travel}\", "),
        };
        let steering_wheel = match steers {
            true => format!("rack_per_turn = {PER_TURN}, "),
            false => String::new(),
        };
        format!(
            "vehicle = {{ wheel_radius = {RADIUS}, {travel}{steering_wheel}axle = \"{axle}\", \
             wheelbase = {WHEELBASE:?}, cg_height = 0.5, brake_share = {BRAKE_SHARE}, drive_share = {DRIVE_SHARE} }}\n"
        )
    }
}

/// Returns the first drive that does not steer, and the one that does.
pub(super) fn travel_and_steering(drives: &[&str]) -> (usize, Option<usize>) {
    let place = |steers: bool| drives.iter().position(|name| (*name == "steer") == steers);
    (place(false).expect("a drive"), place(true))
}

/// Data for quantities in addition to points and velocities.
pub(super) struct Reference<'a> {
    pub(super) system: &'a System,
    pub(super) car: Car,
    /// All points at the design position.
    pub(super) design: &'a [Vector3<f64>],
}

impl Reference<'_> {
    /// All quantities that have derivatives.
    pub(super) fn all(&self, lattice: &Lattice<'_>, at: &Steps) -> Named {
        let model = &lattice.exact;
        let each = lattice.points(at);
        let (travel, steer) = travel_and_steering(&lattice.drive_names());
        let point = |name: &Name| {
            let mut places = 0..each.len();
            let place = places.find(|place| model.name(Part::Point(*place)) == name.to_string());
            each[place.expect("a point")]
        };
        let mut named = Named::new();
        let chassis = model.count(Kind::ChassisPoint);
        let moving = model.count(Kind::FreePoint) + model.count(Kind::Marker);
        for (place, at) in each.iter().enumerate().skip(chassis).take(moving) {
            coordinates(&mut named, model.name(Part::Point(place)), at);
        }
        for measure in &self.system.measures {
            let name = &measure.named.name;
            named.push(measured(name, &measure.quantity, point));
        }
        let wheels = (0..).map_while(|wheel| model.wheel(wheel));
        let drives = lattice.drive_names();
        let mut axes = Vec::new();
        for wheel in wheels {
            let mut of_one = Named::new();
            let ends = wheel.axis.map(|place| each[place]);
            let at_design = wheel.axis.map(|place| self.design[place].map(Number::from));
            self.changes_from_design(&mut of_one, ends, at_design);
            let carrier = wheel.carrier.map(|place| each[place]);
            let moved_by = |drive| {
                let rates = lattice.velocities(at, drive);
                moving_carrier(carrier, wheel.carrier.map(|place| rates[place]), ends[1])
            };
            let kingpin = wheel.kingpin.map(|ends| ends.map(|place| each[place]));
            of_wheel(&mut of_one, ends, kingpin);
            if let Some(steer) = steer {
                of_steering(&mut of_one, &moved_by(steer), ends);
            }
            let own = format!("bump_{}", wheel.name);
            let position = |name: &str| drives.iter().position(|drive| *drive == name);
            let own = position(&own).unwrap_or(travel);
            self.of_travel(&mut of_one, &moved_by(own), ends);
            let rates = lattice.velocities(at, own);
            let moves = |place: usize| rates[place].iter().any(|rate| rate.nearest().abs() > 1e-9);
            let others = (0..).map_while(|other| model.wheel(other));
            let mut others = others.filter(|other| other.name != wheel.name);
            let moved = others.find(|other| other.carrier.into_iter().any(moves));
            let mut in_side_view = moved_by(own);
            if let Some(other) = &moved {
                let of_other = format!("bump_{}", other.name);
                let drives = [own, position(&of_other).expect("a drive")];
                let rates = drives.map(|drive| lattice.velocities(at, drive));
                in_side_view = in_heave(&each, &rates, [&wheel, other]);
            }
            let is_axle = moved.is_some_and(|other| other.carrier == wheel.carrier);
            self.in_side_view(&mut of_one, &in_side_view, ends, is_axle);
            if moved.is_some() {
                of_one.retain(|(name, _)| !OF_INDEPENDENT.contains(&name.as_str()));
            }
            let prefix = match wheel.name {
                "" => String::new(),
                name => format!("{name}_"),
            };
            let of_one = of_one.into_iter();
            named.extend(of_one.map(|(name, value)| (format!("{prefix}{name}"), value)));
            axes.push([ends, at_design]);
        }
        if let [left, right] = axes.as_slice() {
            let [now, design] = [0, 1].map(|when| [left[when], right[when]]);
            named.push(("track_change_m".to_owned(), track(now) - track(design)));
            self.of_axle(&mut named, now, steer.is_some());
        }
        named
    }

    /// Computes the displacement of a wheel from the ends of its axis.
    fn changes_from_design(&self, named: &mut Named, now: [Vector; 2], design: [Vector; 2]) {
        let centre = now[1] - design[1];
        let contact = on_ground(now) - on_ground(design);
        let is_right = (design[1].y - design[0].y).is_below_zero();
        let outboard = if is_right { -contact.y } else { contact.y };
        let forward = contact.x;
        let away = match self.car {
            Car::Front => forward,
            Car::Rear => -forward,
        };
        let each = [
            ("wheel_travel_m", centre.z),
            ("recession_m", -centre.x),
            ("half_track_change_m", outboard),
            ("wheelbase_change_m", away),
        ];
        named.extend(each.map(|(name, value)| (name.to_owned(), value)));
    }

    fn of_axle(&self, named: &mut Named, wheels: [[Vector; 2]; 2], steers: bool) {
        let axes = wheels.map(|[inner, centre]| centre - inner);
        let [left, right] = axes;
        let track = track(wheels);
        let mut add = |name: &str, value| named.push((name.to_owned(), value));
        add("total_toe_rad", toe(&left) + toe(&right));
        add("track_m", track);
        if !steers {
            return;
        }
        add("left_steer_angle_rad", steer_angle(&left));
        add("right_steer_angle_rad", steer_angle(&right));
        let turn = Turn::of([&left, &right]);
        let is_straight = (turn.inner + turn.outer).nearest() < 2.0_f64.to_radians();
        if is_straight || matches!(self.car, Car::Rear) {
            return;
        }
        let wheelbase = Number::from(WHEELBASE);
        add(
            "ackermann_percent",
            turn.ackermann(wheelbase, track) * 100.0.into(),
        );
        add(
            "ackermann_error_rad",
            turn.inner - turn.ideal_inner(wheelbase, track),
        );
        add("turning_radius_m", turn.radius(wheelbase));
    }

    fn of_travel(&self, named: &mut Named, carrier: &Carrier<Number>, wheel: [Vector; 2]) {
        let axis = wheel[1] - wheel[0];
        let ground = contact(&wheel[1], &axis, RADIUS.into());
        let front = carrier.front_view(&axis);
        let path = carrier.velocity_of(&ground);
        let outboard = if ground.y.is_below_zero() {
            -100.0
        } else {
            100.0
        }
        .into();
        named.extend(
            [
                ("roll_centre_m", carrier.roll_centre(&ground) - ground.z),
                ("jacking_percent", path.y / path.z * outboard),
                ("front_centre_y", front.across),
                ("front_centre_z", front.z),
                ("front_arm_m", front.arm),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        );
    }

    /// `is_axle` if one body carries both wheels, which then bears the torque of the drive.
    fn in_side_view(
        &self,
        named: &mut Named,
        carrier: &Carrier<Number>,
        wheel: [Vector; 2],
        is_axle: bool,
    ) {
        let axis = wheel[1] - wheel[0];
        let ground = contact(&wheel[1], &axis, RADIUS.into());
        let side = carrier.side_view();
        let path = |velocity: Vector| {
            if velocity.z.is_below_zero() {
                -velocity
            } else {
                velocity
            }
        };
        let [braked, by_shafts] = [path(carrier.velocity_of(&ground)), path(carrier.velocity)];
        let driven = if is_axle { braked } else { by_shafts };
        let angle = |path: Vector| Number::arc_tangent(path.x, path.z);
        let support = |path: Vector, share: f64| path.x / path.z * (100.0 * share * LEVER).into();
        let [brakes, drive] = [support(braked, BRAKE_SHARE), support(driven, DRIVE_SHARE)];
        named.extend(
            [
                ("side_centre_x", side.across),
                ("side_centre_z", side.z),
                ("side_arm_m", side.arm),
                ("brake_angle_rad", angle(braked)),
                ("drive_angle_rad", angle(by_shafts)),
            ]
            .map(|(name, value)| (name.to_owned(), value)),
        );
        named.extend(
            match self.car {
                Car::Front => [
                    ("anti_dive_percent", brakes),
                    ("anti_lift_in_drive_percent", drive),
                ],
                Car::Rear => [
                    ("anti_lift_percent", -brakes),
                    ("anti_squat_percent", -drive),
                ],
            }
            .map(|(name, value)| (name.to_owned(), value)),
        );
    }
}

/// The first wheel's carrier as two drives move it at rates at which both wheel centres rise alike.
fn in_heave(
    points: &[Vector],
    rates: &[Rc<[Vector]>; 2],
    wheels: [&WheelPlaces<'_>; 2],
) -> Carrier<Number> {
    let [[a, b], [c, d]] = wheels.map(|wheel| rates.each_ref().map(|by| by[wheel.axis[1]].z));
    // Cramer's rule.
    let [first, second] = [(d - b) / (a * d - b * c), (a - c) / (a * d - b * c)];
    let place = wheels[0].carrier;
    let combined = place.map(|place| rates[0][place] * first + rates[1][place] * second);
    moving_carrier(
        place.map(|place| points[place]),
        combined,
        points[wheels[0].axis[1]],
    )
}

fn track(wheels: [[Vector; 2]; 2]) -> Number {
    let [left, right] = wheels.map(on_ground);
    left.y - right.y
}

fn length(line: Vector) -> Number {
    line.dot(&line).square_root()
}

fn measured(name: &Name, quantity: &Quantity, point: impl Fn(&Name) -> Vector) -> (String, Number) {
    let line = |[from, to]: &[Name; 2]| point(to) - point(from);
    match quantity {
        Quantity::Sum(terms) => {
            let terms = terms
                .iter()
                .map(|term| point(&term.point)[term.axis] * term.factor.into());
            (
                format!("{name}_m"),
                terms.fold(0.0.into(), |sum, term| sum + term),
            )
        }
        Quantity::Length { line: ends } => (format!("{name}_m"), length(line(ends))),
        Quantity::Angle { axis, line: ends } => {
            let line = line(ends);
            let mut across = line;
            across[*axis] = 0.0.into();
            (
                format!("{name}_rad"),
                Number::arc_tangent(length(across), line[*axis]),
            )
        }
        Quantity::Between {
            lines: [first, second],
            about: Some(about),
        } => {
            let (first, second, axis) = (line(first), line(second), line(about));
            let axis = axis / length(axis);
            let across = |line: Vector| line - axis * axis.dot(&line);
            let (first, second) = (across(first), across(second));
            (
                format!("{name}_rad"),
                Number::arc_tangent(axis.dot(&first.cross(&second)), first.dot(&second)),
            )
        }
        other => panic!("no measure of the catalogue is as {name}: {other:?}"),
    }
}

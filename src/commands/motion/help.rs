//! The text of `suspension motion --help`.

use suspension_core::listing::MeasureKind;
use suspension_runtime::{Listing, catalogue as layouts};

use crate::mechanism::{
    Axle, Mass, Names, Spring, SteeringWheel, Torque, Unit, Vehicle, Wheel, WheelPoints,
};
use crate::quantities::{ANTI_LIFT, ANTI_SQUAT, Shown, catalogue, in_words, of_axles};

/// Returns the help: the file, the results with the names that they have for the published linkage, and the exit codes.
pub fn text() -> String {
    let tabled = catalogue().filter(|quantity| quantity.shown != Shown::InSummaries);
    let published = layouts::listing("attia2003").map(Listing::parse);
    let Some(Ok(linkage)) = published else {
        unreachable!("the catalogue has the published linkage");
    };
    let [front, rear] = [Axle::Front, Axle::Rear].map(|axle| names_on(axle, &linkage));
    let of_rear_axles = [&ANTI_LIFT, &ANTI_SQUAT];
    format!(
        "{FILE}{}{}{AXLE}{}{EXIT_CODES}",
        in_words(tabled, &front, Unit::METRE),
        in_words(of_rear_axles, &rear, Unit::METRE),
        in_words(of_axles(), &names_of_axle(&linkage), Unit::METRE),
    )
}

/// Returns the names of the published linkage, with everything that a motion file may state of the vehicle. The choice of
/// points and drives does not matter here.
fn names_on(axle: Axle, linkage: &Listing) -> Names {
    Names {
        wheels: vec![wheel("", 0, axle)],
        vehicle: Vehicle {
            travel: vec![0],
            steer: vec![0],
            steering_wheel: Some(SteeringWheel {
                drive: 0,
                turned: vec![0, 1],
                per_turn: 0.052,
                design: 0.0,
            }),
            wheelbase: Some(2.6),
            cg_height: Some(0.5),
            springs: [Spring {
                name: "spring".to_owned(),
                measure: 0,
                kind: MeasureKind::Length,
                rate: 0.0,
                load: 0.0,
                design: 0.0,
            }]
            .into(),
            masses: [Mass::At(0, 0.0)].into(),
        },
        ..Names::new(linkage)
    }
}

/// Returns the names of a linkage with two wheels.
fn names_of_axle(linkage: &Listing) -> Names {
    Names {
        wheels: vec![
            wheel("left", 0, Axle::Front),
            wheel("right", 1, Axle::Front),
        ],
        ..names_on(Axle::Front, linkage)
    }
}

fn wheel(name: &str, travel: usize, axle: Axle) -> Wheel {
    Wheel {
        name: name.to_owned(),
        points: WheelPoints {
            kingpin: Some([0; 2]),
            ..WheelPoints::default()
        },
        travel: Some(travel),
        steer: Some(0),
        radius: Some(0.3),
        axle: Some(axle),
        brake_share: Some(0.5),
        drive_share: Some(0.5),
        drive_torque: Torque::Chassis,
        ..Wheel::default()
    }
}

const FILE: &str = r#"Sections below: The file, Results, Results of axles, Axes, The published motion, Exit codes, Example.

The file:

  linkage = "attia2003"              # or another of `suspension list`; in its place
                                     # listing = "corner.linkage", a file of statements beside this one, or
                                     # statements = '''...''' with the statements themselves
  unit = "m"                         # or "mm" or "in": the unit of all lengths here and in results; no conversion
  angle = "rad"                      # or "deg": the unit of all angles here and in results; "rad" if left out
  axes = "ISO 8855"                  # or "Adams" or "SAE": the axes of all coordinates here and in results; may be left out
  [points]                           # chassis points, free points and markers, each by name
  p1 = [-1.396, -0.025, -0.082]
  p11 = { from = "p8", offset = [0.0, 0.1, 0.0] }   # a marker, stated as an offset from another point
  [lengths]                          # optional: all lengths. Free points are then a first guess and need not satisfy the
  d6_1 = 0.445872                    # statements; without [lengths], points that do not are noted or refused
  [design]                           # optional: the drives' values at which the mechanism is assembled and markers with an
  theta = 1.5707963267948966         # offset are attached; without it they are as the points state. Markers with
                                     # coordinates are always attached as the points state
  [vehicle]                          # optional: values that some quantities need
  wheel_radius = 0.3                 # in the unit; gives contact point, scrub radius, mechanical trail, roll centre;
                                     # for several axles { front = 0.30, rear = 0.31 }
  travel = "bump"                    # the drive that moves the wheel up and down; for several wheels one each,
                                     # { left = "bump_left", right = "bump_right" }; if left out, for the wheel left the
                                     # drive named bump_left or left_bump, else bump
  steer = "steer"                    # the drive that steers it, likewise; if left out, steer_left, left_steer or steer
  rack_per_turn = 0.052              # how far that drive moves per turn of the steering wheel, in the unit (the C-factor);
                                     # gives the angle of the steering wheel and the steering ratio
  steering_box_ratio = 16.0          # in place of rack_per_turn if that drive is an angle, such as that of a pitman arm: the
                                     # angle of the steering wheel per angle of the arm, in degrees per degree
  wheelbase = 2.6                    # in the unit; gives Ackermann and turning circle
  axle = "front"                     # or "rear"; gives the change of wheelbase, with wheelbase and the next three also
                                     # anti-dive, anti-lift and anti-squat
  cg_height = 0.5                    # the height of the car's centre of gravity above the ground, in the unit
  brake_share = 0.6                  # the axle's share of the brake force, from 0 to 1; for several axles, whose wheels
                                     # are named front_left and so on, { front = 0.6, rear = 0.4 } and no `axle`
  drive_share = 1.0                  # the axle's share of the drive force, if the axle is driven
  drive_torque = "chassis"           # the part that bears the drive torque: chassis (shafts) or carrier (motors in the wheels);
                                     # if left out, the chassis, or the axle if one body carries both wheels (state it
                                     # for a de Dion axle). brake_torque likewise: carrier if left out
  [time]                             # in seconds; or: instants = [0.0, 0.25, 0.5]
  start = 0.0
  stop = 1.95                        # the last instant is the last multiple of step within stop
  step = 0.05
  [drives]                           # over time in seconds, in the units of angles or lengths:
  theta = [0.7, 0.5, 0.125]          # a polynomial, constant first; a single number holds the drive there
  bump = { mean = 0.30, amplitude = 0.05, frequency = 1.5 }   # or a sine, mean + amplitude sin(2 pi frequency t + phase):
                                     # frequency in Hz, phase in the unit of angles, 0 if left out
  steer = { csv = "logged.csv", columns = ["t_s", "rack"], factor = 0.001, offset = 0.34 }   # or a recording, in a file beside
                                     # this one: times in s and values x, which a cubic spline interpolates; the drive is
                                     # offset + factor x, x itself if both are left out. Noise becomes accelerations
  height = [0.05, 0.01]              # or, in place of one drive, a measure of the linkage, which
                                     # leads through turning points of the drive: attia2003 and
                                     # five_link have height, that of the wheel centre
  [springs.spring]                   # optional: springs and bars of any name, for forces, wheel rate and roll rate; in load
                                     # cases those act that a case names: acting = ["spring"]
  along = "damper"                   # a measure: a length, or for a bar the angle of its arm, as bar_arm
  rate = 28000.0                     # N per unit of length; for an angle N m per unit of angle
  load = 3800.0                      # N, for an angle N m: the force or moment at the design position, positive where it
                                     # makes the measure larger
  [masses]                           # of parts, and load cases: see suspension loads --help
  [loads.braking]
  [tolerances]                       # of points and links: see suspension sensitivities --help
  [tune]                             # what may move and what to reach: see suspension tune --help

Results:

Each instant has one row. Where a quantity has no value, as an instant centre of a carrier that does not turn, CSV has
NaN, and JSON and Parquet have null. The columns have these names for attia2003; lengths and angles are in the file's units
(with angle = "deg", camber_deg in place of camber_rad and omega in deg/s):

"#;

const AXLE: &str = "
Results of axles:

If a listing names its wheels, each wheel has all the columns of a wheel, with its name before them: left_camber_rad,
right_camber_rad. A linkage with two wheels, one on each side, such as steered_axle, also has the columns below. A linkage
with several axles, whose wheels are named front_left, front_right, rear_left and so on, has them for each axle:
front_track_m.

";

const EXIT_CODES: &str = r#"
Axes:

All are right-handed: ISO 8855 x forward, y left, z up; Adams x rearward, y right, z up; SAE x forward, y right, z down.
The file's axes apply to points, offsets, and coordinates and axes in statements (wheel_centre.z, angle(a -> b, z)), drives
and measures included. They also apply to coordinates, velocities and derivatives per drive in results. Angles and offsets
of the wheel have the signs above in all axes. The points of a catalogue layout are turned to the file's axes. The header of
JSON, sheet, check and summary name the axes; a CSV file has no place for them. Quantities that a linkage lacks, such as
those of a kingpin, have no columns, nor do those for which the [vehicle] table lacks a value.

The published motion:

The paper prints no coordinates for the wheel centre, point 11. examples/attia2003.toml assumes it
0.10 m outboard (+y) of point 8, on a spin axis parallel to y, at theta = pi/2.

Exit codes:
  0    done
  1    a result cannot be written
  2    wrong input (file:line:column says where), or --csv names an input file
  3    the motion stops short of its last instant (for example where the drive or measure that
       leads it turns), or the points do not assemble in the design position, or the first instant
       is out of reach from there
  130  interrupted (Ctrl-C, SIGTERM or SIGHUP)
If the motion stops short or is interrupted, the tables have the rows up to there.

Example:
  suspension motion examples/five_link.toml --csv motion.csv --plots plots"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_section_named_in_the_motion_help_has_its_heading() {
        let text = text();
        let (sections, _) = text.split_once(".\n").expect("the sections");
        let sections = sections
            .strip_prefix("Sections below: ")
            .expect("the sections");
        for section in sections.split(", ") {
            assert!(text.contains(&format!("\n{section}:\n")), "{section}");
        }
    }

    #[test]
    fn the_motion_help_defines_every_quantity_of_tables() {
        let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let text = words(&text());
        for quantity in catalogue().filter(|quantity| quantity.shown != Shown::InSummaries) {
            assert!(
                text.contains(&words(quantity.definition)),
                "{}",
                quantity.title
            );
        }
    }
}

//! `examples/c/motion.c` in Rust, with the core alone: prints the same text, including checksums of all
//! bits. The argument is `f32` or `f64`.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;
use std::process::ExitCode;

use suspension_core::inertia::{RigidBody, rod};
use suspension_core::linkage::{HasKingpin, HasWheel};
use suspension_core::linkages::five_link::{Drives, Lengths, Model, Points};
use suspension_core::nalgebra::{Matrix3, Vector3};
use suspension_core::statics::Loads;
use suspension_core::wheel::{CarrierRotation, Kingpin, Wheel, camber_to_ground};
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Motion, Newton, Real, Signal, Still, Tracker, Values, assemble,
};

const STEPS: usize = 1900;
const STEPS_A_ROW: usize = 100;

const GUESS: [[f64; 3]; 11] = [
    [-1.396, -0.025, -0.082],
    [-1.301, 0.1168, 0.106],
    [-1.0941, 0.1987, 0.09],
    [-0.9838, 0.2609, -0.0501],
    [-1.095, 0.183, -0.0158],
    [-1.324, 0.415, -0.059],
    [-1.327, 0.41, 0.155],
    [-1.287, 0.345, 0.14],
    [-1.29, 0.325, -0.084],
    [-1.212, 0.453, 0.089],
    [-1.287, 0.445, 0.14],
];

const LENGTHS: [f64; 14] = [
    0.445872, 0.298452, 0.247006, 0.315105, 0.311988, 0.214453, 0.214367, 0.078413, 0.098894,
    0.256446, 0.224708, 0.190070, 0.139680, 0.141405,
];

/// A number whose bits can be added to a checksum.
trait Number: Real + std::fmt::Display + std::fmt::LowerExp + Into<f64> {
    /// Adds the bits to an FNV-1a checksum.
    fn add_to(self, checksum: &mut u64);
}

macro_rules! numbers {
    ($($number:ident),*) => {
        $(impl Number for $number {
            fn add_to(self, checksum: &mut u64) {
                for byte in self.to_le_bytes() {
                    *checksum = (*checksum ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
                }
            }
        })*
    };
}
numbers!(f32, f64);

fn main() -> ExitCode {
    let done = match std::env::args().nth(1).as_deref() {
        Some("f32") => run::<f32>(),
        Some("f64") => run::<f64>(),
        _ => Err("which number? f32 or f64".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run<T: Number>() -> Result<(), Box<dyn Error>> {
    let (model, mut motion, knuckle) = set_up::<T>()?;
    let mut checksum = 0xcbf2_9ce4_8422_2325;
    println!("    t    height      rate   camber      toe  kingpin   caster");
    println!("    s         m       m/s      deg      deg      deg      deg");
    for step in 0..=STEPS {
        let milliseconds = |count: usize| T::constant(count as f64) * T::constant(0.001);
        let inputs = inputs_at(milliseconds(step));
        let dt = milliseconds(step.min(1));
        Bounded::<T>::default().step(&model, &inputs, dt, &mut motion)?;
        let row = read_wheel(&model, &inputs, &motion, &mut checksum)?;
        read_loads(&model, &inputs, &motion, &knuckle, &mut checksum)?;
        if step.is_multiple_of(STEPS_A_ROW) {
            println!("{:5.2} {row}  {checksum:016x}", step as f64 * 0.001);
        }
    }
    Ok(())
}

/// The driving angle of the paper: 0.7 + 0.5 t + 0.125 t^2 rad.
fn inputs_at<T: Number>(t: T) -> Inputs<Still, Drives<T>> {
    let [a, b, c, twice_c] = [0.7, 0.5, 0.125, 0.25].map(T::constant);
    Inputs::still(Signal {
        value: Drives {
            theta: a + (b + c * t) * t,
        },
        rate: Drives {
            theta: b + twice_c * t,
        },
        second_rate: Drives { theta: twice_c },
    })
}

/// The objects of a moving linkage.
type Moving<T> = (Model<T>, Motion<T, 15>, RigidBody<T>);

/// Returns the model, the motion at `t = 0`, and the knuckle as a rigid body.
fn set_up<T: Number>() -> Result<Moving<T>, Box<dyn Error>> {
    let guess = GUESS.map(|point| Vector3::from(point).map(T::constant));
    let guess = Points::from_values(guess);
    let lengths = Lengths::from_values(LENGTHS.map(T::constant));
    let theta = T::constant(FRAC_PI_2);
    let level = Inputs::still(Signal {
        value: Drives { theta },
        ..Signal::default()
    });
    let model = Model::new(&guess)?.with_lengths(&lengths)?;
    let mut unknowns = model.unknowns(&guess);
    assemble(&Newton::from_afar(), &model, &level, &mut unknowns)?;
    let mut motion = Motion::at_rest(unknowns);
    let mut points = motion.points(&model, &level).value;
    let knuckle = knuckle(&points);
    points.wheel_centre = points.upper_rear_outer;
    points.wheel_centre.y += T::constant(0.1);
    let model = model.with_markers(&points)?;
    let start = inputs_at(T::zero());
    Tracker::default().step_between(&model, [&level, &start], T::one(), &mut motion)?;
    Ok((model, motion, knuckle))
}

/// Returns the knuckle's mass and inertia, stated at the design position.
fn knuckle<T: Number>(points: &Points<T>) -> RigidBody<T> {
    let [xx, yy, zz, xy, yz, zx] = [0.4, 0.3, 0.35, 0.01, -0.02, 0.03].map(T::constant);
    RigidBody {
        points: held(points),
        mass: T::constant(20.0),
        centre: Vector3::new(-1.29, 0.4, 0.06).map(T::constant),
        inertia: Matrix3::new(xx, xy, zx, xy, yy, yz, zx, yz, zz),
    }
}

fn held<T: Number>(points: &Points<T>) -> [Vector3<T>; 3] {
    [
        points.lower_front_outer,
        points.upper_front_outer,
        points.track_rod_outer,
    ]
}

/// Computes the loads on the drive and in the links: weight and inertia of knuckle, track rod and a mass at
/// a joint, and 3 kN at an end of a link.
fn read_loads<T: Number>(
    model: &Model<T>,
    inputs: &Inputs<Still, Drives<T>>,
    motion: &Motion<T, 15>,
    knuckle: &RigidBody<T>,
    checksum: &mut u64,
) -> Result<(), Box<dyn Error>> {
    let points = motion.points(model, inputs);
    let gravity = Vector3::new(0.0, 0.0, -9.81).map(T::constant);
    let mut forces = Points {
        upper_front_outer: Vector3::new(200.0, -100.0, 3000.0).map(T::constant),
        ..Points::default()
    };
    let [lower, upper, track] = knuckle
        .forces(&points.map(held), &gravity)
        .ok_or("in line")?;
    forces.lower_front_outer += lower;
    forces.upper_front_outer += upper;
    forces.track_rod_outer += track;
    let accelerations = &points.second_rate;
    let ends = [accelerations.track_rod_inner, accelerations.track_rod_outer];
    let [inner, outer] = rod(T::constant(1.5), ends, &gravity);
    forces.track_rod_inner += inner;
    forces.track_rod_outer += outer;
    forces.lower_rear_outer += (gravity - accelerations.lower_rear_outer) * T::constant(0.5);
    let loads = Loads::new(model, inputs.drives.value, &motion.position, &forces)?;
    forces.values().for_each(|force| add(&force, checksum));
    loads.on_drives().theta.add_to(checksum);
    let multipliers = loads.multipliers();
    multipliers.iter().for_each(|each| each.add_to(checksum));
    Ok(())
}

/// Adds all results to the checksum and prints some of them.
fn read_wheel<T: Number>(
    model: &Model<T>,
    inputs: &Inputs<Still, Drives<T>>,
    motion: &Motion<T, 15>,
    checksum: &mut u64,
) -> Result<String, Box<dyn Error>> {
    let points = motion.points(model, inputs);
    let measures = model.measures(&points);
    let wheel = Wheel::of(points.value.wheel()).ok_or("no spin axis")?;
    let rotation =
        CarrierRotation::of(&points.map(|points| points.carrier())).ok_or("no rotation")?;
    let kingpin = Kingpin::of(points.value.kingpin(), points.value.wheel());
    for points in [&points.value, &points.rate, &points.second_rate] {
        points.values().for_each(|point| add(&point, checksum));
    }
    for measure in [&measures.value, &measures.rate, &measures.second_rate] {
        measure.height.add_to(checksum);
    }
    add(&wheel.centre, checksum);
    add(&wheel.axis, checksum);
    for angle in [wheel.camber, camber_to_ground(&wheel.axis), wheel.toe] {
        angle.add_to(checksum);
    }
    add(&rotation.omega, checksum);
    add(&rotation.alpha, checksum);
    kingpin.angle.add_to(checksum);
    kingpin.caster.add_to(checksum);
    let [height, rate] = [measures.value.height, measures.rate.height].map(T::into);
    let angles = [wheel.camber, wheel.toe, kingpin.angle, kingpin.caster];
    let [camber, toe, inclination, caster] = angles.map(|angle| angle.into().to_degrees());
    Ok(format!(
        "{height:9.5} {rate:9.5} {camber:8.4} {toe:8.4} {inclination:8.4} {caster:8.4}"
    ))
}

fn add<T: Number>(vector: &Vector3<T>, checksum: &mut u64) {
    vector.iter().for_each(|number| number.add_to(checksum));
}

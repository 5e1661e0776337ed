//! A thousand steps of fixed cost, each a different one, in a function that a tool can count:
//! `tests/instructions.rs` runs this under callgrind.
//!
//! The argument is `attia2003/f64`, `attia2003/f32`, `five_link/f64` or `five_link/f32`.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::process::ExitCode;

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::Vector3;
use suspension_core::report::Report;
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Motion, Real, Scalar, Signal, SolveError, Still, Values,
};

const STEPS: usize = 1000;
const STEP: f64 = 1e-3;

/// Attia 2003, tables 1 and 2: points 1 to 10 in metres, and a wheel centre.
const POINTS: [[f64; 3]; 11] = [
    [-1.396, -0.025, -0.082],
    [-1.301, 0.1168, 0.106],
    [-1.0941, 0.1987, 0.09],
    [-0.9838, 0.2609, -0.0501],
    [-1.095, 0.183, -0.0158],
    [-1.315, 0.400, 0.027],
    [-1.302, 0.383, 0.240],
    [-1.270, 0.315, 0.218],
    [-1.292, 0.309, -0.005],
    [-1.188, 0.418, 0.167],
    [-1.270, 0.415, 0.218],
];

fn main() -> ExitCode {
    let linkage = std::env::args().nth(1);
    let done = match linkage.as_deref() {
        Some("attia2003/f64") => steps::<f64, attia2003::Model<f64>>(),
        Some("attia2003/f32") => steps::<f32, attia2003::Model<f32>>(),
        Some("five_link/f64") => steps::<f64, five_link::Model<f64>>(),
        Some("five_link/f32") => steps::<f32, five_link::Model<f32>>(),
        _ => Err("which linkage and number? For example five_link/f64".into()),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn steps<T, L>() -> Result<(), String>
where
    T: Real + std::fmt::LowerExp,
    L: Build<15, Scalar = T, Listing: Default>,
{
    let points = POINTS.map(|point| Vector3::from(point).map(T::constant));
    let design = L::Points::from_values(points);
    let model = L::new(&design).map_err(|error| error.to_string())?;
    let start = model.drives_at(&design);
    let mut motion = Motion::at_rest(model.unknowns(&design));
    let failed = |error: SolveError<T>| error.to_string();
    let set_off = inputs::<L>(&start, 0);
    Bounded::<T>::default()
        .step(&model, &set_off, T::zero(), &mut motion)
        .map_err(failed)?;
    for step in 1..=STEPS {
        let inputs = inputs::<L>(&start, step);
        counted_step(&model, &inputs, &mut motion).map_err(failed)?;
    }
    black_box(motion);
    Ok(())
}

/// The driving angle swings up and down. It is written in all four quadrants and with whole turns,
/// of which the cosine takes no notice.
fn inputs<L: Linkage<15>>(start: &L::Drives, step: usize) -> Inputs<Still, L::Drives> {
    let number = L::Scalar::constant;
    let (amplitude, rate) = (0.1, TAU);
    let (sine, cosine) = (rate * step as f64 * STEP).sin_cos();
    let sign = if step.is_multiple_of(2) { 1.0 } else { -1.0 };
    let turns = (step % 7) as f64 - 3.0;
    let swing = number(sign * amplitude * (1.0 - cosine) + turns * TAU);
    Inputs::still(Signal {
        value: start.map(|start| number(sign) * start + swing),
        rate: start.map(|_| number(sign * amplitude * rate * sine)),
        second_rate: start.map(|_| number(sign * amplitude * rate * rate * cosine)),
    })
}

/// What is counted.
#[inline(never)]
fn counted_step<T: Real, L: Linkage<15, Scalar = T>>(
    model: &L,
    inputs: &Inputs<Still, L::Drives>,
    motion: &mut Motion<T, 15>,
) -> Result<Report<T>, SolveError<T>> {
    Bounded::<T>::default().step(model, inputs, T::constant(STEP), motion)
}

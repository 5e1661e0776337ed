//! A thousand steps of fixed cost, each a different one, in a function that a tool can count:
//! `tests/instructions.rs` runs this under callgrind.
//!
//! The argument is `attia2003/f64`, `attia2003/f32`, `five_link/f64` or `five_link/f32`; and for one lane
//! of `Lanes` `five_link/f64/avx2`, or `five_link/f64/best` for the best instructions of this processor.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::process::ExitCode;

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::Vector3;
use suspension_core::solve::report::Report;
use suspension_core::step::bounded::Outputs;
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Motion, Real, Scalar, Signal, SolveError, Still, Values,
};
use suspension_lanes::{Instructions, Lanes};

type Lane = Lanes<five_link::Listing, f64, 15, 1>;

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
        Some("five_link/f64/avx2") => steps_in_a_lane(Instructions::Avx2),
        Some("five_link/f64/best") => steps_in_a_lane(Instructions::best()),
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
    let Start {
        model,
        drives,
        at_rest: mut motion,
    } = start::<L>()?;
    let failed = |error: SolveError<T>| error.to_string();
    let set_off = inputs::<L>(&drives, 0);
    Bounded::<T>::default()
        .step(&model, &set_off, T::zero(), &mut motion)
        .map_err(failed)?;
    for step in 1..=STEPS {
        let inputs = inputs::<L>(&drives, step);
        counted_step(&model, &inputs, &mut motion).map_err(failed)?;
    }
    black_box(motion);
    Ok(())
}

fn steps_in_a_lane(instructions: Instructions) -> Result<(), String> {
    let Start {
        model,
        drives,
        at_rest,
    } = start::<five_link::Model<f64>>()?;
    let mut lane = Lane::with(instructions, [model], &[at_rest]);
    let failed = |error: SolveError<f64>| error.to_string();
    let drives = |step| inputs::<five_link::Model<f64>>(&drives, step).drives;
    let [set_off] = lane.step(Outputs::Acceleration, &[drives(0)], 0.0);
    set_off.map_err(failed)?;
    for step in 1..=STEPS {
        counted_step_in_a_lane(&mut lane, &drives(step)).map_err(failed)?;
    }
    black_box(lane.motion(0));
    Ok(())
}

/// Where the steps start.
struct Start<L: Linkage<15>> {
    model: L,
    drives: L::Drives,
    at_rest: Motion<L::Scalar, 15>,
}

fn start<L>() -> Result<Start<L>, String>
where
    L: Build<15, Scalar: Real, Listing: Default>,
{
    let points = POINTS.map(|point| Vector3::from(point).map(L::Scalar::constant));
    let design = L::Points::from_values(points);
    let model = L::new(&design).map_err(|error| error.to_string())?;
    Ok(Start {
        drives: model.drives_at(&design),
        at_rest: Motion::at_rest(model.unknowns(&design)),
        model,
    })
}

/// The driving angle swings up and down. It is written in all four quadrants and with whole turns,
/// of which the cosine takes no notice.
fn inputs<L: Linkage<15>>(design: &L::Drives, step: usize) -> Inputs<Still, L::Drives> {
    let number = L::Scalar::constant;
    let (amplitude, rate) = (0.1, TAU);
    let (sine, cosine) = (rate * step as f64 * STEP).sin_cos();
    let sign = if step.is_multiple_of(2) { 1.0 } else { -1.0 };
    let turns = (step % 7) as f64 - 3.0;
    let swing = number(sign * amplitude * (1.0 - cosine) + turns * TAU);
    Inputs::still(Signal {
        value: design.map(|design| number(sign) * design + swing),
        rate: design.map(|_| number(sign * amplitude * rate * sine)),
        second_rate: design.map(|_| number(sign * amplitude * rate * rate * cosine)),
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

/// What is counted in a lane.
#[inline(never)]
fn counted_step_in_a_lane(
    lane: &mut Lane,
    drives: &Signal<five_link::Drives<f64>>,
) -> Result<Report<f64>, SolveError<f64>> {
    let [settled] = lane.step(Outputs::Acceleration, std::array::from_ref(drives), STEP);
    settled
}

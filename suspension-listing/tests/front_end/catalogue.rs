//! The wishbones of the catalogue, symmetric as in drawings: pivots in the macro's order stay large over their whole travel.

use std::time::{Duration, Instant};

use nalgebra::Vector3;
use suspension_core::linkages::{double_wishbone, double_wishbone_pushrod};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Inputs, Motion, Signal, Values, linkages::LISTINGS};
use suspension_listing::include::NoIncludes;
use suspension_listing::{order, text};

use super::{catalogue_system, catalogue_text};

const STEP: f64 = 1e-3;

/// The points of the design position, markers last.
fn design<P: Values<Vector3<f64>>>(name: &str) -> P {
    let system = catalogue_system(name);
    let points = system.fixed.iter().chain(&system.free);
    let markers = system.markers.iter().map(|marker| marker.at);
    let at = points.map(|point| point.at).chain(markers);
    P::from_values(at.map(|at| Vector3::from(at.expect("a design position"))))
}

/// Moves the drives to and fro about the design, each once in two seconds, by attempts alone; returns the
/// largest growth.
fn swing<L, const N: usize>(name: &str, amplitudes: [f64; 2]) -> f64
where
    L: Build<N, Scalar = f64, Listing: Default>,
{
    let points: L::Points = design(name);
    let model = L::new(&points).expect("a geometry");
    let start = model.drives_at(&points);
    let moved = |wave: fn(f64) -> f64, rate: f64, t: f64| {
        let each = amplitudes.into_iter().zip([1.0, 0.7]);
        let moved = each.map(|(amplitude, pace)| {
            let frequency = std::f64::consts::PI * pace;
            amplitude * frequency.powf(rate) * wave(frequency * t)
        });
        L::Drives::from_values(moved)
    };
    let inputs = |t: f64| {
        let value = moved(f64::sin, 0.0, t);
        let value = start.values().zip(value.values()).map(|(a, b)| a + b);
        Inputs::still(Signal {
            value: L::Drives::from_values(value),
            rate: moved(f64::cos, 1.0, t),
            second_rate: moved(|phase| -phase.sin(), 2.0, t),
        })
    };
    let mut motion = Motion::at_rest(model.unknowns(&points));
    let bounded = Bounded::<f64>::default();
    let mut growth = 0.0_f64;
    for step in 0..4000 {
        let inputs = inputs(f64::from(step) * STEP);
        let settled = bounded.attempt(Outputs::Acceleration, &model, &inputs, STEP, &mut motion);
        let settled = settled.unwrap_or_else(|refusal| panic!("step {step}: {refusal:?}"));
        growth = growth.max(settled.growth());
    }
    growth
}

#[test]
fn pivot_growth_of_wishbones_is_small_over_their_travel() {
    let plain = swing::<double_wishbone::Model<f64>, 12>("double_wishbone", [0.06, 0.03]);
    let pushrod =
        swing::<double_wishbone_pushrod::Model<f64>, 27>("double_wishbone_pushrod", [0.06, 0.03]);
    println!("growth {plain:.1}, with pushrod {pushrod:.1}");
    assert!(plain < 50.0 && pushrod < 50.0, "{plain} {pushrod}");
}

#[test]
fn listings_of_the_catalogue_equal_their_files() {
    for (name, listing) in LISTINGS {
        assert_eq!(*listing, catalogue_text(name));
    }
}

/// Printed with `--nocapture`; the bound holds without optimisation on a slow computer.
#[test]
fn a_listing_of_27_unknowns_is_ordered_within_5_s() {
    let text = catalogue_text("double_wishbone_pushrod");
    let start = Instant::now();
    let system = text::parse(&text, "double_wishbone_pushrod", &NoIncludes).expect("a listing");
    let parsed = start.elapsed();
    let order = order(&system);
    let took = start.elapsed();
    println!("parsed in {parsed:?}, ordered in {:?}", took - parsed);
    assert!(order.steps.len() == 27 && took < Duration::from_secs(5));
}

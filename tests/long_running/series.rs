//! Random geometries near the published one: a step by series is the step to tolerance. Failing cases print
//! their values.

use std::sync::atomic::{AtomicUsize, Ordering};

use proptest::prelude::*;
use suspension_core::linkages::five_link::{Drives, Lengths, Model};
use suspension_core::step::series::{InputSeries, Jet, Series, SeriesTracker};
use suspension_core::{
    Build, Inputs, Linkage, Motion, Newton, Signal, Tangent, Tracker, Values, assemble,
};

use crate::support;

/// The published lengths, each changed by a part of itself.
fn stretched(by: &[f64]) -> Option<Model<f64>> {
    let model: Model<f64> = support::five_link_model();
    let lengths = model.lengths();
    let lengths_by = lengths.values().zip(by);
    let lengths = Lengths::from_values(lengths_by.map(|(length, by)| length * (1.0 + by)));
    model.with_lengths(&lengths).ok()
}

static TRIED: AtomicUsize = AtomicUsize::new(0);
static FOLLOWED: AtomicUsize = AtomicUsize::new(0);

/// Where the tracker follows a fifth of the estimated radius, the series is there within what its
/// next term may leave; a step is a root within its tolerance or leaves the motion alone.
fn check(model: &Model<f64>, theta: Signal<f64>) -> Result<bool, TestCaseError> {
    let drives = |t: f64| Signal {
        value: Drives {
            theta: theta.value + (theta.rate + 0.5 * theta.second_rate * t) * t,
        },
        rate: Drives {
            theta: theta.rate + theta.second_rate * t,
        },
        second_rate: Drives {
            theta: theta.second_rate,
        },
    };
    let inputs = |t: f64| Inputs::still(drives(t));
    let mut q = model.unknowns(&support::five_link_rough());
    let assembled = assemble(&Newton::from_afar(), model, &inputs(0.0), &mut q);
    let tangent = Tangent::new(model, &inputs(0.0), &q).and_then(|tangent| tangent.motion());
    let (Ok(_), Ok(start)) = (assembled, tangent) else {
        return Ok(false);
    };
    let ahead = InputSeries::still(Jet::of_signal(&drives(0.0)));
    let series: Series<_, 15, 10> = match Series::at(model, &ahead, &q) {
        Ok(series) => series,
        Err(error) => return Err(TestCaseError::fail(error.to_string())),
    };
    let radius = series.radius().expect("ten orders");
    let dt = 0.2 * radius;
    let mut exact: Motion<f64, 15> = start;
    Tracker::default()
        .advance(model, inputs, 0.0, dt, &mut exact)
        .map_err(|stopped| TestCaseError::fail(stopped.to_string()))?;
    let reach = start.velocity.amax() * radius + start.acceleration.amax() * radius * radius;
    let off = (series.motion(dt).position - exact.position).amax();
    prop_assert!(
        off <= 1e-7 * reach + 1e-12,
        "off by {off:e}, moves {reach:e}"
    );
    for (dt, tolerance) in [(dt, 1e-12), (0.05 * radius, 1e-12), (0.9 * radius, 1e-3)] {
        let mut motion = start;
        match SeriesTracker::within(tolerance).step(model, &ahead, dt, &mut motion) {
            Ok(_) => {
                let coordinates = model.coordinates(&drives(dt)).value;
                let residual = model.residual(&motion.position, model.fixed(), &coordinates);
                prop_assert!(residual.amax() <= 1.01 * tolerance);
            }
            Err(_) => prop_assert_eq!(motion, start),
        }
    }
    Ok(true)
}

#[test]
fn a_step_by_series_agrees_with_the_step_to_tolerance() {
    let config = crate::config(1000);
    let cases = (
        prop::collection::vec(-0.01_f64..0.01, 20),
        0.8_f64..2.0,
        -1.0_f64..1.0,
        -1.0_f64..1.0,
    );
    proptest!(config, |((by, value, rate, second_rate) in cases)| {
        TRIED.fetch_add(1, Ordering::Relaxed);
        if let Some(model) = stretched(&by)
            && check(&model, Signal { value, rate, second_rate })?
        {
            FOLLOWED.fetch_add(1, Ordering::Relaxed);
        }
    });
    let (tried, followed) = (
        TRIED.load(Ordering::Relaxed),
        FOLLOWED.load(Ordering::Relaxed),
    );
    println!("{followed} of {tried} geometries followed");
    assert!(3 * followed > tried, "{followed} of {tried}");
}

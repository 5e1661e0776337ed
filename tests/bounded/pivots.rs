//! Pivots of zero in the macro's order: partial pivoting gives the same motion.

use nalgebra::Vector3;
use suspension_core::linkage::Factors as _;
use suspension_core::linkages::attia2003::{Drives, Listing, Model, Points};
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Signal, Still, Tracker};

use crate::support::{self, differences};

/// The angle from `start` at a steady speed, at time `t`.
fn inputs(start: Drives<f64>, t: f64) -> Inputs<Still, Drives<f64>> {
    let speed = 0.5;
    Inputs::still(Signal {
        value: Drives {
            theta: start.theta + speed * t,
        },
        rate: Drives { theta: speed },
        second_rate: Drives { theta: 0.0 },
    })
}

/// Steps through the design position, where a pivot is zero, and counts the steps whose own factors are unhealthy.
fn unhealthy(model: &Model<f64>, design: &Points<f64>) -> usize {
    let start = model.drives_at(design);
    let mut motion = Motion::at_rest(model.unknowns(design));
    let bounded = Bounded::<f64, 3>::new();
    let mut count = 0;
    let mut step = |t: f64, dt: f64, motion: &mut Motion<f64, 15>| {
        let factors = model.factor(&motion.predict(dt), model.fixed());
        let growth_squared = factors.growth_squared();
        let is_unhealthy = growth_squared.is_nan() || growth_squared > 1e6;
        count += usize::from(is_unhealthy);
        let mut expected = *motion;
        let inputs = inputs(start, t);
        Tracker::default()
            .step(model, &inputs, dt, &mut expected)
            .expect("regular");
        let settled = bounded
            .step(model, &inputs, dt, motion)
            .unwrap_or_else(|error| panic!("at {t} s: {error}"));
        assert!(settled.growth() < 1e3 && settled.residual() <= settled.tolerance());
        let [position, velocity, acceleration] = differences(motion, &expected);
        assert!(position < 1e-13 && velocity < 1e-11 && acceleration < 1e-9);
        assert_eq!(motion.positive_determinant, expected.positive_determinant);
    };
    step(0.0, 0.0, &mut motion);
    for millisecond in 1..=100 {
        step(f64::from(millisecond) * 1e-3, 1e-3, &mut motion);
    }
    for millisecond in (-100..100).rev() {
        step(f64::from(millisecond) * 1e-3, -1e-3, &mut motion);
    }
    count
}

/// With link 6-1 perpendicular to an axis its derivative along that axis is zero, and along x or y it is a pivot.
#[test]
fn a_zero_pivot_on_the_way_is_solved_by_partial_pivoting() {
    let design = support::attia_rough::<f64>();
    let square_to = [Vector3::new(0.0, 0.3, 0.33), Vector3::new(0.3, 0.0, 0.33)];
    let counts = square_to.map(|link| {
        let square = Points {
            p6: design.p1 + link,
            ..design
        };
        unhealthy(&Model::of(Listing, &square).expect("a geometry"), &square)
    });
    println!("steps with unhealthy pivots: {counts:?} of 301");
    assert!(counts.iter().any(|count| *count > 0));
}

//! Our solver, as the macro writes it: iterated to a tolerance, and in a fixed number of
//! operations.

use suspension_core::linkages::attia2003::Listing;
use suspension_core::solve::factored::with_factors;
use suspension_core::step::bounded::{Bounded, Outputs};
use suspension_core::{Linkage, Newton, Tracker};
use suspension_lanes::Lanes;

use crate::{Mechanism, Method, STEP, Stopwatch};

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    to_tolerance(mechanism, watch);
    bounded(mechanism, watch);
    one_lane(mechanism, watch);
}

fn to_tolerance(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let model = &mechanism.model;
    let method = Method {
        name: "ours, to tolerance",
        // All packages of the repository have the same version.
        version: env!("CARGO_PKG_VERSION"),
        note: "geometry read at run time; steps are tested against their residual",
    };
    watch.part(&method, "newton", |start| {
        let q = start.motion.predict(STEP);
        let residual = mechanism.residual(&q, &start.inputs);
        with_factors(model, &q, model.fixed(), 0.0, |factors| {
            q - factors.solve(&residual)
        })
        .expect("regular")
    });
    watch.part(&method, "position", |start| {
        let mut q = start.motion.predict(STEP);
        Newton::near_by()
            .solve(model, &start.inputs, &mut q)
            .expect("a regular motion");
        q
    });
    watch.step(&method, |motion, inputs| {
        let mut motion = *motion;
        Tracker::default()
            .step(model, inputs, STEP, &mut motion)
            .expect("a regular motion");
        motion
    });
}

fn bounded(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let model = &mechanism.model;
    let method = Method {
        name: "ours, bounded",
        version: env!("CARGO_PKG_VERSION"),
        note: "one factorisation; geometry read at run time; tested against the residual",
    };
    let stepper: Bounded<f64> = Bounded::default();
    watch.part(&method, "position", |start| {
        let mut motion = start.motion;
        stepper
            .step_to(Outputs::Position, model, &start.inputs, STEP, &mut motion)
            .expect("a regular motion");
        motion.position
    });
    watch.step(&method, |motion, inputs| {
        let mut motion = *motion;
        stepper
            .step(model, inputs, STEP, &mut motion)
            .expect("a regular motion");
        motion
    });
}

/// The bounded step for the instructions of this processor, found out at run time.
fn one_lane(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let method = Method {
        name: "ours, one lane",
        version: env!("CARGO_PKG_VERSION"),
        note: "bounded, instructions chosen at run time; geometry read at run time; tested against the residual",
    };
    let start = |motion| Lanes::<Listing, f64, 15, 1>::new([mechanism.model], &[motion]);
    let mut lane = start(mechanism.starts[0].motion);
    watch.part(&method, "position", |start| {
        lane.set_motion(0, &start.motion);
        let [settled] = lane.step(Outputs::Position, &[start.inputs.drives], STEP);
        settled.expect("a regular motion");
        lane.motion(0).position
    });
    let mut last = f64::NAN;
    watch.step(&method, |motion, inputs| {
        // A round begins anew.
        if motion.position[0] != last {
            lane = start(*motion);
        }
        let [settled] = lane.step(Outputs::Acceleration, &[inputs.drives], STEP);
        settled.expect("a regular motion");
        let next = lane.motion(0);
        last = next.position[0];
        next
    });
}

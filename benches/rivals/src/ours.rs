//! Our solver, as the macro writes it.

use suspension_core::factored::with_factors;
use suspension_core::{Linkage, Newton, Tracker};

use crate::{Mechanism, Method, STEP, Stopwatch};

pub(crate) fn time(mechanism: &Mechanism, watch: &mut impl Stopwatch) {
    let model = &mechanism.model;
    let method = Method {
        name: "ours",
        version: suspension_version(),
        note: "geometry read at run time; every result tested against its residual",
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

/// All packages of the repository share one version.
const fn suspension_version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

//! The cost of a configuration, on the published motion.
//!
//! Ids are `group/function/linkage/number`:
//! - `kernel`: `residual`, `factor` and `solve` of the generated code;
//! - `newton`: one iteration with the macro's elimination (`generated`), with our dense LU
//!   (`dense`) and with that of `nalgebra`;
//! - `step`: the next `position`, `velocity`, `acceleration` at a fixed cost, each including the
//!   ones before it, and all of them with Newton's method `to_tolerance`;
//! - `certificate`: the proof of a root (`certify`), and what is made once for it (`certifier`);
//! - `lanes1`, `lanes4`, `lanes8`: the same in lanes, the time of a whole call; `lanes8_avx2` without instructions of 512 bits.
//!
//! Each call of a kernel or an iteration gets another instant of the motion, and each step
//! follows the last, so that no two in a row work on the same numbers.

use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use suspension_core::linkages::{attia2003, five_link};
use suspension_lanes::Lane;

#[path = "../tests/support/mod.rs"]
mod support;

mod kinematics {
    pub(crate) mod case;
    pub(crate) mod certificate;
    pub(crate) mod kernels;
    pub(crate) mod lanes;
    pub(crate) mod steps;
}

use kinematics::case::Case;
use kinematics::{certificate, kernels, lanes, steps};

fn published_motion<T: Lane + std::fmt::LowerExp>(criterion: &mut Criterion) {
    let listed = Case::<attia2003::Listing, T>::new(
        "attia2003",
        support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    );
    let rigid = Case::<five_link::Listing, T>::new(
        "five_link",
        support::five_link_model(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    kernels::bench(criterion, &listed);
    kernels::bench(criterion, &rigid);
    steps::bench(criterion, &listed);
    steps::bench(criterion, &rigid);
    certificate::bench(criterion, &listed);
    certificate::bench(criterion, &rigid);
    lanes::bench(criterion, &listed);
    lanes::bench(criterion, &rigid);
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(2));
    targets = published_motion::<f64>, published_motion::<f32>
}
criterion_main!(all);

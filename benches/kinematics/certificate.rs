//! The proof of a root, at many instants of the motion.

use std::hint::black_box;

use criterion::Criterion;
use suspension_core::certificate::Certifier;
use suspension_core::{Build, Linkage, Listing};
use suspension_lanes::Lane;

use super::case::Case;

const INSTANTS: usize = 64;
const LAST_INSTANT: f64 = 1.9;

pub(crate) fn bench<G: Listing<15>, T: Lane>(criterion: &mut Criterion, case: &Case<G, T>)
where
    G::Model<T>: Build<15> + Linkage<15, Listing = G>,
{
    let mut group = criterion.benchmark_group("certificate");
    group.bench_function(format!("certifier/{}", case.name), |bencher| {
        bencher.iter(|| Certifier::new(black_box(&case.model)));
    });
    let certifier = Certifier::new(&case.model);
    let instants: Vec<_> = (0..INSTANTS)
        .map(|k| {
            let t = LAST_INSTANT * k as f64 / (INSTANTS - 1) as f64;
            (case.inputs(t), case.motion(t).position)
        })
        .collect();
    let mut instants = instants.iter().cycle();
    group.bench_function(format!("certify/{}", case.name), |bencher| {
        bencher.iter(|| {
            let (inputs, position) = black_box(instants.next().expect("endless"));
            let certificate = black_box(&certifier).certify(inputs, position);
            assert!(certificate.is_proved());
            certificate
        });
    });
}

//! The cost of a listing read at run time: the walked model compared with the code that `linkage!` generates.
//!
//! Ids are `group/back end/linkage`:
//! - `step`: position, velocity and acceleration at a fixed cost, in steps of 1 ms along an oscillation of every
//!   drive, each step from the last;
//! - `front_end`: a model from text.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::Vector3;
use suspension_core::linkages::{LISTINGS, double_wishbone_pushrod, five_link};
use suspension_core::listing::{Kind, Parts};
use suspension_core::{Bounded, Build, Inputs, Motion, Signal, Still, Values, linkage};
use suspension_runtime::{Listing, Room, Size};

linkage! {
    pub mod axle in "run_time/axle.linkage";
}

linkage! {
    pub mod five_links in "run_time/five_links.linkage";
}

/// The listings that both back ends read.
const FIVE_LINKS: &str = include_str!("run_time/five_links.linkage");
const AXLE: &str = include_str!("run_time/axle.linkage");

/// A file beside what these include.
const BESIDE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/run_time/axle.linkage");

/// Steps of 1 ms to a period of the motion.
const STEPS: u32 = 1000;

/// Amplitude of the first drive, in metres or radians; of each further one half of that before, the other way.
const SWING: f64 = 0.02;

/// A model, and its motion.
struct Case<L: Build<N, Scalar = f64>, const N: usize> {
    model: L,
    start: Motion<f64, N>,
    /// At the end of each step of a period.
    inputs: Vec<Inputs<Still, L::Drives>>,
}

impl<L: Build<N, Scalar = f64>, const N: usize> Case<L, N> {
    fn new(listing: L::Listing, hardpoints: &[Vector3<f64>]) -> Self {
        let design = L::Points::from_values(hardpoints.iter().copied());
        let model = L::of(listing, &design).expect("a geometry");
        let rest = model.drives_at(&design);
        let mut start = Motion::at_rest(model.unknowns(&design));
        Bounded::default()
            .step(&model, &swung::<L, N>(&rest, 0.0), 0.0, &mut start)
            .expect("a regular design");
        let times = (1..=STEPS).map(|step| f64::from(step) / f64::from(STEPS));
        let inputs = times.map(|t| swung::<L, N>(&rest, t)).collect();
        Self {
            model,
            start,
            inputs,
        }
    }

    fn bench(&self, criterion: &mut Criterion, name: &str) {
        let bounded = Bounded::<f64>::default();
        let mut motion = self.start;
        let mut ahead = self.inputs.iter().cycle();
        criterion.bench_function(&format!("step/{name}"), |bencher| {
            bencher.iter(|| {
                let inputs = black_box(ahead.next().expect("a cycle"));
                bounded
                    .step(black_box(&self.model), inputs, 1e-3, &mut motion)
                    .expect("a regular motion")
            });
        });
    }
}

/// The drives at a time of the motion.
fn swung<L: Build<N, Scalar = f64>, const N: usize>(
    rest: &L::Drives,
    t: f64,
) -> Inputs<Still, L::Drives> {
    let (sine, cosine) = (TAU * t).sin_cos();
    let drives = |rest: &L::Drives, by: f64| {
        let amplitudes = std::iter::successors(Some(SWING), |last| Some(-0.5 * last));
        let drives = rest.values().zip(amplitudes);
        L::Drives::from_values(drives.map(|(rest, amplitude)| rest + by * amplitude))
    };
    let none = L::Drives::default();
    Inputs::still(Signal {
        value: drives(rest, sine),
        rate: drives(&none, TAU * cosine),
        second_rate: drives(&none, -TAU * TAU * sine),
    })
}

/// Where the listing has its points; a marker that it does not place is put at the origin.
fn hardpoints(listing: &Listing) -> Vec<Vector3<f64>> {
    let count = Kind::POINTS.map(|kind| listing.count(kind)).iter().sum();
    let mut points = vec![Vector3::zeros(); count];
    for (place, at) in listing.stated() {
        points[place] = at;
    }
    points
}

/// The text of a listing of the catalogue.
fn text(name: &str) -> &'static str {
    let listing = LISTINGS.iter().find(|(other, _)| *other == name);
    listing.expect("a listing of the catalogue").1
}

/// Times both models of a listing: that of `linkage!`, `L`, and the one with room for `M` unknowns.
fn steps<L: Build<N, Scalar = f64>, const N: usize, const M: usize>(
    criterion: &mut Criterion,
    name: &str,
    text: &str,
    written: L::Listing,
) where
    Room<M>: Size,
{
    let listing = Listing::parse_file(text, BESIDE).expect("a listing");
    let hardpoints = hardpoints(&listing);
    Case::<L, N>::new(written, &hardpoints).bench(criterion, &format!("written/{name}"));
    let walked = listing.fitted().expect("room");
    Case::<suspension_runtime::Model<'_, f64, M>, M>::new(walked, &hardpoints)
        .bench(criterion, &format!("walked/{name}"));
}

fn all_steps(criterion: &mut Criterion) {
    let (rigid, pushrod) = (text("five_link"), text("double_wishbone_pushrod"));
    steps::<five_link::Model<f64>, 15, 15>(criterion, "five_link", rigid, five_link::Listing);
    steps::<double_wishbone_pushrod::Model<f64>, 27, 30>(
        criterion,
        "double_wishbone_pushrod",
        pushrod,
        double_wishbone_pushrod::Listing,
    );
    steps::<five_links::Model<f64>, 30, 30>(
        criterion,
        "five_links",
        FIVE_LINKS,
        five_links::Listing,
    );
    steps::<axle::Model<f64>, 60, 60>(criterion, "axle", AXLE, axle::Listing);
}

/// Times the way from text to a model.
fn front_end<const M: usize>(criterion: &mut Criterion, name: &str, text: &str)
where
    Room<M>: Size,
{
    criterion.bench_function(&format!("front_end/walked/{name}"), |bencher| {
        bencher.iter(|| {
            let listing = Listing::parse(black_box(text)).expect("a listing");
            let model = listing.model::<M>(&hardpoints(&listing));
            black_box(model.expect("a geometry"));
        });
    });
}

fn front_ends(criterion: &mut Criterion) {
    front_end::<15>(criterion, "five_link", text("five_link"));
    let pushrod = "double_wishbone_pushrod";
    front_end::<30>(criterion, pushrod, text(pushrod));
    front_end::<60>(criterion, "axle", AXLE);
}

criterion_group! {
    name = all;
    config = Criterion::default()
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = all_steps, front_ends
}
criterion_main!(all);

//! Guesses of known roughness over the published motion: which assembly they lead to, the
//! enumeration being the judge.

use std::thread;

use nalgebra::SVector;
use suspension::assemblies::Assemblies;
use suspension_core::linkages::five_link;
use suspension_core::{Build, Inputs, Motion, Newton, Still, Tracker, assemble};

use super::random::Random;
use crate::support;

type Vector = SVector<f64, 15>;
type Model = five_link::Model<f64>;

/// Guesses for the rigid knuckle; for nine distances a tenth.
const GUESSES: usize = 10_000;
const INSTANTS: usize = 40;

/// An instant of the motion with all its right-handed assemblies.
struct Instant {
    t: f64,
    configuration: Vector,
    assemblies: Vec<Vector>,
}

/// The outcomes of guesses.
#[derive(Debug, Default)]
struct Tally {
    configuration: usize,
    nearest: usize,
    another: usize,
    no_root: usize,
}

fn same(a: &Vector, b: &Vector) -> bool {
    (a - b).amax() < 1e-7
}

fn instants(model: &Model) -> Vec<Instant> {
    let inputs = support::five_link_inputs;
    let mut motion = support::motions(model, &support::five_link_rough(), inputs)[0];
    let mut search = Assemblies::new(model, &motion.position, &inputs(0.0), &|_, _| true);
    let mut last = 0.0;
    (0..INSTANTS)
        .map(|index| {
            let t = 0.05 * index as f64;
            let tracked = Tracker::default().advance(model, inputs, last, t, &mut motion);
            tracked.expect("a regular motion");
            last = t;
            let census = search.at(&inputs(t)).expect("a census");
            assert!(census.tally.doubts().is_empty(), "t = {t}: {census:?}");
            let instant = Instant {
                t,
                configuration: motion.position,
                assemblies: census.real,
            };
            let mut assemblies = instant.assemblies.iter();
            assert!(assemblies.any(|q| same(q, &instant.configuration)));
            instant
        })
        .collect()
}

impl Instant {
    fn nearest(&self, guess: &Vector) -> &Vector {
        let distance = |q: &Vector| (q - guess).norm();
        let by_distance = |a: &&Vector, b: &&Vector| distance(a).total_cmp(&distance(b));
        self.assemblies.iter().min_by(by_distance).expect("some")
    }

    /// Assembles from one guess. What is returned as success must be an assembly of the list.
    fn assemble<L: Build<15, Scalar = f64>>(
        &self,
        model: &L,
        inputs: &Inputs<Still, L::Drives>,
        guess: &Vector,
        tally: &mut Tally,
    ) {
        let mut q = *guess;
        let Ok(assembly) = assemble(&Newton::from_afar(), model, inputs, &mut q) else {
            assert_eq!(q, *guess, "a failure leaves the guess");
            tally.no_root += 1;
            return;
        };
        let coordinates = model.coordinates(&inputs.drives).value;
        let residual = model.residual(&q, model.fixed(), &coordinates);
        assert!(residual.amax() < 1e-14, "silently wrong");
        assert!(
            self.assemblies.iter().any(|known| same(known, &q)),
            "unknown to the enumeration"
        );
        assert_eq!(assembly.distance, (q - guess).norm());
        if let Some(next) = assembly.next {
            let mut others = self.assemblies.iter().filter(|other| !same(other, &q));
            assert!(assembly.distance <= next);
            assert!(others.any(|other| ((other - guess).norm() - next).abs() < 1e-7));
        }
        if same(&q, &self.configuration) {
            tally.configuration += 1;
        }
        if same(&q, self.nearest(guess)) {
            tally.nearest += 1;
        } else {
            tally.another += 1;
        }
    }
}

/// Guesses with noise on all coordinates, spread over the instants.
fn tally<L: Build<15, Scalar = f64> + Sync>(
    model: &L,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
    instants: &[Instant],
    guesses: usize,
    sigma: f64,
) -> Tally {
    const SEED: u64 = 2003;
    const THREADS: usize = 2;
    let part = |first: usize| {
        let mut tally = Tally::default();
        for count in (first..guesses).step_by(THREADS) {
            let instant = &instants[count % INSTANTS];
            let mut random = Random(SEED + count as u64);
            let guess = instant.configuration + random.noise(sigma);
            instant.assemble(model, &inputs(instant.t), &guess, &mut tally);
        }
        tally
    };
    let total = thread::scope(|scope| {
        let start = |first| scope.spawn(move || part(first));
        let parts: Vec<_> = (0..THREADS).map(start).collect();
        let parts = parts.into_iter().map(|part| part.join().expect("no panic"));
        parts.fold(Tally::default(), |a, b| Tally {
            configuration: a.configuration + b.configuration,
            nearest: a.nearest + b.nearest,
            another: a.another + b.another,
            no_root: a.no_root + b.no_root,
        })
    });
    println!("{guesses} guesses, sigma {sigma} m, seed {SEED}: {total:?}");
    total
}

#[test]
fn rough_guesses_lead_to_the_nearest_assembly() {
    let model = support::five_link_model();
    let instants = instants(&model);
    let inputs = support::five_link_inputs;
    let [one, two, five] =
        [0.01, 0.02, 0.05].map(|sigma| tally(&model, inputs, &instants, GUESSES, sigma));
    assert_eq!(one.configuration, GUESSES);
    assert!(two.configuration * 1000 >= GUESSES * 999, "{two:?}");
    assert!(five.nearest * 100 >= GUESSES * 99, "{five:?}");
    let links = support::attia_model();
    let inputs = support::attia_inputs;
    let [one, five] =
        [0.01, 0.05].map(|sigma| tally(&links, inputs, &instants, GUESSES / 10, sigma));
    assert_eq!(one.configuration, GUESSES / 10);
    assert!(five.nearest * 100 >= GUESSES / 10 * 99, "{five:?}");
}

/// Where the mechanism has two assemblies that lie close together the result says so.
#[test]
fn a_neighbouring_assembly_is_reported() {
    let model = support::five_link_model();
    let inputs = support::five_link_inputs(1.95);
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    let Some(Motion { position, .. }) = motions.last() else {
        panic!("nine motions")
    };
    let mut q = position + Random(1).noise(0.03);
    let assembly = assemble(&Newton::from_afar(), &model, &inputs, &mut q).expect("a root");
    let next = assembly.next.expect("another root is near");
    assert!(next - assembly.distance < 0.104, "{assembly:?}");
}

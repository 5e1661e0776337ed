//! From any text to a listing, a model if it states its points, and its steps; or mistakes with their places.
#![cfg_attr(feature = "fuzzer", no_main)]

use libfuzzer_sys::fuzz_target;
use nalgebra::Vector3;
use suspension_core::listing::{Kind, Parts};
use suspension_core::{Bounded, Build, Inputs, Linkage, Motion, Signal, Tracker, Values};
use suspension_runtime::{Fitted, Listing, Mistakes, Model, Room, Size, Work};

/// Steps of each kind.
const STEPS: usize = 2;

/// A model at hardpoints, and steps of it.
struct Steps(Vec<Vector3<f64>>);

impl Work for Steps {
    type Answer = ();

    fn on<const N: usize>(self, listing: Fitted<'_, N>)
    where
        Room<N>: Size,
    {
        let design = Values::from_values(self.0);
        let Ok(model) = Model::<f64, N>::of(listing, &design) else {
            return;
        };
        let drives = model.drives_at(&design);
        let inputs = Inputs::still(Signal {
            value: drives,
            ..Signal::default()
        });
        let q = model.unknowns(&design);
        let coordinates = model.coordinates(&inputs.drives).value;
        let fixed = model.drive_anchors(*model.fixed(), &coordinates);
        let residual = model.residual(&q, &fixed, &coordinates);
        assert_eq!(residual.len(), N);
        let (mut bounded, mut tracked) = (Motion::at_rest(q), Motion::at_rest(q));
        for _ in 0..STEPS {
            let before = bounded;
            if Bounded::<f64>::default()
                .step(&model, &inputs, 1e-3, &mut bounded)
                .is_err()
            {
                assert_eq!(bits(&bounded), bits(&before));
            }
            // Errors are accepted like steps here: `solver` tests them.
            let _ = Tracker::default().step(&model, &inputs, 1e-3, &mut tracked);
        }
    }
}

/// Returns the bits of any numbers, NaN included.
fn bits<const N: usize>(motion: &Motion<f64, N>) -> Vec<u64> {
    let Motion {
        position,
        velocity,
        acceleration,
        ..
    } = motion;
    let numbers = position.iter().chain(velocity).chain(acceleration);
    numbers.map(|number| number.to_bits()).collect()
}

/// Names and places of all parts, which a listing that is read has.
fn read_parts(listing: &Listing) {
    let points: usize = Kind::POINTS.map(|kind| listing.count(kind)).iter().sum();
    let ends = listing.links().into_iter().flatten();
    let carried = listing.bodies().into_iter().flatten();
    assert!(ends.chain(carried).all(|place| place < points));
    assert!(listing.stated().all(|(place, _)| place < points));
    assert!(listing.count(Kind::Unknown) <= 120);
}

/// Every mistake is at a place in the text, or at its end.
fn check(text: &str, refused: &Mistakes) {
    assert!(!refused.mistakes.is_empty());
    assert!(!refused.to_string().is_empty());
    let lines = text.split('\n').count();
    for mistake in &refused.mistakes {
        assert!((1..=lines + 1).contains(&mistake.line), "{mistake:?}");
        assert!(mistake.column >= 1, "{mistake:?}");
    }
}

fuzz_target!(|text: &str| {
    match Listing::parse(text) {
        Ok(listing) => {
            read_parts(&listing);
            if let Some(hardpoints) = listing.design() {
                listing.in_its_size(Steps(hardpoints));
            }
        }
        Err(refused) => check(text, &refused),
    }
});

#[cfg(not(feature = "fuzzer"))]
fn main() {
    panic!("this target is linked without the fuzzer; tests/fuzz/README.md says how to run it");
}

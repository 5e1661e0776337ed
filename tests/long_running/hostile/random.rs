//! A million random mechanisms, hostile ones among them; the same with shrinking, by proptest.

use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng};
use suspension_core::linkages::{attia2003, five_link};

use super::draw::Draw;
use super::mechanisms::{four_bar, rocker};
use super::reached::Reached;
use super::trial::{briefly, everything};

/// Runs cases out of one generator, and demands that enough came far enough to matter.
fn run_many<L>(cases: usize, seed: u8, run: fn(&mut Draw<'_>) -> Reached) {
    let mut generator = TestRng::from_seed(RngAlgorithm::ChaCha, &[seed; 32]);
    let mut words = || generator.next_u32();
    let mut all = Reached::default();
    for _ in 0..cases {
        all.add(run(&mut Draw::new(&mut words)));
    }
    println!("{}, seed {seed}: {all:?}", std::any::type_name::<L>());
    assert!(5 * all.assembled > all.tried, "{all:?}");
    assert!(
        2 * all.stepped > all.tried && all.refused > all.tried / 2,
        "{all:?}"
    );
}

#[test]
fn half_a_million_random_f64_mechanisms_are_solved_or_refused() {
    run_many::<four_bar::Model<f64>>(300_000, 1, briefly::<f64, four_bar::Model<f64>, 6>);
    run_many::<rocker::Model<f64>>(200_000, 2, briefly::<f64, rocker::Model<f64>, 6>);
}

#[test]
fn half_a_million_random_f32_mechanisms_are_solved_or_refused() {
    run_many::<four_bar::Model<f32>>(300_000, 3, briefly::<f32, four_bar::Model<f32>, 6>);
    run_many::<rocker::Model<f32>>(200_000, 4, briefly::<f32, rocker::Model<f32>, 6>);
}

#[test]
fn random_suspensions_are_solved_or_refused() {
    run_many::<five_link::Model<f64>>(1_000, 5, everything::<f64, five_link::Model<f64>, 15>);
    run_many::<five_link::Model<f32>>(1_000, 6, everything::<f32, five_link::Model<f32>, 15>);
    run_many::<attia2003::Model<f64>>(1_000, 7, everything::<f64, attia2003::Model<f64>, 15>);
    run_many::<attia2003::Model<f32>>(1_000, 8, everything::<f32, attia2003::Model<f32>, 15>);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..Default::default() })]

    /// Shrinks a case that fails to its fewest and smallest words.
    #[test]
    fn mechanisms_of_random_words_are_solved_or_refused(words in prop::collection::vec(any::<u32>(), 0..200)) {
        for run in [
            everything::<f64, four_bar::Model<f64>, 6>,
            everything::<f32, four_bar::Model<f32>, 6>,
            everything::<f64, rocker::Model<f64>, 6>,
            everything::<f32, rocker::Model<f32>, 6>,
            everything::<f64, five_link::Model<f64>, 15>,
            everything::<f32, five_link::Model<f32>, 15>,
        ] as [fn(&mut Draw<'_>) -> Reached; 6] {
            let mut rest = words.iter().copied();
            run(&mut Draw::new(&mut || rest.next().unwrap_or_default()));
        }
    }
}

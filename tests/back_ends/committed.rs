//! Random listings that are also compiled: the generator's first few, as files.

use suspension_core::{Build, Values};
use suspension_runtime::{Listing, Model};

use crate::back_ends::{hardpoints, near};
use crate::random;
use crate::twins::{Twins, same_parts};

/// Free points of each, about.
const FREE: usize = 4;

macro_rules! listings {
    ($($name:ident: $file:literal, $seed:literal, $n:literal in $m:literal;)*) => {
        $(suspension_core::linkage! { mod $name in $file; })*

        /// The files by seed.
        const FILES: &[(u64, &str)] = &[$(($seed, include_str!($file))),*];

        #[test]
        fn random_listings_are_walked_as_they_are_written() {
            $({
                let listing = Listing::parse(include_str!($file)).expect("a listing");
                same_parts(&$name::Listing, &listing);
                let mut random = fastrand::Rng::with_seed($seed);
                let points = hardpoints(&listing, &mut random);
                let design = $name::Points::from_values(points.iter().copied());
                let walked = Model::<f64, $m>::of(
                    listing.fitted().expect("room"),
                    &Values::from_values(points),
                );
                match ($name::Model::of($name::Listing, &design), walked) {
                    (Ok(written), Ok(walked)) => {
                        let twins = Twins::<_, _, $n, $m> { written, walked };
                        for _ in 0..20 {
                            let points = [0.05, 2.0, 30.0];
                            let points = points.map(|by| near(&design, by, &mut random));
                            twins.compare_functions(&points);
                            twins.with_lengths_of(&points[0]);
                        }
                    }
                    (refused, also) => assert_eq!(refused.err(), also.err()),
                }
            })*
        }
    };
}

listings! {
    random_0: "listings/random_0.linkage", 0, 24 in 30;
    random_1: "listings/random_1.linkage", 1, 12 in 15;
    random_2: "listings/random_2.linkage", 2, 18 in 30;
    random_3: "listings/random_3.linkage", 3, 17 in 30;
    random_4: "listings/random_4.linkage", 4, 18 in 30;
    random_5: "listings/random_5.linkage", 5, 15 in 15;
    random_6: "listings/random_6.linkage", 6, 15 in 15;
    random_7: "listings/random_7.linkage", 7, 12 in 15;
    random_8: "listings/random_8.linkage", 8, 21 in 30;
    random_9: "listings/random_9.linkage", 9, 12 in 15;
    random_10: "listings/random_10.linkage", 10, 15 in 15;
    random_11: "listings/random_11.linkage", 11, 12 in 15;
}

#[test]
fn the_files_are_the_generators() {
    for (seed, file) in FILES {
        let text = random::listing(*seed, FREE);
        assert!(
            text == *file,
            "write this in place of random_{seed}.linkage:\n{text}"
        );
    }
}

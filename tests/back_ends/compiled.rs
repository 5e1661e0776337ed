//! Random listings that are also compiled: as many as the build script has written.

use suspension_core::{Build, Values};
use suspension_runtime::{Listing, Model};

use crate::back_ends::{hardpoints, near};
use crate::twins::{Twins, same_parts};

macro_rules! listings {
    ($($name:ident: $seed:literal, $n:literal in $m:literal, $text:literal { $($statements:tt)* })*) => {
        $(suspension_core::linkage! { mod $name { $($statements)* } })*

        /// One function per listing, so that no stack holds them all.
        mod compare {
            use super::*;

            $(pub(super) fn $name() {
                println!(stringify!($name));
                let listing = Listing::parse($text).expect("a listing");
                same_parts(&super::$name::Listing, &listing);
                let mut random = fastrand::Rng::with_seed($seed);
                let points = hardpoints(&listing, &mut random);
                let design = super::$name::Points::from_values(points.iter().copied());
                let walked = Model::<f64, $m>::of(
                    listing.fitted().expect("room"),
                    &Values::from_values(points),
                );
                let twins = Twins::<_, _, $n, $m> {
                    written: super::$name::Model::of(super::$name::Listing, &design)
                        .expect("a geometry"),
                    walked: walked.expect("a geometry"),
                };
                for _ in 0..20 {
                    let mut near = |by| near(&design, by, &mut random);
                    let points = [near(0.05), near(2.0), near(30.0)];
                    twins.compare_functions(&points);
                    twins.with_lengths_of(&points[0]);
                }
            })*
        }

        #[test]
        fn both_back_ends_compute_the_same_bits_for_random_listings() {
            $(compare::$name();)*
        }
    };
}

include!(concat!(env!("OUT_DIR"), "/random_listings.rs"));

//! Every listing of the catalogue through both back ends.

use nalgebra::Vector3;
use suspension_core::linkages::{
    self, attia2003, double_wishbone, double_wishbone_pushrod, five_link,
};
use suspension_core::{Build, Values};
use suspension_runtime::{Listing, Model};

use crate::twins::{Number, Twins, same_parts};

fn text(name: &str) -> &'static str {
    let mut listings = linkages::LISTINGS.iter();
    listings
        .find(|(other, _)| *other == name)
        .expect("in the catalogue")
        .1
}

/// Points near others.
fn near<T: Number, P: Values<Vector3<T>>>(points: &P, by: f64, random: &mut fastrand::Rng) -> P {
    let moved = points
        .values()
        .map(|point| point.map(|x| x + T::constant(by * (2.0 * random.f64() - 1.0))));
    P::from_values(moved.collect::<Vec<_>>())
}

macro_rules! compare {
    ($listing:ident, $n:literal, $number:ty, $m:literal, $swing:literal) => {{
        let listing = Listing::parse(text(stringify!($listing))).expect("a listing");
        same_parts(&$listing::Listing, &listing);
        let hardpoints = listing.design().unwrap_or_else(|| {
            let mut hardpoints: Vec<_> = listing.stated().map(|(_, at)| at).collect();
            hardpoints.push(Vector3::new(-1.27, 0.415, 0.218));
            hardpoints
        });
        let number = |x: f64| x as $number;
        let points = hardpoints.iter().map(|point| point.map(number));
        let design = $listing::Points::from_values(points.clone());
        let walked = Model::<$number, $m>::of(
            listing.fitted().expect("room"),
            &Values::from_values(points),
        );
        let twins = Twins::<_, _, $n, $m> {
            written: $listing::Model::new(&design).expect("a geometry"),
            walked: walked.expect("a geometry"),
        };
        let mut random = fastrand::Rng::with_seed(7);
        for _ in 0..20 {
            let points = [0.05, 2.0, 30.0].map(|by| near(&design, by, &mut random));
            twins.compare_functions(&points);
            let other = near(&design, 0.01, &mut random);
            if let Some(others) = twins.with_lengths_of(&other) {
                others.compare_functions(&points);
            }
        }
        assert_eq!(twins.compare_motion(&design, number($swing)), 200);
    }};
}

#[test]
fn a_listing_is_walked_as_it_is_written() {
    compare!(five_link, 15, f64, 15, 0.1);
    compare!(attia2003, 15, f64, 15, 0.1);
    compare!(double_wishbone, 12, f64, 15, 0.03);
    compare!(double_wishbone_pushrod, 27, f64, 30, 0.03);
}

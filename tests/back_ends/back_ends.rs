//! Listings through both back ends: the same names, counts and order, and the same bits.

use nalgebra::Vector3;
use suspension_core::linkages::{
    self, attia2003, double_wishbone, double_wishbone_pushrod, five_link,
};
use suspension_core::listing::{Kind, Parts};
use suspension_core::{Build, Values};
use suspension_runtime::{Listing, Model};

use crate::twins::{Number, Twins, same_parts};

/// A listing in both back ends from one file.
macro_rules! listings {
    ($($name:ident: $file:literal),* $(,)?) => {
        $(suspension_core::linkage! { mod $name in $file; })*

        /// The texts by name.
        const TEXTS: &[(&str, &str)] = &[$((stringify!($name), include_str!($file))),*];
    };
}

listings! {
    actuators: "listings/actuators.linkage",
    angles: "listings/angles.linkage",
    couples: "listings/couples.linkage",
    crank: "listings/crank.linkage",
    double_carrier: "listings/double_carrier.linkage",
    factors: "listings/factors.linkage",
    guides: "listings/guides.linkage",
    live_axle_watt: "../../suspension-core/src/linkages/live_axle_watt.linkage",
    macpherson: "../../suspension-core/src/linkages/macpherson.linkage",
    macpherson_two_links: "../../suspension-core/src/linkages/macpherson_two_links.linkage",
    pillar: "listings/pillar.linkage",
    rotary: "listings/rotary.linkage",
    tripod: "listings/tripod.linkage",
    trombone: "listings/trombone.linkage",
    twist_beam: "../../suspension-core/src/linkages/twist_beam.linkage",
}

fn text(name: &str) -> &'static str {
    let mut texts = linkages::LISTINGS.iter().chain(TEXTS);
    texts
        .find(|(other, _)| *other == name)
        .expect("a listing")
        .1
}

/// Points near others.
pub(crate) fn near<T: Number, P: Values<Vector3<T>>>(
    points: &P,
    by: f64,
    random: &mut fastrand::Rng,
) -> P {
    let mut near = |x| x + T::constant(by * (2.0 * random.f64() - 1.0));
    P::from_values(points.values().map(|point| point.map(&mut near)))
}

/// Returns the points that the listing states, and random ones for the others.
pub(crate) fn hardpoints(listing: &Listing, random: &mut fastrand::Rng) -> Vec<Vector3<f64>> {
    let count = Kind::POINTS.map(|kind| listing.count(kind)).iter().sum();
    let mut points = vec![Vector3::zeros(); count];
    points.fill_with(|| Vector3::from_fn(|_, _| random.f64()));
    for (place, at) in listing.stated() {
        points[place] = at;
    }
    points
}

macro_rules! compare {
    ($listing:ident, $n:literal, $number:ty, $m:literal, $steps:expr) => {{
        let listing = Listing::parse(text(stringify!($listing))).expect("a listing");
        same_parts(&$listing::Listing, &listing);
        let mut random = fastrand::Rng::with_seed(7);
        let points = hardpoints(&listing, &mut random);
        let points = points.iter().map(|point| point.map(|x| x as $number));
        let design = $listing::Points::from_values(points.clone());
        let walked = Model::<$number, $m>::of(
            listing.fitted().expect("room"),
            &Values::from_values(points),
        );
        let twins = Twins::<_, _, $n, $m> {
            written: $listing::Model::of($listing::Listing, &design).expect("a geometry"),
            walked: walked.expect("a geometry"),
        };
        for _ in 0..20 {
            let points = [0.05, 2.0, 30.0].map(|by| near(&design, by, &mut random));
            twins.compare_functions(&points);
            let other = near(&design, 0.01, &mut random);
            if let Some(others) = twins.with_lengths_of(&other) {
                others.compare_functions(&points);
            }
        }
        let steps: usize = $steps;
        if steps > 0 {
            assert_eq!(twins.compare_motion(&design, 0.02), steps);
        }
    }};
}

#[test]
fn both_back_ends_compute_the_same_bits_for_the_catalogue() {
    compare!(five_link, 15, f64, 15, 200);
    compare!(attia2003, 15, f64, 15, 200);
    compare!(double_wishbone, 12, f64, 15, 200);
    compare!(double_wishbone_pushrod, 27, f64, 30, 200);
}

#[test]
fn both_back_ends_compute_the_same_bits_in_f32_and_larger_models() {
    compare!(five_link, 15, f32, 15, 200);
    compare!(five_link, 15, f64, 60, 200);
    compare!(double_wishbone_pushrod, 27, f32, 60, 200);
}

#[test]
fn both_back_ends_compute_the_same_bits_for_every_statement() {
    compare!(actuators, 11, f64, 15, 200);
    compare!(angles, 15, f64, 15, 200);
    compare!(couples, 6, f64, 15, 200);
    compare!(crank, 6, f64, 15, 0);
    compare!(double_carrier, 18, f64, 30, 200);
    compare!(factors, 9, f64, 15, 200);
    compare!(guides, 19, f64, 30, 200);
    compare!(pillar, 11, f64, 15, 0);
    compare!(rotary, 38, f64, 60, 200);
    compare!(tripod, 12, f64, 15, 0);
    compare!(trombone, 13, f64, 15, 0);
}

#[test]
fn both_back_ends_compute_the_same_bits_for_uncompiled_layouts() {
    compare!(macpherson, 16, f64, 30, 200);
    compare!(macpherson_two_links, 19, f64, 30, 200);
    compare!(macpherson_two_links, 19, f32, 30, 200);
    compare!(live_axle_watt, 27, f64, 30, 200);
    compare!(twist_beam, 20, f64, 30, 200);
}

//! The types of one, four and eight lanes of a number.

use fearless_simd::{f32x4, f32x8, f64x4, f64x8};
use suspension_core::{Listing, Real};

use crate::engine::{Engine, Halves, Vectors};
use crate::number::{Fused, Token};

type Boxed<G, T, const N: usize, const LANES: usize> = Box<dyn Engine<G, T, N, LANES>>;

macro_rules! engine_of {
    ($name:ident, $lanes:literal) => {
        /// An engine with this number of lanes, for the instructions that `S` proves.
        fn $name<G, S, const N: usize, const CORRECTIONS: usize, const ORDER: usize>(
            proof: S,
            models: [&G::Model<Self>; $lanes],
        ) -> Boxed<G, Self, N, $lanes>
        where
            G: Listing<N> + 'static,
            S: Token;
    };
}

/// A number type that comes in lanes.
pub trait Lane: Real {
    engine_of!(one_lane, 1);
    engine_of!(four_lanes, 4);
    engine_of!(eight_lanes, 8);
}

macro_rules! engine {
    ($name:ident, $lanes:literal, $vector:ty) => {
        fn $name<G, S, const N: usize, const CORRECTIONS: usize, const ORDER: usize>(
            proof: S,
            models: [&G::Model<Self>; $lanes],
        ) -> Boxed<G, Self, N, $lanes>
        where
            G: Listing<N> + 'static,
            S: Token,
        {
            Box::new(Vectors::<G, $vector, N, CORRECTIONS, ORDER>::new(
                proof, models,
            ))
        }
    };
}

impl Lane for f32 {
    engine!(one_lane, 1, Fused<S, f32>);
    engine!(four_lanes, 4, f32x4<S>);
    engine!(eight_lanes, 8, f32x8<S>);
}

impl Lane for f64 {
    engine!(one_lane, 1, Fused<S, f64>);
    engine!(four_lanes, 4, f64x4<S>);

    /// In one pass if a register holds eight: this takes two thirds of the time of two halves on processors whose
    /// units are as wide, and no longer on others. Otherwise in two halves, because there are not enough pairs of
    /// registers.
    fn eight_lanes<G, S, const N: usize, const CORRECTIONS: usize, const ORDER: usize>(
        proof: S,
        models: [&G::Model<Self>; 8],
    ) -> Boxed<G, Self, N, 8>
    where
        G: Listing<N> + 'static,
        S: Token,
    {
        if S::REGISTER_BITS >= 512 {
            return Box::new(Vectors::<G, f64x8<S>, N, CORRECTIONS, ORDER>::new(
                proof, models,
            ));
        }
        let [a, b, c, d, e, f, g, h] = models;
        let half = |models| Vectors::<G, f64x4<S>, N, CORRECTIONS, ORDER>::new(proof, models);
        Box::new(Halves([half([a, b, c, d]), half([e, f, g, h])]))
    }
}

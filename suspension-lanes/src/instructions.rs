//! The instruction sets, and the choice of one when lanes are made.

#[cfg(target_arch = "x86_64")]
use fearless_simd::{Avx2, Avx512, Level};
use suspension_core::{Listing, Motion};

use super::Lanes;
use crate::engine::Engine;
use crate::lane::Lane;
use crate::plain::Plain;

/// The instruction set that runs the lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Instructions {
    /// Instructions that every processor of the target has: one lane after the other.
    Plain,
    /// Vectors of 256 bits, and fused multiply-add.
    Avx2,
    /// Vectors of 512 bits.
    Avx512,
}

impl Instructions {
    /// The best instructions that this processor has.
    pub fn best() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            let level = Level::new();
            if level.as_avx512().is_some() {
                return Self::Avx512;
            }
            if level.as_avx2().is_some() {
                return Self::Avx2;
            }
        }
        Self::Plain
    }
}

/// The possible numbers of lanes, and the types that they consist of.
macro_rules! lanes {
    ($lanes:literal, $engine:ident) => {
        impl<G, T, const N: usize, const CORRECTIONS: usize, const ORDER: usize>
            Lanes<G, T, N, $lanes, CORRECTIONS, ORDER>
        where
            G: Listing<N> + 'static,
            T: Lane,
        {
            /// Creates lanes for the best instructions that this processor has.
            pub fn new(models: [G::Model<T>; $lanes], motions: &[Motion<T, N>; $lanes]) -> Self {
                Self::with(Instructions::best(), models, motions)
            }

            /// Creates lanes for the chosen instructions, or for as many of them as this processor has.
            pub fn with(
                instructions: Instructions,
                models: [G::Model<T>; $lanes],
                motions: &[Motion<T, N>; $lanes],
            ) -> Self {
                let engine = Self::vectors(instructions, &models).unwrap_or_else(|| {
                    Box::new(Plain::<G, T, N, $lanes, CORRECTIONS, ORDER>::new(models))
                });
                Self::from_engine(engine, models, motions)
            }

            #[cfg(target_arch = "x86_64")]
            fn vectors(
                instructions: Instructions,
                models: &[G::Model<T>; $lanes],
            ) -> Option<Box<dyn Engine<G, T, N, $lanes>>> {
                let level = Level::new();
                let models = models.each_ref();
                let wide = level
                    .as_avx512()
                    .filter(|_| instructions == Instructions::Avx512);
                let narrow = level
                    .as_avx2()
                    .filter(|_| instructions != Instructions::Plain);
                match (wide, narrow) {
                    (Some(proof), _) => Some(T::$engine::<G, Avx512, N, CORRECTIONS, ORDER>(
                        proof, models,
                    )),
                    (None, Some(proof)) => {
                        Some(T::$engine::<G, Avx2, N, CORRECTIONS, ORDER>(proof, models))
                    }
                    (None, None) => None,
                }
            }

            #[cfg(not(target_arch = "x86_64"))]
            fn vectors(
                _: Instructions,
                _: &[G::Model<T>; $lanes],
            ) -> Option<Box<dyn Engine<G, T, N, $lanes>>> {
                None
            }
        }
    };
}

lanes!(1, one_lane);
lanes!(4, four_lanes);
lanes!(8, eight_lanes);

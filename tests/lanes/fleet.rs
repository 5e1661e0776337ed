//! Different linkages, one per lane, each driven in its own way.

use nalgebra::{SVector, Vector3};
use suspension_core::{Bounded, Build, Inputs, Linkage, Listing, Motion, Real, Signal, Values};
use suspension_lanes::{Instructions, Lane, Lanes};

pub(crate) const ALL: [Instructions; 3] = [
    Instructions::Plain,
    Instructions::Avx2,
    Instructions::Avx512,
];

/// Lanes of any number, for instructions of choice.
pub(crate) trait Make<G: Listing<15> + Default, T: Lane, const LANES: usize>: Sized {
    fn make(fleet: &Fleet<G, T, LANES>, instructions: Instructions) -> Self;
}

macro_rules! make {
    ($($lanes:literal)*) => {$(
        impl<G: Listing<15> + Default + 'static, T: Lane> Make<G, T, $lanes> for Lanes<G, T, 15, $lanes> {
            fn make(fleet: &Fleet<G, T, $lanes>, instructions: Instructions) -> Self {
                Self::with(instructions, fleet.models, &fleet.starts)
            }
        }
    )*};
}

make!(1 4 8);

pub(crate) struct Fleet<G: Listing<15>, T: Lane, const LANES: usize> {
    pub(crate) models: [G::Model<T>; LANES],
    /// The motions at `t = 0`.
    pub(crate) starts: [Motion<T, 15>; LANES],
    /// The angles at `t = 0`.
    at_start: [G::Drives<T>; LANES],
}

impl<G: Listing<15> + Default, T: Lane, const LANES: usize> Fleet<G, T, LANES>
where
    G::Model<T>: Build<15>,
{
    /// The points displaced by up to 5 mm, in each lane in another way.
    pub(crate) fn displaced(rough: &G::Points<T>) -> Self {
        Self::new(std::array::from_fn(|lane| {
            let points = rough.values().enumerate();
            G::Points::from_values(points.map(|(index, point)| {
                let by = |axis: usize| {
                    let crooked = (lane * 7919 + index * 104_729 + axis * 1_299_709 + 17) % 1009;
                    T::constant((crooked as f64 / 504.5 - 1.0) * 5e-3)
                };
                point + Vector3::new(by(0), by(1), by(2))
            }))
        }))
    }

    /// Makes a fleet from the positions of points.
    pub(crate) fn new(designs: [G::Points<T>; LANES]) -> Self {
        let models =
            designs.map(|design| G::Model::<T>::of(G::default(), &design).expect("a geometry"));
        let at_start = std::array::from_fn(|lane| models[lane].drives_at(&designs[lane]));
        let mut fleet = Self {
            models,
            starts: std::array::from_fn(|lane| {
                Motion::at_rest(models[lane].unknowns(&designs[lane]))
            }),
            at_start,
        };
        let drives = fleet.drives(0.0);
        for (lane, drives) in drives.into_iter().enumerate() {
            let mut motion = fleet.starts[lane];
            Bounded::<T, 3>::new()
                .step(
                    &fleet.models[lane],
                    &Inputs::still(drives),
                    T::zero(),
                    &mut motion,
                )
                .expect("the design is a configuration");
            fleet.starts[lane] = motion;
        }
        fleet
    }

    pub(crate) fn lanes(&self, instructions: Instructions) -> Lanes<G, T, 15, LANES>
    where
        Lanes<G, T, 15, LANES>: Make<G, T, LANES>,
    {
        Make::make(self, instructions)
    }

    /// Each lane's angle at time `t`, faster from lane to lane.
    pub(crate) fn drives(&self, t: f64) -> [Signal<G::Drives<T>>; LANES] {
        std::array::from_fn(|lane| {
            let speed = 0.2 + 0.05 * lane as f64;
            let number = T::constant;
            let start = &self.at_start[lane];
            Signal {
                value: start.map(|start| start + number(speed * t + 0.05 * t * t)),
                rate: start.map(|_| number(speed + 0.1 * t)),
                second_rate: start.map(|_| number(0.1)),
            }
        })
    }
}

/// The numbers of a motion as they are.
pub(crate) fn bits<T: Real>(motion: &Motion<T, 15>) -> ([SVector<u64, 15>; 3], Option<bool>) {
    let of = |vector: &SVector<T, 15>| vector.map(|x| x.to_subset().map_or(0, f64::to_bits));
    let all = [&motion.position, &motion.velocity, &motion.acceleration];
    (all.map(of), motion.positive_determinant)
}

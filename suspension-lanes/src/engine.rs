//! The step in lanes, compiled for each set of instructions.

use fearless_simd::Simd;
use nalgebra::SVector;
use suspension_core::solve::motion::Prescribed;
use suspension_core::step::bounded::{Evidence, Outputs, Step};
use suspension_core::{Inputs, Listing, Motion, Real, Signal, Still, Values};

use crate::number::{Number, Vector};

/// Models and motions in lanes, independent of the instruction set.
pub trait Engine<G: Listing<N>, T: Real, const N: usize, const LANES: usize>: Send + Sync {
    /// Computes the next motion of all lanes, which is then judged.
    fn attempt(
        &mut self,
        outputs: Outputs,
        drives: &[Signal<G::Drives<T>>; LANES],
        dt: T,
    ) -> [Evidence<T>; LANES];

    /// Makes the next motion of all lanes the last one.
    fn accept(&mut self);

    /// The last motion of a lane.
    fn motion(&self, lane: usize) -> Motion<T, N>;

    /// The attempted motion of a lane.
    fn next(&self, lane: usize) -> Motion<T, N>;

    /// Sets the last motion of a lane.
    fn set_motion(&mut self, lane: usize, motion: &Motion<T, N>);

    /// Sets the models of all lanes.
    fn set_models(&mut self, models: [&G::Model<T>; LANES]);
}

/// Lanes as vectors of numbers `V`, in code for the instructions that they need.
pub(crate) struct Vectors<
    G: Listing<N>,
    V: Vector,
    const N: usize,
    const CORRECTIONS: usize,
    const ORDER: usize,
> {
    model: G::Model<Number<V>>,
    /// The last motion and the next one, which alternate.
    motions: [Motion<Number<V>, N>; 2],
    last: usize,
    proof: V::Proof,
}

impl<G, V, const N: usize, const CORRECTIONS: usize, const ORDER: usize>
    Vectors<G, V, N, CORRECTIONS, ORDER>
where
    G: Listing<N>,
    V: Vector<Lane: Real>,
{
    /// Lanes at rest, with one model each.
    pub(crate) fn new<const LANES: usize>(
        proof: V::Proof,
        models: [&G::Model<V::Lane>; LANES],
    ) -> Self {
        let at_rest = Motion::at_rest(SVector::from([Number::default(); N]));
        Self {
            model: packed_models::<G, V, N, LANES>(models),
            motions: [at_rest; 2],
            last: 0,
            proof,
        }
    }
}

/// Makes the function that it is inlined into align its frame for whole vectors. Without a variable that requires
/// this, vectors are spilt to wherever the frame happens to lie, across cache lines more often than not: 640 ns for
/// eight lanes instead of 450.
#[cfg_attr(not(debug_assertions), inline(always))]
fn align_frame() {
    #[repr(align(64))]
    struct CacheLine(#[expect(dead_code, reason = "it takes room")] u8);
    let mut line = CacheLine(0);
    std::hint::black_box(&mut line);
}

/// One number of each lane, as a vector.
#[cfg_attr(not(debug_assertions), inline(always))]
fn packed<V: Vector, const LANES: usize>(lanes: [V::Lane; LANES]) -> Number<V> {
    let mut vector = V::splat(0.0);
    for (lane, value) in lanes.into_iter().enumerate() {
        vector.set_lane(lane, value);
    }
    Number(vector)
}

/// One model of each lane, as a model of vectors.
fn packed_models<G: Listing<N>, V: Vector<Lane: Real>, const N: usize, const LANES: usize>(
    lanes: [&G::Model<V::Lane>; LANES],
) -> G::Model<Number<V>> {
    G::gather(lanes[0], |read| packed(lanes.map(read)))
}

/// One lane of each entry.
fn lane_of<V: Vector<Lane: Real>, const N: usize>(
    motion: &Motion<Number<V>, N>,
    lane: usize,
) -> Motion<V::Lane, N> {
    let entries = |vector: &SVector<Number<V>, N>| {
        let [entries] = vector.data.0;
        SVector::from(entries.map(|entry| entry.0.lane(lane)))
    };
    Motion {
        position: entries(&motion.position),
        velocity: entries(&motion.velocity),
        acceleration: entries(&motion.acceleration),
        positive_determinant: None,
    }
}

/// The drives of all lanes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn packed_drives<G: Listing<N>, V: Vector<Lane: Real>, const N: usize, const LANES: usize>(
    lanes: [&G::Drives<V::Lane>; LANES],
) -> G::Drives<Number<V>> {
    let mut values = lanes.map(|drives| drives.values());
    G::Drives::from_values(std::iter::repeat_with(|| {
        packed(
            values
                .each_mut()
                .map(|values| values.next().unwrap_or_default()),
        )
    }))
}

impl<G, V, const N: usize, const LANES: usize, const CORRECTIONS: usize, const ORDER: usize>
    Engine<G, V::Lane, N, LANES> for Vectors<G, V, N, CORRECTIONS, ORDER>
where
    G: Listing<N>,
    V: Vector<Lane: Real>,
{
    fn attempt(
        &mut self,
        outputs: Outputs,
        drives: &[Signal<G::Drives<V::Lane>>; LANES],
        dt: V::Lane,
    ) -> [Evidence<V::Lane>; LANES] {
        let proof = self.proof;
        proof.vectorize(
            #[cfg_attr(not(debug_assertions), inline(always))]
            || {
                align_frame();
                let drives = Signal {
                    value: packed_drives::<G, V, N, LANES>(drives.each_ref().map(|d| &d.value)),
                    rate: packed_drives::<G, V, N, LANES>(drives.each_ref().map(|d| &d.rate)),
                    second_rate: packed_drives::<G, V, N, LANES>(
                        drives.each_ref().map(|d| &d.second_rate),
                    ),
                };
                let prescribed = Prescribed::new(&self.model, &Inputs::still(drives));
                let dt = packed([dt; LANES]);
                let step = Step::<_, Still, N, CORRECTIONS, ORDER>::new(
                    &self.model,
                    &prescribed,
                    &self.motions[self.last],
                    dt,
                );
                let (next, evidence) = step.in_fixed_order(outputs);
                self.motions[1 - self.last] = next;
                std::array::from_fn(|lane| evidence.map(|number| number.0.lane(lane)))
            },
        )
    }

    fn accept(&mut self) {
        self.last = 1 - self.last;
    }

    fn motion(&self, lane: usize) -> Motion<V::Lane, N> {
        lane_of(&self.motions[self.last], lane)
    }

    fn next(&self, lane: usize) -> Motion<V::Lane, N> {
        lane_of(&self.motions[1 - self.last], lane)
    }

    fn set_motion(&mut self, lane: usize, motion: &Motion<V::Lane, N>) {
        let set = |vector: &mut SVector<Number<V>, N>, from: &SVector<V::Lane, N>| {
            for (entry, value) in vector.iter_mut().zip(from.iter()) {
                entry.0.set_lane(lane, *value);
            }
        };
        let last = &mut self.motions[self.last];
        set(&mut last.position, &motion.position);
        set(&mut last.velocity, &motion.velocity);
        set(&mut last.acceleration, &motion.acceleration);
    }

    fn set_models(&mut self, models: [&G::Model<V::Lane>; LANES]) {
        self.model = packed_models::<G, V, N, LANES>(models);
    }
}

/// Lanes in two halves, for vectors that are half as long.
pub(crate) struct Halves<E>(pub(crate) [E; 2]);

macro_rules! halves {
    ($lanes:literal, $half:literal) => {
        impl<G, T, E, const N: usize> Engine<G, T, N, $lanes> for Halves<E>
        where
            G: Listing<N>,
            T: Real,
            E: Engine<G, T, N, $half>,
        {
            fn attempt(
                &mut self,
                outputs: Outputs,
                drives: &[Signal<G::Drives<T>>; $lanes],
                dt: T,
            ) -> [Evidence<T>; $lanes] {
                let mut evidence = [Evidence::default(); $lanes];
                let halves = self.0.iter_mut().zip(drives.as_chunks::<$half>().0);
                for ((half, drives), found) in halves.zip(evidence.as_chunks_mut::<$half>().0) {
                    *found = half.attempt(outputs, drives, dt);
                }
                evidence
            }

            fn accept(&mut self) {
                self.0.iter_mut().for_each(E::accept);
            }

            fn motion(&self, lane: usize) -> Motion<T, N> {
                self.0[lane / $half].motion(lane % $half)
            }

            fn next(&self, lane: usize) -> Motion<T, N> {
                self.0[lane / $half].next(lane % $half)
            }

            fn set_motion(&mut self, lane: usize, motion: &Motion<T, N>) {
                self.0[lane / $half].set_motion(lane % $half, motion);
            }

            fn set_models(&mut self, models: [&G::Model<T>; $lanes]) {
                let halves = self.0.iter_mut().zip(models.as_chunks::<$half>().0);
                for (half, models) in halves {
                    half.set_models(*models);
                }
            }
        }
    };
}

halves!(8, 4);

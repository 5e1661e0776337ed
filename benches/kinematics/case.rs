//! A linkage on the published motion.

use suspension_core::step::bounded::Outputs;
use suspension_core::{Build, Inputs, Linkage, Listing, Motion, Newton, Still, Tracker, assemble};
use suspension_lanes::Lane;

/// With steps of half a millisecond one correction is enough for all outputs; the cost of a step does not depend on its
/// length.
pub(crate) const STEP: f64 = 5e-4;

/// The outputs of a step, by their names in the ids.
pub(crate) const OUTPUTS: [(&str, Outputs); 3] = [
    ("position", Outputs::Position),
    ("velocity", Outputs::Velocity),
    ("acceleration", Outputs::Acceleration),
];

type InputsOf<G, T> = Inputs<Still, <G as Listing<15>>::Drives<T>>;

pub(crate) struct Case<G: Listing<15>, T: Lane> {
    /// `linkage/number`.
    pub(crate) name: String,
    pub(crate) model: G::Model<T>,
    /// The motion at `t = 0`.
    start: Motion<T, 15>,
    inputs: fn(T) -> InputsOf<G, T>,
}

impl<G: Listing<15>, T: Lane> Case<G, T>
where
    G::Model<T>: Build<15>,
{
    pub(crate) fn new(
        linkage: &str,
        model: G::Model<T>,
        rough: &G::Points<T>,
        inputs: fn(T) -> InputsOf<G, T>,
    ) -> Self {
        let mut q = model.unknowns(rough);
        assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
        let mut start = Motion::at_rest(q);
        Tracker::default()
            .step(&model, &inputs(T::zero()), T::zero(), &mut start)
            .expect("regular");
        let name = format!("{linkage}/{}", std::any::type_name::<T>());
        Self {
            name,
            model,
            start,
            inputs,
        }
    }

    pub(crate) fn inputs(&self, t: f64) -> InputsOf<G, T> {
        (self.inputs)(T::constant(t))
    }

    /// The motion at time `t`.
    pub(crate) fn motion(&self, t: f64) -> Motion<T, 15> {
        let mut motion = self.start;
        Tracker::default()
            .advance(
                &self.model,
                self.inputs,
                T::zero(),
                T::constant(t),
                &mut motion,
            )
            .expect("a regular motion");
        motion
    }
}

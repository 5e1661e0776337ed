//! A linkage of the catalogue in its configuration at `t = 0`, solved in `f64` and in `f32`.

use std::fmt;

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::HasWheel;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::model::local::LocalOrigin;
use suspension_core::wheel::Wheel;
use suspension_core::{
    Bounded, Build, Inputs, Linkage, Listing, Motion, Newton, Real, Signal, SolveError, Still,
    Tangent, Tracker, Values,
};

use crate::support;

/// A listing that is tested in both number types.
pub(crate) trait Tested:
    Default
    + Listing<15, Model<f64>: Build<15, Scalar = f64>, Points<f64>: HasWheel<f64>>
    + Listing<15, Model<f32>: Build<15, Scalar = f32>, Points<f32>: HasWheel<f32>>
{
    const NAME: &'static str;

    /// The points of the published motion at `t = 0`.
    fn design() -> Self::Points<f64>;
}

fn solved<L: Build<15, Scalar = f64>>(
    model: &L,
    rough: &L::Points,
    inputs: fn(f64) -> Inputs<Still, L::Drives>,
) -> L::Points {
    let start = support::motions(model, rough, inputs)[0];
    start.points(model, &inputs(0.0)).value
}

impl Tested for five_link::Listing {
    const NAME: &'static str = "five_link";

    fn design() -> five_link::Points<f64> {
        let (model, rough) = (support::five_link_model(), support::five_link_rough());
        solved(&model, &rough, support::five_link_inputs)
    }
}

impl Tested for attia2003::Listing {
    const NAME: &'static str = "attia2003";

    fn design() -> attia2003::Points<f64> {
        let (model, rough) = (support::attia_model(), support::attia_rough());
        solved(&model, &rough, support::attia_inputs)
    }
}

/// The published drive; its numbers in `f64`, then rounded.
pub(crate) fn theta<T: Real, D: Values<T> + Default>(t: f64) -> Inputs<Still, D> {
    let signal = support::theta(t);
    let named = |number| D::from_values(std::iter::repeat(T::constant(number)));
    Inputs::still(Signal {
        value: named(signal.value),
        rate: named(signal.rate),
        second_rate: named(signal.second_rate),
    })
}

/// How a model in `f32` comes to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Built {
    /// From points rounded where they are.
    InPlace,
    /// From points made local, then rounded.
    FromLocalPoints,
    /// In `f64` from local points, then each of its constants rounded.
    Rounded,
}

/// A mechanism in `f32`, and where its origin is in the coordinates of the `f64` points.
pub(crate) struct Single<G: Tested> {
    pub(crate) model: G::Model<f32>,
    pub(crate) start: Motion<f32, 15>,
    pub(crate) origin: Vector3<f64>,
}

pub(crate) fn single<G: Tested>(design: &G::Points<f64>, built: Built) -> Option<Single<G>> {
    let origin = match built {
        Built::InPlace => LocalOrigin::among([]),
        Built::FromLocalPoints | Built::Rounded => LocalOrigin::among(design.values()),
    };
    let local = origin.to_local(design);
    let points = local.values().map(|point| point.map(|x| x as f32));
    let rounded = Values::from_values(points);
    let model = if built == Built::Rounded {
        G::rounded(&G::Model::<f64>::of(G::default(), &local).ok()?)
    } else {
        G::Model::<f32>::of(G::default(), &rounded).ok()?
    };
    let position = model.unknowns(&rounded);
    Some(Single {
        model,
        start: Motion::at_rest(position),
        origin: origin.position(),
    })
}

/// A way from instant to instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Way {
    Newton,
    Tracker,
    /// Bounded, by its corrections.
    Bounded0,
    Bounded1,
    Bounded2,
}

pub(crate) const WAYS: [Way; 5] = [
    Way::Newton,
    Way::Tracker,
    Way::Bounded0,
    Way::Bounded1,
    Way::Bounded2,
];

impl Way {
    /// The way that it is compared with in `f64`, where a step without corrections is always refused.
    pub(crate) fn exact(self) -> Self {
        match self {
            Self::Bounded0 => Self::Bounded1,
            way => way,
        }
    }

    /// One step; the motion stays where it is if it is refused.
    pub(crate) fn step<T: Real, L: Linkage<15, Scalar = T>>(
        self,
        model: &L,
        inputs: &Inputs<Still, L::Drives>,
        dt: f64,
        motion: &mut Motion<T, 15>,
    ) -> Result<(), SolveError<T>> {
        let dt = T::constant(dt);
        match self {
            Self::Newton => {
                let mut q = motion.position;
                Newton::near_by().solve(model, inputs, &mut q)?;
                *motion = Tangent::new(model, inputs, &q)?.motion()?;
            }
            Self::Tracker => drop(Tracker::default().step(model, inputs, dt, motion)?),
            Self::Bounded0 => {
                Bounded::<T, 0>::new().step(model, inputs, dt, motion)?;
            }
            Self::Bounded1 => {
                Bounded::<T, 1>::new().step(model, inputs, dt, motion)?;
            }
            Self::Bounded2 => {
                Bounded::<T, 2>::new().step(model, inputs, dt, motion)?;
            }
        }
        Ok(())
    }
}

/// The errors of `f32`: positions and wheel centre in metres, camber and toe in radians, velocity
/// and acceleration as parts of the largest of the instant.
#[derive(Clone, Copy, Default)]
pub(crate) struct Errors {
    pub(crate) position: f64,
    pub(crate) centre: f64,
    pub(crate) camber: f64,
    pub(crate) toe: f64,
    pub(crate) velocity: f64,
    pub(crate) acceleration: f64,
}

impl fmt::Debug for Errors {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [position, centre, camber, toe, velocity, acceleration] = self.each();
        write!(
            f,
            "position {position:.1e} m, wheel centre {centre:.1e} m, camber {camber:.1e} rad, toe \
             {toe:.1e} rad, velocity {velocity:.1e}, acceleration {acceleration:.1e}"
        )
    }
}

impl Errors {
    pub(crate) fn of<G: Tested>(
        found: (&Single<G>, &Motion<f32, 15>, &G::Points<f32>),
        exact: (&Motion<f64, 15>, &G::Points<f64>),
    ) -> Self {
        let ((single, motion, points), (truth, at)) = (found, exact);
        let moved = SVector::<f64, 15>::from_fn(|row, _| single.origin[row % 3]);
        let part = |found: &SVector<f32, 15>, exact: &SVector<f64, 15>| {
            (found.map(f64::from) - exact).amax() / exact.amax()
        };
        let wheel = Wheel::of(points.wheel()).expect("a spin axis");
        let exact = Wheel::of(at.wheel()).expect("a spin axis");
        Self {
            position: (motion.position.map(f64::from) + moved - truth.position).amax(),
            centre: (wheel.centre.map(f64::from) + single.origin - exact.centre).amax(),
            camber: (f64::from(wheel.camber) - exact.camber).abs(),
            toe: (f64::from(wheel.toe) - exact.toe).abs(),
            velocity: part(&motion.velocity, &truth.velocity),
            acceleration: part(&motion.acceleration, &truth.acceleration),
        }
    }

    fn each(&self) -> [f64; 6] {
        let Self {
            position,
            centre,
            camber,
            toe,
            velocity,
            acceleration,
        } = *self;
        [position, centre, camber, toe, velocity, acceleration]
    }

    pub(crate) fn worse(self, other: Self) -> Self {
        let mut pairs = self.each().into_iter().zip(other.each());
        let [position, centre, camber, toe, velocity, acceleration] =
            [(); 6].map(|()| pairs.next().map_or(f64::NAN, |(a, b)| a.max(b)));
        Self {
            position,
            centre,
            camber,
            toe,
            velocity,
            acceleration,
        }
    }

    pub(crate) fn assert_within(self, bounds: &Self) {
        for (found, bound) in self.each().into_iter().zip(bounds.each()) {
            assert!(found <= bound, "{found:e} > {bound:e}: {self:?}");
        }
    }
}

//! Random geometries near the published one. Failing cases print their values.

use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use suspension_core::path::{Configuration, Continuation, Curve, End, Path, Turning};
use suspension_core::{Build, Inputs, Linkage, Named, Newton, Real, Signal, Still, assemble};

use crate::support;

/// A geometry whose points are displaced by up to 2 cm, at rest.
struct Displaced<T: Real, L: Build<15, Scalar = T>> {
    model: L,
    inputs: Inputs<Still, L::Drives>,
    q: SVector<T, 15>,
}

impl<T: Real, L: Build<15, Scalar = T>> Displaced<T, L> {
    fn new(rough: &L::Points, by: &[f64], theta: f64) -> Option<Self> {
        let mut points = rough.values().zip(by.chunks_exact(3));
        let design = L::Points::from_fn(|_| {
            let (point, by) = points.next().expect("three numbers a point");
            point + Vector3::new(by[0], by[1], by[2]).map(T::constant)
        });
        let model = L::new(&design).ok()?;
        let none = L::Drives::default();
        let inputs = Inputs::still(Signal {
            value: L::Drives::from_fn(|_| T::constant(theta)),
            rate: none,
            second_rate: none,
        });
        let mut q = L::unknowns(&design);
        assemble(&Newton::from_afar(), &model, &inputs, &mut q).ok()?;
        Some(Self { model, inputs, q })
    }

    fn curve(&self) -> Curve<'_, L, 15> {
        Curve::new(&self.model, &self.inputs, 0).expect("a drive")
    }

    /// The residual with the drive at a coordinate, as a multiple of rounding.
    fn residual(&self, at: &Configuration<T, 15>) -> T {
        let drives = L::Drives::from_fn(|_| at.drive);
        let residual = self
            .model
            .residual(&at.unknowns, self.model.fixed(), &drives);
        residual.amax() / (T::EPSILON * self.model.size().max(at.unknowns.amax()))
    }

    /// Follows the curve; tells how it ends.
    fn check(&self, increasing: bool) -> Result<Option<End<T>>, TestCaseError> {
        let settings = Continuation {
            max_steps: 1000,
            ..Continuation::default()
        };
        let Ok(mut path) = settings.path(self.curve(), &self.q, increasing) else {
            return Ok(None);
        };
        while let Some(stretch) = next(&mut path)? {
            let at = &stretch.place.configuration;
            prop_assert!(self.residual(at) <= settings.newton.tolerance);
            let tangent = stretch.place.tangent.norm();
            prop_assert!((tangent - T::one()).abs() <= T::EPSILON * T::constant(64.0));
            if let Some(turning) = stretch.turning {
                self.is_an_end(&turning)?;
            }
            if stretch.end.is_some() {
                return Ok(stretch.end);
            }
        }
        Err(TestCaseError::fail("a path without an end"))
    }

    /// Beyond a turning point there is no configuration near by, however Newton's method searches.
    fn is_an_end(&self, turning: &Turning<T, 15>) -> Result<(), TestCaseError> {
        let at = &turning.place.configuration;
        prop_assert!(self.residual(at) <= Newton::<T>::near_by().tolerance);
        let bend = self.model.size() * T::constant(1e-2);
        let mut beyond = 0;
        for sign in [1.0, -1.0] {
            let part = T::EPSILON.sqrt() * T::constant(16.0 * sign);
            let inputs = Inputs::still(Signal {
                value: L::Drives::from_fn(|_| turning.place.value + part),
                ..self.inputs.drives
            });
            let mut q = at.unknowns;
            let found = Newton::from_afar().solve(&self.model, &inputs, &mut q);
            beyond += usize::from(found.is_err() || (q - at.unknowns).amax() > bend);
        }
        // On one side there are two configurations, on the other none.
        prop_assert!(beyond >= 1, "goes on beyond {}", turning.place.value);
        Ok(())
    }
}

type Step<T> = suspension_core::path::Stretch<T, 15>;

fn next<T: Real, L: Linkage<15, Scalar = T>>(
    path: &mut Path<'_, L, 15>,
) -> Result<Option<Step<T>>, TestCaseError> {
    let step = path.next().transpose();
    step.map_err(|error| TestCaseError::fail(format!("{error:?}")))
}

static FOLLOWED: AtomicUsize = AtomicUsize::new(0);
static CLOSED: AtomicUsize = AtomicUsize::new(0);

fn count<T: Real, L: Build<15, Scalar = T>>(
    rough: &L::Points,
    by: &[f64],
    theta: f64,
) -> Result<(), TestCaseError> {
    let Some(displaced) = Displaced::<T, L>::new(rough, by, theta) else {
        return Ok(());
    };
    for increasing in [true, false] {
        let Some(end) = displaced.check(increasing)? else {
            continue;
        };
        FOLLOWED.fetch_add(1, Ordering::Relaxed);
        match end {
            End::Closed { .. } => {
                CLOSED.fetch_add(1, Ordering::Relaxed);
            }
            other => return Err(TestCaseError::fail(format!("{other:?}"))),
        }
    }
    Ok(())
}

#[test]
fn curves_are_closed_and_their_ends_are_ends() {
    use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
    let config = ProptestConfig {
        cases: 100,
        failure_persistence: None,
        ..Default::default()
    };
    let cases = (prop::collection::vec(-0.02_f64..0.02, 33), 0.8_f64..2.0);
    proptest!(config, |((by, theta) in cases)| {
        count::<f64, Listed<f64>>(&support::attia_rough(), &by, theta)?;
        count::<f64, Rigid<f64>>(&support::five_link_rough(), &by, theta)?;
        count::<f32, Rigid<f32>>(&support::five_link_rough(), &by, theta)?;
    });
    let [followed, closed] = [&FOLLOWED, &CLOSED].map(|count| count.load(Ordering::Relaxed));
    println!("{closed} of {followed} curves closed");
    assert!(followed > 200);
}

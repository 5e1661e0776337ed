//! Random geometries near the published one: curves of configurations with one drive free close, or end where they
//! must. Failing cases print their values.

use std::cell::RefCell;

use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use suspension_core::path::{Configuration, Continuation, Curve, End, Path, Turning};
use suspension_core::{Build, Inputs, Linkage, Newton, Real, Signal, Still, Values, assemble};

use crate::support;

/// A geometry whose points are displaced by up to 2 cm, at rest.
struct Displaced<T: Real, L: Build<15, Scalar = T, Listing: Default>> {
    model: L,
    inputs: Inputs<Still, L::Drives>,
    q: SVector<T, 15>,
}

impl<T: Real, L: Build<15, Scalar = T, Listing: Default>> Displaced<T, L> {
    fn new(rough: &L::Points, by: &[f64], theta: f64) -> Option<Self> {
        let points = rough.values().zip(by.chunks_exact(3));
        let design = L::Points::from_values(
            points.map(|(point, by)| point + Vector3::new(by[0], by[1], by[2]).map(T::constant)),
        );
        let model = L::of(L::Listing::default(), &design).ok()?;
        let none = L::Drives::default();
        let inputs = Inputs::still(Signal {
            value: L::Drives::from_values(std::iter::repeat(T::constant(theta))),
            rate: none,
            second_rate: none,
        });
        let mut q = model.unknowns(&design);
        assemble(&Newton::from_afar(), &model, &inputs, &mut q).ok()?;
        Some(Self { model, inputs, q })
    }

    fn curve(&self) -> Curve<'_, L, 15> {
        Curve::new(&self.model, &self.inputs, 0).expect("a drive")
    }

    /// The residual with the drive at a coordinate, as a multiple of rounding.
    fn residual(&self, at: &Configuration<T, 15>) -> T {
        let drives = L::Drives::from_values(std::iter::repeat(at.drive));
        let residual = self
            .model
            .residual(&at.unknowns, self.model.fixed(), &drives);
        residual.amax() / (T::EPSILON * self.model.size().max(at.unknowns.amax()))
    }

    /// Follows the curve; tells how it ends, `None` where it has no start.
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
            prop_assert!(self.residual(at) <= settings.newton.tolerance.length(T::one()));
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
        prop_assert!(self.residual(at) <= Newton::<T>::near_by().tolerance.length(T::one()));
        let bend = self.model.size() * T::constant(1e-2);
        let mut beyond = 0;
        for sign in [1.0, -1.0] {
            let part = T::EPSILON.sqrt() * T::constant(16.0 * sign);
            let inputs = Inputs::still(Signal {
                value: L::Drives::from_values([turning.place.value + part]),
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

/// How the curves of all cases ended.
#[derive(Clone, Copy, Debug, Default)]
struct Ends {
    tried: usize,
    /// The displaced points are no mechanism, or do not reach the angle.
    not_assembled: usize,
    /// There is no tangent at the first place.
    without_start: usize,
    closed: usize,
    bifurcations: usize,
}

impl Ends {
    /// Follows the curve of a case both ways.
    fn add<T: Real, L: Build<15, Scalar = T, Listing: Default>>(
        &mut self,
        rough: &L::Points,
        by: &[f64],
        theta: f64,
    ) -> Result<(), TestCaseError> {
        self.tried += 2;
        let Some(displaced) = Displaced::<T, L>::new(rough, by, theta) else {
            self.not_assembled += 2;
            return Ok(());
        };
        for increasing in [true, false] {
            match displaced.check(increasing)? {
                None => self.without_start += 1,
                Some(End::Closed { .. }) => self.closed += 1,
                Some(End::Bifurcation { .. }) => self.bifurcations += 1,
                Some(other) => return Err(TestCaseError::fail(format!("{other:?}"))),
            }
        }
        Ok(())
    }
}

#[test]
fn curves_of_random_geometries_close_or_end_at_true_ends() {
    use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
    const SEED: u8 = 1;
    println!("seed {SEED}");
    let config = crate::config(100);
    let generator = TestRng::from_seed(RngAlgorithm::ChaCha, &[SEED; 32]);
    let cases = (prop::collection::vec(-0.02_f64..0.02, 33), 0.8_f64..2.0);
    let [listed, rigid, single] = [(); 3].map(|()| RefCell::new(Ends::default()));
    let run = TestRunner::new_with_rng(config, generator).run(&cases, |(by, theta)| {
        let (nine, five) = (support::attia_rough(), support::five_link_rough());
        listed
            .borrow_mut()
            .add::<f64, Listed<f64>>(&nine, &by, theta)?;
        rigid
            .borrow_mut()
            .add::<f64, Rigid<f64>>(&five, &by, theta)?;
        let five = support::five_link_rough();
        single
            .borrow_mut()
            .add::<f32, Rigid<f32>>(&five, &by, theta)
    });
    run.expect("every curve");
    for ends in [listed, rigid, single].map(RefCell::into_inner) {
        println!("{ends:?}");
        assert_eq!(ends.tried, 200);
        assert!(ends.not_assembled + ends.without_start <= 20, "{ends:?}");
        assert!(ends.bifurcations <= 2, "{ends:?}");
        assert!(ends.closed >= 180, "{ends:?}");
    }
}

//! The fixed order of elimination against LU with partial pivoting, and the way out where its
//! pivots are unhealthy.

mod support;

use nalgebra::{SVector, Vector3};
use proptest::prelude::*;
use suspension_core::factored::Factored;
use suspension_core::linkage::Factors as _;
use suspension_core::lu::Lu;
use suspension_core::{Build, Linkage, Motion, Named, Newton, Real};

/// Solves with both factorisations near the published design and compares.
fn agree<T: Real, L: Build<15, Scalar = T>>(
    rough: &L::Points,
    by: &[f64],
) -> Result<(), TestCaseError> {
    let mut by = by.iter().map(|by| T::constant(*by));
    let mut next = || by.next().unwrap_or_default();
    let displaced = rough.map_each(|point| point + Vector3::new(next(), next(), next()));
    let Ok(model) = L::new(&displaced) else {
        return Ok(());
    };
    let jacobian = model.jacobian(&L::unknowns(&displaced), model.fixed());
    let right = SVector::<T, 15>::from_fn(|row, _| T::constant(0.1 + row as f64));
    let fixed = model.factor(&L::unknowns(&displaced), model.fixed());
    let Ok(pivoted) = Lu::factor(&jacobian) else {
        return Ok(());
    };
    let expected = pivoted.solve(&right);
    // Backward stable to the growth of the pivots: judged by the residual, not by the condition.
    let residual = |x: &SVector<T, 15>| (jacobian * x - right).amax();
    let scale = T::EPSILON * expected.amax() * T::constant(64.0);
    prop_assert!(residual(&expected) <= scale);
    let growth = fixed.growth_squared().sqrt();
    if growth < T::constant(1e3) {
        let positive = fixed.determinant_sign() > T::zero();
        prop_assert_eq!(positive, pivoted.determinant_sign() > T::zero());
        prop_assert_eq!(positive, jacobian.determinant() > T::zero());
        prop_assert!(residual(&fixed.solve(&right)) <= scale * growth);
        let transposed = |y: &SVector<T, 15>| (jacobian.tr_mul(y) - right).amax();
        let [ours, pivoted] = [
            fixed.solve_transposed(&right),
            pivoted.solve_transposed(&right),
        ];
        let scale = T::EPSILON * pivoted.amax() * T::constant(64.0);
        prop_assert!(transposed(&pivoted) <= scale);
        prop_assert!(transposed(&ours) <= scale * growth);
        let of_drives = drive_terms(&model, &L::unknowns(&displaced));
        prop_assert_eq!(fixed.solve_drives(&of_drives), fixed.solve(&of_drives));
        prop_assert_eq!(of_drives.iter().filter(|term| !term.is_zero()).count(), 1);
    }
    let Ok(chosen) = Factored::new(&model, &L::unknowns(&displaced), model.fixed()) else {
        return Ok(()); // too near a singularity for a velocity
    };
    prop_assert!(residual(&chosen.factors().solve(&right)) <= scale * T::constant(1e3));
    Ok(())
}

/// The right-hand side of a velocity: in the rows of the drives alone.
fn drive_terms<T: Real, L: Build<15, Scalar = T>>(model: &L, q: &SVector<T, 15>) -> SVector<T, 15> {
    let rate = L::Drives::from_fn(|_| T::constant(0.7));
    model.drive_rate(q, model.fixed(), &L::Fixed::default(), &rate)
}

/// A struct of points with each replaced.
trait MapEach<V>: Named<V> {
    fn map_each(&self, mut value: impl FnMut(V) -> V) -> Self {
        let mut values = self.values();
        Self::from_fn(|_| value(values.next().expect("a value for each name")))
    }
}

impl<V, S: Named<V>> MapEach<V> for S {}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn both_factorisations_solve(by in prop::collection::vec(-0.03_f64..0.03, 33)) {
        use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
        agree::<f64, Listed<f64>>(&support::attia_rough(), &by)?;
        agree::<f32, Listed<f32>>(&support::attia_rough(), &by)?;
        agree::<f64, Rigid<f64>>(&support::five_link_rough(), &by)?;
        agree::<f32, Rigid<f32>>(&support::five_link_rough(), &by)?;
    }
}

/// With link 6-1 square to an axis its derivative along that axis is zero, and along x or y it is
/// the pivot that the design chose.
#[test]
fn a_zero_pivot_is_seen_and_solved_with_pivoting() {
    use suspension_core::linkages::attia2003::{Model, Points};
    let design = support::attia_rough::<f64>();
    let square_to = [Vector3::new(0.0, 0.3, 0.33), Vector3::new(0.3, 0.0, 0.33)];
    let pivoted = square_to.map(|link| {
        let p6 = design.p1 + link;
        let square = Points { p6, ..design };
        let model = Model::new(&square).expect("a geometry");
        let q = Model::unknowns(&square);
        let jacobian = model.jacobian(&q, model.fixed());
        let factored = Factored::new(&model, &q, model.fixed()).expect("regular");
        let x = SVector::<f64, 15>::from_fn(|row, _| 1.0 + row as f64);
        assert!((factored.factors().solve(&(jacobian * x)) - x).amax() < 1e-11);
        let with_pivoting = matches!(factored, Factored::WithPivoting(_));
        let growth_squared = model.factor(&q, model.fixed()).growth_squared();
        // What follows a pivot of zero is infinite, or not a number.
        assert_eq!(with_pivoting, !growth_squared.is_finite());
        with_pivoting
    });
    assert!(pivoted.contains(&true), "link 6-1 has a pivot along x or y");
}

/// Newton's method through the fixed order ends where it ends through partial pivoting.
#[test]
fn newton_does_not_notice() {
    let motions = support::motions(
        &support::five_link_model::<f64>(),
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    let reference = support::Reference::load();
    for (instant, motion) in motions.iter().enumerate() {
        let mut q = motion.position.map(|x| x + 1e-3);
        let inputs = support::five_link_inputs(support::INSTANTS[instant]);
        let newton = Newton::from_afar();
        newton
            .solve(&support::five_link_model::<f64>(), &inputs, &mut q)
            .expect("a root");
        assert!((q - reference.unknowns(instant, "")).amax() < 5e-15);
    }
}

/// Over the published motion the fixed order is healthy: partial pivoting is for other geometries.
#[test]
fn the_published_motion_stays_in_the_fixed_order() {
    fn worst_growth<L: Build<15, Scalar = f64>>(model: &L, motions: &[Motion<f64, 15>]) -> f64 {
        let growth = motions.iter().map(|motion| {
            let factors = model.factor(&motion.position, model.fixed());
            factors.growth_squared().sqrt()
        });
        growth.fold(0.0, f64::max)
    }
    let model = support::attia_model();
    let motions = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    let listed = worst_growth(&model, &motions);
    let model = support::five_link_model();
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    let rigid = worst_growth(&model, &motions);
    println!("growth {listed:.0} and {rigid:.0}");
    assert!(listed < 30.0 && rigid < 30.0, "{listed}, {rigid}");
}

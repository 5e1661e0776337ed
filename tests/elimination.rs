//! The fixed order of elimination against LU with partial pivoting, and the alternative if its pivots are unhealthy.

mod carried;

use nalgebra::{Const, DimMin, SVector, Vector3};
use proptest::prelude::*;
use suspension_core::linkage::Factors as _;
use suspension_core::solve::factored::Factored;
use suspension_core::solve::lu::Lu;
use suspension_core::{Build, Linkage, Motion, Newton, Real, Values};

use crate::support;

/// Solves with both factorisations near a design position, where its equations need not hold, and compares. Rounding errors
/// of the fixed order grow at most by the pivot growth to the power of `chain`: if a small pivot is in the rows of another,
/// the factors multiply.
fn agree<T: Real, L: Build<N, Scalar = T, Listing: Default>, const N: usize>(
    rough: &L::Points,
    by: &[f64],
    chain: i32,
) -> Result<(), TestCaseError>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let mut by = by.iter().map(|by| T::constant(*by)).cycle();
    let mut next = || by.next().unwrap_or_default();
    let displaced = rough.map_each(|point| point + Vector3::new(next(), next(), next()));
    let Ok(model) = L::of(L::Listing::default(), &displaced) else {
        return Ok(());
    };
    let q = model.unknowns(&displaced).map(|x| x + next());
    let jacobian = model.jacobian(&q, model.fixed());
    let right = SVector::<T, N>::from_fn(|row, _| T::constant(0.1 + row as f64));
    let fixed = model.factor(&q, model.fixed());
    let Ok(pivoted) = Lu::factor(&jacobian) else {
        return Ok(());
    };
    let expected = pivoted.solve(&right);
    // Backward stable to the growth of the pivots: judged by the residual, not by the condition.
    let residual = |x: &SVector<T, N>| (jacobian * x - right).amax();
    let scale = T::EPSILON * expected.amax() * T::constant(64.0);
    prop_assert!(residual(&expected) <= scale);
    let growth = fixed.growth_squared().sqrt();
    if growth < T::constant(1e3) {
        let cost = growth.powi(chain);
        let positive = fixed.determinant_sign() > T::zero();
        prop_assert_eq!(positive, pivoted.determinant_sign() > T::zero());
        prop_assert_eq!(positive, jacobian.determinant() > T::zero());
        prop_assert!(residual(&fixed.solve(&right)) <= scale * cost);
        let transposed = |y: &SVector<T, N>| (jacobian.transpose() * y - right).amax();
        let [ours, pivoted] = [
            fixed.solve_transposed(&right),
            pivoted.solve_transposed(&right),
        ];
        let scale = T::EPSILON * pivoted.amax() * T::constant(64.0);
        prop_assert!(transposed(&pivoted) <= scale);
        prop_assert!(transposed(&ours) <= scale * cost);
        let of_drives = drive_terms(&model, &q);
        let drives = L::Drives::default().values().count();
        prop_assert_eq!(
            of_drives.iter().filter(|term| !term.is_zero()).count(),
            drives
        );
    }
    let Ok(chosen) = Factored::new(&model, &q, model.fixed()) else {
        return Ok(()); // too near a singularity for a velocity
    };
    prop_assert!(residual(&chosen.factors().solve(&right)) <= scale * T::constant(1e3));
    Ok(())
}

/// Returns the right-hand side of a velocity, which is zero except in the rows of the drives.
fn drive_terms<T: Real, L: Build<N, Scalar = T, Listing: Default>, const N: usize>(
    model: &L,
    q: &SVector<T, N>,
) -> SVector<T, N> {
    let rate = L::Drives::from_values(std::iter::repeat(T::constant(0.7)));
    model.drive_rate(q, model.fixed(), &L::Fixed::default(), &rate)
}

/// A struct of points with each replaced.
trait MapEach<V: Default>: Values<V> {
    fn map_each(&self, value: impl FnMut(V) -> V) -> Self {
        Self::from_values(self.values().map(value))
    }
}

impl<V: Default, S: Values<V>> MapEach<V> for S {}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn fixed_order_and_partial_pivoting_give_the_same_solution(by in prop::collection::vec(-0.03_f64..0.03, 33)) {
        use suspension_core::linkages::{attia2003::Model as Listed, five_link::Model as Rigid};
        agree::<f64, Listed<f64>, 15>(&support::attia_rough(), &by, 1)?;
        agree::<f32, Listed<f32>, 15>(&support::attia_rough(), &by, 1)?;
        agree::<f64, Rigid<f64>, 15>(&support::five_link_rough(), &by, 1)?;
        agree::<f32, Rigid<f32>, 15>(&support::five_link_rough(), &by, 1)?;
    }

    #[test]
    fn both_factorisations_agree_with_carried_points(by in prop::collection::vec(-0.03_f64..0.03, 54)) {
        use carried::{common_point, held_by_carried, in_the_next_frame, pushrod, scattered};
        agree::<f64, pushrod::Model<f64>, 21>(&scattered(), &by, 1)?;
        agree::<f32, pushrod::Model<f32>, 21>(&scattered(), &by, 1)?;
        agree::<f64, common_point::Model<f64>, 21>(&scattered(), &by, 1)?;
        agree::<f64, in_the_next_frame::Model<f64>, 21>(&scattered(), &by, 1)?;
        agree::<f64, held_by_carried::Model<f64>, 21>(&scattered(), &by, 2)?;
    }
}

/// With unhealthy pivots the comparison above would skip the fixed order.
#[test]
fn carried_points_are_eliminated_with_healthy_pivots() {
    fn growth<L: Build<N, Scalar = f64, Listing: Default>, const N: usize>() -> f64 {
        let design = carried::scattered();
        let model = L::of(L::Listing::default(), &design).expect("a geometry");
        let factors = model.factor(&model.unknowns(&design), model.fixed());
        factors.growth_squared().sqrt()
    }
    let growths = [
        growth::<carried::pushrod::Model<f64>, 21>(),
        growth::<carried::common_point::Model<f64>, 21>(),
        growth::<carried::in_the_next_frame::Model<f64>, 21>(),
        growth::<carried::held_by_carried::Model<f64>, 21>(),
    ];
    assert!(growths.iter().all(|growth| *growth < 1e3), "{growths:?}");
}

/// With link 6-1 perpendicular to an axis its derivative along that axis is zero, and along x or y it is the pivot that the
/// design chose.
#[test]
fn a_zero_pivot_is_detected_and_solved_by_partial_pivoting() {
    use suspension_core::linkages::attia2003::{Listing, Model, Points};
    let design = support::attia_rough::<f64>();
    let square_to = [Vector3::new(0.0, 0.3, 0.33), Vector3::new(0.3, 0.0, 0.33)];
    let pivoted = square_to.map(|link| {
        let p6 = design.p1 + link;
        let square = Points { p6, ..design };
        let model = Model::of(Listing, &square).expect("a geometry");
        let q = model.unknowns(&square);
        let jacobian = model.jacobian(&q, model.fixed());
        let factored = Factored::new(&model, &q, model.fixed()).expect("regular");
        let x = SVector::<f64, 15>::from_fn(|row, _| 1.0 + row as f64);
        assert!((factored.factors().solve(&(jacobian * x)) - x).amax() < 1e-11);
        let with_pivoting = matches!(factored, Factored::WithPivoting(_));
        let growth_squared = model.factor(&q, model.fixed()).growth_squared();
        // Numbers computed from a pivot of zero are infinite or NaN.
        assert_eq!(with_pivoting, !growth_squared.is_finite());
        with_pivoting
    });
    assert!(pivoted.contains(&true), "link 6-1 has a pivot along x or y");
}

/// Newton's method with the fixed order converges to the same result as with partial pivoting.
#[test]
fn newton_converges_alike_in_fixed_order_and_partial_pivoting() {
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
fn the_published_motion_needs_no_partial_pivoting() {
    fn worst_growth<L: Build<15, Scalar = f64, Listing: Default>>(
        model: &L,
        motions: &[Motion<f64, 15>],
    ) -> f64 {
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

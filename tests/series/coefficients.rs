//! Coefficients against the 40-digit solution, the order of the error, and the radius.

use nalgebra::SVector;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::step::series::{InputSeries, Jet, Series};
use suspension_core::{Inputs, Linkage, Motion, Still, Tracker};

use crate::support::{self, INSTANTS, Reference};

/// The series at a position of the published motion.
fn series<L, const K: usize>(
    model: &L,
    inputs: Inputs<Still, L::Drives>,
    position: &SVector<f64, 15>,
) -> Series<f64, 15, K>
where
    L: Linkage<15, Scalar = f64>,
{
    let ahead = InputSeries::still(Jet::of_signal(&inputs.drives));
    Series::at(model, &ahead, position).expect("a regular configuration")
}

/// The largest differences from the reference in position, velocity and acceleration.
fn differences(reference: &Reference, instant: usize, motion: &Motion<f64, 15>) -> [f64; 3] {
    [
        (motion.position - reference.unknowns(instant, "")).amax(),
        (motion.velocity - reference.unknowns(instant, "v")).amax(),
        (motion.acceleration - reference.unknowns(instant, "a")).amax(),
    ]
}

/// From one instant the 40-digit solution a quarter of a second away on either side, at about a
/// third of the radius of convergence: coefficients up to order 32 count.
fn assert_reaches_the_neighbouring_instants<L>(
    model: &L,
    inputs: impl Fn(f64) -> Inputs<Still, L::Drives>,
) where
    L: Linkage<15, Scalar = f64>,
{
    let reference = Reference::load();
    for (from, to) in [(4, 3), (4, 4), (4, 5), (5, 4), (5, 6)] {
        let start = reference.unknowns(from, "");
        let series = series::<_, 40>(model, inputs(INSTANTS[from]), &start);
        let motion = series.motion(INSTANTS[to] - INSTANTS[from]);
        let found = differences(&reference, to, &motion);
        println!("from {from} to {to}: {found:?}");
        for (found, bound) in found.iter().zip([1e-14, 1e-12, 1e-10]) {
            assert!(
                *found <= bound,
                "from {from} to {to}: {found:e} > {bound:e}"
            );
        }
    }
}

#[test]
fn forty_terms_of_the_series_reach_the_neighbouring_instants() {
    assert_reaches_the_neighbouring_instants(&support::attia_model(), support::attia_inputs);
    assert_reaches_the_neighbouring_instants(
        &support::five_link_model(),
        support::five_link_inputs,
    );
}

#[test]
fn the_first_two_coefficients_are_velocity_and_acceleration() {
    let model: attia2003::Model<f64> = support::attia_model();
    let reference = Reference::load();
    for (instant, t) in INSTANTS.into_iter().enumerate() {
        let position = reference.unknowns(instant, "");
        let series = series::<_, 2>(&model, support::attia_inputs(t), &position);
        let found = differences(&reference, instant, &series.motion(0.0));
        assert!(found[1] <= 1e-12 && found[2] <= 1e-10, "{found:?}");
        let [first, second] = series.unknowns.terms;
        assert!((first - reference.unknowns(instant, "v")).amax() <= 1e-12);
        assert!((second * 2.0 - reference.unknowns(instant, "a")).amax() <= 1e-10);
    }
}

/// Halving the time divides the error of the position by `2^(K + 1)`, of the velocity by `2^K`, of
/// the acceleration by `2^(K - 1)`.
fn order_of_error<const K: usize>(dt: f64) {
    let model: five_link::Model<f64> = support::five_link_model();
    let start = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    )[4];
    let series = series::<_, K>(&model, support::five_link_inputs(1.0), &start.position);
    let errors = [dt, dt / 2.0].map(|dt| {
        let mut exact = start;
        Tracker::default()
            .advance(&model, support::five_link_inputs, 1.0, 1.0 + dt, &mut exact)
            .expect("a regular motion");
        let found = series.motion(dt);
        [
            (found.position - exact.position).amax(),
            (found.velocity - exact.velocity).amax(),
            (found.acceleration - exact.acceleration).amax(),
        ]
    });
    for (kind, order) in [K + 1, K, K - 1].into_iter().enumerate() {
        let found = (errors[0][kind] / errors[1][kind]).log2();
        println!("K = {K}: order {found:.2}, errors {errors:?}");
        assert!(
            (found - order as f64).abs() < 0.2,
            "K = {K}: {found} for {order}"
        );
    }
}

#[test]
fn the_error_of_the_series_has_the_order_of_the_next_term() {
    order_of_error::<2>(0.02);
    order_of_error::<3>(0.03);
    order_of_error::<4>(0.04);
    order_of_error::<6>(0.06);
    order_of_error::<8>(0.08);
}

/// The times at which the drive reaches its turning points (extended system, 40 digits).
fn turning_points() -> [f64; 2] {
    [0.662_460_552_146_186_5, 2.178_426_263_359_593].map(|theta: f64| {
        // theta(t) = 0.7 + 0.5 t + 0.125 t^2
        -2.0 + (4.0 - 8.0 * (0.7 - theta)).sqrt()
    })
}

/// No series converges beyond a turning point, and near one its radius is the distance to it. Half
/// way, where four singularities are about equally near, the estimate is up to a tenth too large.
#[test]
fn the_radius_of_convergence_is_the_distance_to_a_turning_point() {
    let model: five_link::Model<f64> = support::five_link_model();
    let rough = support::five_link_rough();
    let mut motion = support::motions(&model, &rough, support::five_link_inputs)[0];
    let [first, last] = turning_points();
    for step in 0..=195 {
        let t = f64::from(step) * 0.01;
        Tracker::default()
            .advance(
                &model,
                support::five_link_inputs,
                (t - 0.01).max(0.0),
                t,
                &mut motion,
            )
            .expect("a regular motion");
        let series = series::<_, 12>(&model, support::five_link_inputs(t), &motion.position);
        let radius = series.radius().expect("12 coefficients");
        let turning = (t - first).min(last - t);
        assert!(
            radius < 1.1 * turning,
            "{radius} at {t} s, {turning} to a turning point"
        );
        if turning < 0.25 {
            assert!(
                radius > 0.98 * turning,
                "{radius} at {t} s, {turning} to a turning point"
            );
        }
    }
}

/// Fewer orders estimate less well: within a third of the estimate of 40 orders.
#[test]
fn few_orders_estimate_the_radius_of_convergence() {
    let model: five_link::Model<f64> = support::five_link_model();
    let reference = Reference::load();
    for (instant, t) in INSTANTS.into_iter().enumerate() {
        let position = reference.unknowns(instant, "");
        let inputs = support::five_link_inputs(t);
        let best = series::<_, 40>(&model, inputs, &position)
            .radius()
            .expect("40 orders");
        let six = series::<_, 6>(&model, inputs, &position)
            .radius()
            .expect("6 orders");
        let eight = series::<_, 8>(&model, inputs, &position)
            .radius()
            .expect("8 orders");
        println!("{t} s: {best:.4} {six:.4} {eight:.4}");
        for few in [six, eight] {
            assert!(
                (few / best - 1.0).abs() < 0.33,
                "{few} against {best} at {t} s"
            );
        }
        assert_eq!(series::<_, 2>(&model, inputs, &position).radius(), None);
    }
}

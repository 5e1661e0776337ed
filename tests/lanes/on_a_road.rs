//! A wheel that is integrated over a rough road needs as many corrections as the documentation says.

use suspension_core::Signal;
use suspension_core::linkages::double_wishbone::{Corner, Listing};
use suspension_core::step::bounded::Outputs;
use suspension_lanes::Lanes;

const STEP: f64 = 1e-3;

/// The travel of a wheel, m, at each millisecond of a second, with its rates: a damped oscillator that is pushed by up to
/// 100 m/s^2, in each step by another amount.
fn travel() -> Vec<Signal<f64>> {
    let mut at = Signal::<f64>::default();
    let pushes = (0..1000).map(|step| f64::from(step * 7919 % 2003) / 1001.0 - 1.0);
    pushes
        .map(|push| {
            at.second_rate = 100.0 * push - 400.0 * at.value - 20.0 * at.rate;
            at.rate += at.second_rate * STEP;
            at.value += at.rate * STEP;
            at
        })
        .collect()
}

/// The number of steps that lanes with these settings refuse.
fn refused<const CORRECTIONS: usize>() -> usize {
    let corner: Corner = Corner::design().expect("a design");
    let start = Signal::still(corner.drives());
    let (models, motions) = ([*corner.model(); 4], [*corner.motion(); 4]);
    let mut lanes = Lanes::<Listing, f64, _, 4, CORRECTIONS>::new(models, &motions);
    let first = lanes.step(Outputs::Acceleration, &[start; 4], 0.0);
    assert!(first.iter().all(Result::is_ok));
    let steps = travel().into_iter().filter(|travel| {
        let mut drives = start;
        drives.value.bump += travel.value;
        drives.rate.bump = travel.rate;
        drives.second_rate.bump = travel.second_rate;
        let results = lanes.step(Outputs::Acceleration, &[drives; 4], STEP);
        results.iter().any(Result::is_err)
    });
    steps.count()
}

#[test]
fn three_corrections_follow_a_wheel_on_a_rough_road() {
    assert_eq!(refused::<3>(), 0);
    let with_one = refused::<1>();
    assert!(with_one > 900, "{with_one} of 1000 refused");
}

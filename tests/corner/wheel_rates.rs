//! The wheel with its derivatives, against differences of wheels near by.

use nalgebra::Vector3;
use suspension_core::wheel::Wheel;
use suspension_core::{Signal, Values};

use super::{Drives, moved};

/// The numbers of a wheel.
fn numbers(wheel: &Wheel<f64>) -> [f64; 8] {
    let ([a, b, c], [d, e, f]) = (wheel.centre.into(), wheel.axis.into());
    [a, b, c, d, e, f, wheel.camber, wheel.toe]
}

#[test]
fn derivatives_per_drive_equal_differences() {
    const STEP: f64 = 1e-4;
    let corner = moved(0.03, 0.01);
    for change in [[1.0, 0.0], [0.0, 1.0], [1.0, -0.5]] {
        let near = |steps: f64| {
            let mut beside = corner;
            let start = corner.drives();
            let drives = start.values().zip(change);
            let drives = Drives::from_values(drives.map(|(at, by)| at + by * steps * STEP));
            beside.step(0.0, Signal::still(drives)).expect("near by");
            numbers(&beside.wheel().expect("a wheel"))
        };
        let derived = corner.per(Drives::from_values(change)).expect("regular");
        let wheel = corner.wheel_rates(&derived.points).expect("a wheel");
        let [behind, at, ahead] = [-1.0, 0.0, 1.0].map(near);
        let rates = numbers(&wheel.rate)
            .into_iter()
            .zip(numbers(&wheel.second_rate));
        assert_eq!(Some(wheel.value), corner.wheel());
        for (number, (rate, second_rate)) in rates.enumerate() {
            let [behind, at, ahead] = [behind, at, ahead].map(|wheel| wheel[number]);
            let slope = (ahead - behind) / (2.0 * STEP);
            let bend = (ahead - 2.0 * at + behind) / (STEP * STEP);
            assert!((rate - slope).abs() < 1e-5, "{number}: {rate}, {slope}");
            assert!(
                (second_rate - bend).abs() < 1e-4,
                "{number}: {second_rate}, {bend}"
            );
        }
        assert!(wheel.rate.camber.abs() > 0.01 && wheel.rate.toe.abs() > 0.01);
    }
}

/// Second rates are those of the drives at a constant rate: `q'' rate^2`.
#[test]
fn rates_in_time_are_those_per_change_of_the_drives() {
    let mut corner = moved(0.03, 0.01);
    let (start, change) = (corner.drives(), Drives::from_values([0.4, -0.1]));
    let end = |dt| Signal::line(start, change, dt);
    corner.step(1e-3, end(1e-3)).expect("near by");
    let derived = corner.per(change).expect("regular");
    let expected = corner.wheel_rates(&derived.points).expect("a wheel");
    let found = corner.wheel_rates(&corner.points()).expect("a wheel");
    for (found, expected) in [
        (found.rate, expected.rate),
        (found.second_rate, expected.second_rate),
    ] {
        for (found, expected) in numbers(&found).into_iter().zip(numbers(&expected)) {
            assert!((found - expected).abs() < 1e-11, "{found}, {expected}");
        }
    }
}

#[test]
fn two_points_in_one_place_are_no_axis() {
    let still = Signal::still([Vector3::new(0.1, 0.7, 0.3); 2]);
    assert_eq!(Wheel::with_rates(&still), None);
}

//! Steps to the position where crank and rod are collinear, to the last digit: velocities are undefined there, and none is
//! returned.

use nalgebra::Vector3;
use suspension_core::{Signal, Values};
use suspension_runtime::Listing;

/// A crank about the x axis, a slider on a line along y, and the rod between them; the slider is driven.
const SLIDER_CRANK: &str = "
    fixed: pivot, pivot_end, line_start, line_end;
    free:  pin, slider;
    hinge crank: pivot, pivot_end -> pin;
    slide guide: slider on line_start -> line_end;
    link rod:    pin -> slider;
    drive along: slider.y;
";

#[test]
fn a_step_that_ends_at_a_lock_returns_no_velocity() {
    const SEED: u64 = 0x10cc;
    let mut random = fastrand::Rng::with_seed(SEED);
    let listing = Listing::parse(SLIDER_CRANK).expect("a listing");
    let (mut refused, mut before) = (0, 0);
    for _ in 0..60 {
        let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
        let crank = between(0.05, 0.5);
        let rod = crank * between(1.1, 6.0);
        let (angle, away) = (between(0.8, 2.2), between(-0.1, 0.1));
        let (sine, cosine) = angle.sin_cos();
        let along = crank * cosine + (rod * rod - (crank * sine).powi(2)).sqrt();
        let at = |x: f64, y: f64, z: f64| Vector3::new(x + away, y, z + away);
        let hardpoints = [
            at(0.0, 0.0, 0.0),
            at(0.1, 0.0, 0.0),
            at(0.0, 0.0, 0.0) + Vector3::y() * 0.01,
            at(0.0, 1.0, 0.0),
            at(0.0, crank * cosine, crank * sine),
            at(0.0, along, 0.0),
        ];
        let locks = [crank + rod, rod - crank];
        for lock in locks {
            let step = |to: f64| {
                let mut corner = listing.corner::<15>(&hardpoints).expect("a geometry");
                let drives = Values::from_values([to]);
                let stepped = corner.step(1.0, Signal::still(drives));
                stepped.map(drop).map_err(|error| error.to_string())
            };
            let error = step(lock);
            refused += usize::from(error.is_err());
            // A ten-thousandth of the way from it there are velocities.
            before += usize::from(step(lock + 1e-4 * (along - lock)).is_ok());
        }
    }
    assert_eq!([refused, before], [120, 120], "seed {SEED:#x}");
}

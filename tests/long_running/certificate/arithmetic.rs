//! Enclosures hold the results of exact rational arithmetic.

use dashu_ratio::Relaxed;
use fastrand::Rng;
use suspension_core::arithmetic::trigonometry::sine_cosine;
use suspension_core::certificate::Enclosed;
use suspension_core::{Real, Scalar};
use suspension_double_double::DoubleDouble;

use super::random::{power_of_ten, sign, uniform};

fn exactly<T: Real>(x: T) -> Relaxed {
    let x: f64 = x.to_subset().expect("f64 holds it");
    Relaxed::try_from(x).expect("finite")
}

/// An enclosure, and a number that lies within.
#[derive(Clone, Debug)]
struct Pair<T> {
    enclosed: Enclosed<T>,
    exact: Relaxed,
}

impl<T: Real> Pair<T> {
    /// Of a number of any size, subnormal ones included, and a radius of any size beside it.
    fn random(rng: &mut Rng, exponents: std::ops::Range<f64>) -> Self {
        let value = T::constant(sign(rng) * power_of_ten(rng, exponents.clone()));
        let radius = match rng.u8(0..4) {
            0 => T::zero(),
            1 => T::constant(power_of_ten(rng, exponents)),
            _ => value.abs() * T::constant(power_of_ten(rng, -18.0..0.0)),
        };
        let share = match rng.u8(0..4) {
            0 => sign(rng),
            _ => uniform(rng, -1.0..1.0),
        };
        Self {
            enclosed: Enclosed::within(value, radius),
            exact: exactly(value) + exactly(radius) * exactly(share),
        }
    }

    fn assert_holds(&self, what: impl std::fmt::Debug) {
        let (value, radius) = (self.enclosed.value(), self.enclosed.radius());
        if !value.is_finite() {
            assert!(!radius.is_finite(), "{what:?}: {:?}", self.enclosed);
            return;
        }
        if !radius.is_finite() {
            return;
        }
        assert!(radius >= T::zero(), "{what:?}: {:?}", self.enclosed);
        let off = exactly(value) - self.exact.clone();
        let radius = exactly(radius);
        assert!(off <= radius && -off <= radius, "{what:?}: {self:?}");
        let magnitude = self.enclosed.magnitude();
        assert!(!magnitude.is_finite() || self.exact <= exactly(magnitude));
        assert!(!magnitude.is_finite() || -self.exact.clone() <= exactly(magnitude));
        let least = self.enclosed.least();
        assert!(!least.is_finite() || self.exact >= exactly(least));
    }
}

/// One of the operations, of enclosures and of exact numbers.
fn combine<T: Real>(operation: u8, [a, b, c]: [&Pair<T>; 3]) -> Pair<T> {
    let [x, y, z] = [a, b, c].map(|pair| pair.exact.clone());
    let (a, b, c) = (a.enclosed, b.enclosed, c.enclosed);
    let (enclosed, exact) = match operation {
        0 => (a + b, x + y),
        1 => (a - b, x - y),
        2 => (a * b, x * y),
        3 => (a.plus_product(b, c), x + y * z),
        4 => (a.minus_product(b, c), x - y * z),
        5 => (-a, -x),
        _ if y == Relaxed::ZERO => (a, x),
        _ => (a / b, x / y),
    };
    Pair { enclosed, exact }
}

const OPERATIONS: u8 = 7;

/// Each operation on numbers of all sizes, and expressions of eight operations.
fn check<T: Real>(all_sizes: std::ops::Range<f64>, seeds: std::ops::Range<u64>) {
    for seed in seeds {
        let mut rng = Rng::with_seed(seed);
        let operation = rng.u8(0..OPERATIONS);
        let sizes = [all_sizes.clone(), -3.0..3.0][usize::from(rng.bool())].clone();
        let [a, b, c] = [(); 3].map(|()| Pair::<T>::random(&mut rng, sizes.clone()));
        combine(operation, [&a, &b, &c]).assert_holds((seed, operation, a, b, c));
        if seed % 8 != 0 {
            continue;
        }
        let mut pool: Vec<Pair<T>> = (0..4)
            .map(|_| Pair::random(&mut rng, sizes.clone()))
            .collect();
        for step in 0..8 {
            let operands = [(); 3].map(|()| &pool[rng.usize(..pool.len())]);
            let result = combine(rng.u8(0..OPERATIONS), operands);
            result.assert_holds((seed, step, operands));
            if result.enclosed.radius().is_finite() {
                let place = rng.usize(..pool.len());
                pool[place] = result;
            }
        }
    }
}

#[test]
fn enclosures_contain_the_exact_rational_results() {
    println!("seeds 0..40000, 0..20000");
    check::<f64>(-323.0..308.0, 0..40_000);
    check::<f32>(-45.0..38.0, 0..20_000);
}

#[test]
fn enclosures_of_non_finite_numbers_have_no_finite_radius() {
    let [one, zero] = [1.0, 0.0].map(Enclosed::exact);
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY].map(Enclosed::exact) {
        for result in [
            odd + one,
            one - odd,
            odd * zero,
            one / odd,
            odd / one,
            one.plus_product(odd, zero),
        ] {
            assert!(!result.radius().is_finite(), "{result:?}");
            assert!(!result.magnitude().is_finite(), "{result:?}");
        }
    }
    for divisor in [
        zero,
        Enclosed::within(1e-300, 1e-300),
        Enclosed::within(-1.0, 2.0),
    ] {
        assert_eq!((one / divisor).radius(), f64::INFINITY);
    }
    let huge = Enclosed::exact(1e300_f64);
    assert!(!(huge * huge).radius().is_finite());
}

#[test]
fn enclosures_of_constants_have_the_radius_of_rounding() {
    for number in [0.1, 1.0 / 3.0, 0.5, 1e-40, 1e-50, -7.0] {
        let [exact, single] = [
            Enclosed::<f64>::constant(number).radius(),
            Enclosed::<f32>::constant(number).radius().into(),
        ];
        assert_eq!(exact, 0.0);
        let off = (f64::from(Enclosed::<f32>::constant(number).value()) - number).abs();
        assert!(
            off <= single && (off > 0.0) == (single > 0.0),
            "{number}: {off:e}, {single:e}"
        );
    }
}

/// Within the enclosure of their operations and the stated error of the formula. Seed 1.
#[test]
fn enclosed_sines_and_cosines_are_within_the_stated_error() {
    let mut rng = Rng::with_seed(1);
    for case in 0..100_000 {
        let quarters = f64::from(rng.i32(-4000..=4000)) * std::f64::consts::FRAC_PI_4;
        let angle = match case % 4 {
            0 => uniform(&mut rng, -6283.0..6283.0),
            1 => sign(&mut rng) * power_of_ten(&mut rng, -20.0..0.5),
            2 => quarters * (1.0 + sign(&mut rng) * power_of_ten(&mut rng, -17.0..-3.0)),
            _ => uniform(&mut rng, 0.0..std::f64::consts::PI),
        };
        let (sine, cosine) = DoubleDouble::from(angle).sine_cosine();
        let found = sine_cosine(Enclosed::exact(angle));
        let single = sine_cosine(Enclosed::exact(angle as f32));
        let of_single = DoubleDouble::from(f64::from(angle as f32)).sine_cosine();
        for (exact, found) in [(sine, found.0), (cosine, found.1)] {
            let off = (exact - DoubleDouble::from(found.value())).nearest().abs();
            assert!(off <= found.radius() + f64::EPSILON, "{angle:e}");
        }
        for (exact, found) in [(of_single.0, single.0), (of_single.1, single.1)] {
            let value = DoubleDouble::from(f64::from(found.value()));
            let off = (exact - value).nearest().abs();
            assert!(off <= f64::from(found.radius()) + f64::EPSILON, "{angle:e}");
        }
    }
}

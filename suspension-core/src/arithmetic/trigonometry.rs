//! Sine and cosine without a branch: for lanes of numbers, and for steps that take the same
//! instructions whatever the angle.

use crate::arithmetic::scalar::Scalar;

/// `pi / 2` as the sum of four parts. The first three have twelve bits, so that their multiples up to 4095 are exact
/// in `f32` too.
const QUARTER_TURN: [f64; 4] = [
    1.570_312_5,
    0.000_483_751_296_997_070_3,
    7.549_533_620_476_723e-8,
    2.563_344_151_594_519e-12,
];

/// Coefficients of `x^3, x^5, ...` of the sine within an eighth of a turn (fdlibm, `k_sin.c`).
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];

/// Coefficients of `x^4, x^6, ...` of the cosine within an eighth of a turn (fdlibm, `k_cos.c`).
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// The largest error of [`sine_cosine`] for angles up to [`LARGEST_ANGLE`] if all its operations are exact: `2^-58`
/// from the polynomials (fdlibm), `2^-53` from the rounded constants 1/3 and 1/6, `2^-80` from the parts of a quarter turn;
/// together below `2^-52`. The bound holds for any whole number of quarter turns that leaves a remainder within an
/// eighth of a turn.
pub(crate) const FORMULA_ERROR: f64 = f64::EPSILON;

/// A thousand turns, in radians: the largest angle for which the bounds below hold.
pub(crate) const LARGEST_ANGLE: f64 = 1e3 * core::f64::consts::TAU;

/// Sine and cosine of an angle in radians. Each is off by at most `EPSILON` for magnitudes up to a thousand turns;
/// both are NaN for an angle that is not finite. `f32` and `f64` give the same bits on every target.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn sine_cosine<T: Scalar>(angle: T) -> (T, T) {
    let turns = (angle * T::constant(core::f64::consts::FRAC_2_PI)).nearest_integer();
    let [first, second, third, last] = QUARTER_TURN.map(T::constant);
    let rest = angle
        .minus_product(turns, first)
        .minus_product(turns, second)
        .minus_product(turns, third)
        .minus_product(turns, last);
    let (sine, cosine) = sine_and_cosine_near_zero(rest);
    // Sine and cosine of whole quarter turns, -1, 0 or 1, as polynomials of a count from -2 to 2.
    let count = turns.minus_product(
        (turns * T::constant(0.25)).nearest_integer(),
        T::constant(4.0),
    );
    let square = count * count;
    let quarter_sine = count * (T::constant(4.0) - square) * T::constant(1.0 / 3.0);
    let quarter_cosine =
        T::one().minus_product(square * (T::constant(7.0) - square), T::constant(1.0 / 6.0));
    (
        (sine * quarter_cosine).plus_product(cosine, quarter_sine),
        (cosine * quarter_cosine).minus_product(sine, quarter_sine),
    )
}

/// Sine and cosine between plus and minus a quarter of `pi`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sine_and_cosine_near_zero<T: Scalar>(x: T) -> (T, T) {
    let square = x * x;
    let sine = x.plus_product(x * square, polynomial(SINE, square));
    let half = square * T::constant(0.5);
    let main = T::one() - half;
    // The rounding error of `main` is added to the small terms.
    let lost = (T::one() - main) - half;
    let cosine = main + lost.plus_product(square * square, polynomial(COSINE, square));
    (sine, cosine)
}

/// `c_0 + c_1 x + c_2 x^2 + ...`, evaluated in pairs so that the chain of operations is short.
#[cfg_attr(not(debug_assertions), inline(always))]
fn polynomial<T: Scalar>(coefficients: [f64; 6], x: T) -> T {
    let [a, b, c, d, e, f] = coefficients.map(T::constant);
    let square = x * x;
    let high = c
        .plus_product(d, x)
        .plus_product(e.plus_product(f, x), square);
    a.plus_product(b, x).plus_product(high, square)
}

#[cfg(test)]
mod tests {
    use super::sine_cosine;

    #[test]
    fn f64_sine_and_cosine_are_within_epsilon_over_1000_turns() {
        for step in -200_000..=200_000 {
            let angle = f64::from(step) * 3.141e-2 + 1e-9;
            let (sine, cosine) = sine_cosine(angle);
            let worst = (sine - libm::sin(angle))
                .abs()
                .max((cosine - libm::cos(angle)).abs());
            assert!(worst <= f64::EPSILON, "{worst} at {angle}");
        }
    }

    #[test]
    fn f32_sine_and_cosine_are_within_epsilon_over_1000_turns() {
        for step in -200_000..=200_000 {
            let angle = step as f32 * 3.141e-2;
            let (sine, cosine) = sine_cosine(angle);
            let worst = (sine - libm::sinf(angle))
                .abs()
                .max((cosine - libm::cosf(angle)).abs());
            assert!(worst <= f32::EPSILON, "{worst} at {angle}");
        }
    }

    #[test]
    fn sine_and_cosine_are_exact_at_zero_and_nan_for_infinity() {
        assert_eq!(sine_cosine(0.0), (0.0, 1.0));
        assert!(sine_cosine(f64::INFINITY).0.is_nan());
        assert!(sine_cosine(f64::NAN).1.is_nan());
    }
}

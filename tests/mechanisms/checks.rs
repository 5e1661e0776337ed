//! Checks for every linkage: derivatives against differences.

use nalgebra::{SVector, Vector3};
use suspension_core::listing::Part;
use suspension_core::signal::ChassisMotion;
use suspension_core::{Build, Inputs, Motion, Newton, Signal, Tangent, Values, assemble};

/// Solves from a guess and returns the points.
pub(crate) fn solve<L, const N: usize>(model: &L, guess: &L::Points, drives: L::Drives) -> L::Points
where
    L: Build<N, Scalar = f64>,
{
    let inputs = Inputs::still(at_rest(drives));
    let mut q = model.unknowns(guess);
    assemble(&Newton::from_afar(), model, &inputs, &mut q).expect("a configuration near by");
    let fixed = model.drive_anchors(*model.fixed(), &model.coordinates(&inputs.drives).value);
    model.points(&q, &fixed)
}

fn at_rest<D: Values<f64>>(drives: D) -> Signal<D> {
    Signal {
        value: drives,
        rate: D::from_values(std::iter::repeat(0.0)),
        second_rate: D::from_values(std::iter::repeat(0.0)),
    }
}

/// The largest distance between the points of two configurations.
pub(crate) fn largest_distance<P: Values<Vector3<f64>>>(a: &P, b: &P) -> f64 {
    let pairs = a.values().zip(b.values());
    pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// Checks that drives lead a mechanism to the points that are expected.
pub(crate) fn meets<L, const N: usize>(
    model: &L,
    guess: &L::Points,
    drives: L::Drives,
    expected: &L::Points,
    tolerance: f64,
) where
    L: Build<N, Scalar = f64>,
{
    let apart = largest_distance(&solve(model, guess, drives), expected);
    let at: Vec<f64> = drives.values().collect();
    assert!(apart < tolerance, "at {at:?}: {apart:e}");
}

/// Numbers between -1 and 1 without a pattern, the same in every run.
struct Crooked(u64);

impl Crooked {
    fn number(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector<const N: usize>(&mut self, size: f64) -> SVector<f64, N> {
        SVector::from_fn(|_, _| size * self.number())
    }
}

/// `a + s b`, point by point.
fn sum<P: Values<Vector3<f64>>>(a: &P, s: f64, b: &P) -> P {
    let sums = a.values().zip(b.values()).map(|(a, b)| a + b * s);
    P::from_values(sums)
}

/// Checks `J`, `C` and the input terms in a configuration that satisfies nothing. The equations
/// are quadratic, so that central differences are exact at any step, and a large one rounds least.
pub(crate) fn derivatives<L, const N: usize>(model: &L, points: &L::Points)
where
    L: Build<N, Scalar = f64>,
{
    let mut crooked = Crooked(1);
    let size = 0.2 * model.size();
    let tolerance = 1e-13 * model.size();
    let q = model.unknowns(points) + crooked.vector::<N>(size);
    let mut crooked_fixed =
        || L::Fixed::from_values(std::iter::repeat_with(|| crooked.vector::<3>(size)));
    let fixed = sum(model.fixed(), 1.0, &crooked_fixed());
    let (v_fixed, w_fixed) = (crooked_fixed(), crooked_fixed());
    let (v, w) = (crooked.vector::<N>(size), crooked.vector::<N>(size));
    let [drives, drive_rate] = [(); 2]
        .map(|()| L::Drives::from_values(std::iter::repeat_with(|| size * crooked.number())));
    let none = L::Fixed::default();
    // F with q, chassis points and drives moved by multiples of v, w and the drives' rates.
    let moved = |a: f64, b: f64, c: f64| {
        let fixed = sum(&sum(&fixed, a, &v_fixed), b, &w_fixed);
        let values = drives
            .values()
            .zip(drive_rate.values())
            .map(|(d, rate)| d + c * rate);
        let drives = L::Drives::from_values(values);
        model.residual(&(q + v * a + w * b), &fixed, &drives)
    };

    let along = model.jacobian(&q, &fixed) * v;
    let inputs = model.drive_rate(&q, &fixed, &v_fixed, &drive_rate)
        + model.chassis_rate(&q, &fixed, &v_fixed);
    let change = (moved(1.0, 0.0, 1.0) - moved(-1.0, 0.0, -1.0)) / 2.0;
    assert!(
        (along - inputs - change).amax() < tolerance,
        "J v + dF/du udot"
    );
    let still = model.drive_rate(&q, &fixed, &none, &L::Drives::default());
    assert_eq!(still.amax(), 0.0);

    let curvature = model.curvature(&v, &v_fixed, &w, &w_fixed);
    let change =
        moved(1.0, 1.0, 0.0) - moved(1.0, 0.0, 0.0) - moved(0.0, 1.0, 0.0) + moved(0.0, 0.0, 0.0);
    assert!((curvature - change).amax() < tolerance, "C(v, w)");

    for column in 0..N {
        let mut step = SVector::<f64, N>::zeros();
        step[column] = size;
        let change = model.residual(&(q + step), &fixed, &drives)
            - model.residual(&(q - step), &fixed, &drives);
        let entries = model.jacobian(&q, &fixed).column(column).into_owned();
        assert!(
            (entries - change / (2.0 * size)).amax() < 1e-13,
            "dF/d {}",
            model.name(Part::Unknown(column))
        );
    }
}

/// A quantity that swings about a value, with its rates at time `t`.
pub(crate) fn swing(about: f64, amplitude: f64, t: f64) -> Signal<f64> {
    const OMEGA: f64 = 2.0;
    let (sine, cosine) = (OMEGA * t + 0.3).sin_cos();
    Signal {
        value: about + amplitude * sine,
        rate: amplitude * OMEGA * cosine,
        second_rate: -amplitude * OMEGA * OMEGA * sine,
    }
}

/// [`derivatives`], and [`motion`] on a chassis that moves, while the drives swing about the design.
pub(crate) fn derivatives_and_motion<L, const N: usize>(
    model: &L,
    design: &L::Points,
    amplitude: f64,
) where
    L: Build<N, Scalar = f64>,
{
    derivatives(model, design);
    motion(model, design, |t| Inputs {
        chassis: heaving(model.fixed(), 0.01, t),
        drives: swinging(model.drives_at(design), amplitude, t),
    });
}

/// All drives swinging about their values in a configuration.
pub(crate) fn swinging<D: Values<f64>>(about: D, amplitude: f64, t: f64) -> Signal<D> {
    let part = |part: fn(Signal<f64>) -> f64| {
        let values = about.values().map(|about| part(swing(about, amplitude, t)));
        D::from_values(values)
    };
    Signal {
        value: part(|signal| signal.value),
        rate: part(|signal| signal.rate),
        second_rate: part(|signal| signal.second_rate),
    }
}

/// The chassis translated as one, each axis in its own measure.
pub(crate) fn heaving<F: Values<Vector3<f64>>>(rest: &F, amplitude: f64, t: f64) -> Signal<F> {
    let shift = [1.0, -0.7, 0.4].map(|share| swing(0.0, share * amplitude, 1.1 * t));
    let part = |part: fn(&Signal<f64>) -> f64| Vector3::from(shift.each_ref().map(part));
    // `swing` is differentiated by its own argument, which runs 1.1 times as fast.
    let (rate, second_rate) = (
        part(|signal| 1.1 * signal.rate),
        part(|signal| 1.21 * signal.second_rate),
    );
    let by = part(|signal| signal.value);
    Signal {
        value: sum(rest, 1.0, &F::from_values(std::iter::repeat(by))),
        rate: F::from_values(std::iter::repeat(rate)),
        second_rate: F::from_values(std::iter::repeat(second_rate)),
    }
}

/// Checks velocities and accelerations of all points, markers and moving chassis points included,
/// against five-point differences of positions. `lengths` is what counts as small.
pub(crate) fn motion<L, C, const N: usize>(
    model: &L,
    guess: &L::Points,
    inputs: impl Fn(f64) -> Inputs<C, L::Drives>,
) where
    L: Build<N, Scalar = f64>,
    C: ChassisMotion<L::Fixed>,
{
    const H: f64 = 5e-3;
    let configuration = |t: f64| {
        let inputs = inputs(t);
        let mut q = model.unknowns(guess);
        assemble(&Newton::from_afar(), model, &inputs, &mut q).expect("a configuration near by");
        let tangent = Tangent::new(model, &inputs, &q).expect("a regular configuration");
        let motion = tangent.motion().expect("finite rates");
        all_points(model, &inputs, &motion)
    };
    let [back2, back, at, on, on2] =
        [-2.0, -1.0, 0.0, 1.0, 2.0].map(|k| configuration(0.4 + k * H));
    let differences = |[a, b, c, d, e]: [f64; 5], scale: f64| {
        let values = back2[0]
            .values()
            .zip(back[0].values())
            .zip(at[0].values())
            .zip(on[0].values())
            .zip(on2[0].values());
        L::Points::from_values(
            values.map(|((((p, q), r), s), t)| (p * a + q * b + r * c + s * d + t * e) / scale),
        )
    };
    let velocity = differences([1.0, -8.0, 0.0, 8.0, -1.0], 12.0 * H);
    let acceleration = differences([-1.0, 16.0, -30.0, 16.0, -1.0], 12.0 * H * H);
    let off = [
        largest_distance(&at[1], &velocity),
        largest_distance(&at[2], &acceleration),
    ]
    .map(|x| x / model.size());
    assert!(
        off[0] < 1e-8 && off[1] < 1e-7,
        "velocity, acceleration off by {off:?}"
    );
}

/// Positions, velocities and accelerations of all points.
fn all_points<L, C, const N: usize>(
    model: &L,
    inputs: &Inputs<C, L::Drives>,
    motion: &Motion<f64, N>,
) -> [L::Points; 3]
where
    L: Build<N, Scalar = f64>,
    C: ChassisMotion<L::Fixed>,
{
    let Signal {
        value,
        rate,
        second_rate,
    } = motion.points(model, inputs);
    [value, rate, second_rate]
}

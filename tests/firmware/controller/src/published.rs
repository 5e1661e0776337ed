//! The published mechanism and motion, that of examples/attia2003.toml: both listings.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::Vector3;
use suspension_core::{
    Build, Inputs, Motion, Newton, Real, Scalar, Signal, Still, Values, assemble,
};

/// The length of a step, s.
pub const STEP: f64 = 1e-3;

/// The steps, from 0 to 1.9 s. The mechanism locks at 1.978 s; the last of the published instants,
/// 1.95 s, is so near that one correction a step does not reach the tolerance of `f64` there.
pub const STEPS: u32 = 1900;

/// Attia 2003, tables 1 and 2 at t = 0: points 1 to 10 in metres, and a wheel centre.
const POINTS: [[f64; 3]; 11] = [
    [-1.396, -0.025, -0.082],
    [-1.301, 0.1168, 0.106],
    [-1.0941, 0.1987, 0.09],
    [-0.9838, 0.2609, -0.0501],
    [-1.095, 0.183, -0.0158],
    [-1.315, 0.400, 0.027],
    [-1.302, 0.383, 0.240],
    [-1.270, 0.315, 0.218],
    [-1.292, 0.309, -0.005],
    [-1.188, 0.418, 0.167],
    [-1.270, 0.415, 0.218],
];

/// The lengths of the five links.
const LINKS: [f64; 5] = [0.445872, 0.298452, 0.247006, 0.315105, 0.311988];

/// The distances within the knuckle that the mechanism keeps, in the order of its listing.
pub trait Knuckle {
    const DISTANCES: [f64; 9];
}

/// 7-6, 8-6, 9-6, 10-6, 8-7, 9-7, 10-7, 9-8, 10-8.
impl<T: Scalar> Knuckle for attia2003::Model<T> {
    const DISTANCES: [f64; 9] = [
        0.214453, 0.214367, 0.098894, 0.190070, 0.078413, 0.256446, 0.139680, 0.224708, 0.141405,
    ];
}

/// 6-7, 6-8, 7-8, 9-6, 9-7, 9-8, 10-6, 10-7, 10-8.
impl<T: Scalar> Knuckle for five_link::Model<T> {
    const DISTANCES: [f64; 9] = [
        0.214453, 0.214367, 0.078413, 0.098894, 0.256446, 0.224708, 0.190070, 0.139680, 0.141405,
    ];
}

/// The model, and where it is at t = 0; `None` where it cannot be assembled.
pub fn start<T, L>() -> Option<(L, Motion<T, 15>)>
where
    T: Real,
    L: Build<15, Scalar = T, Listing: Default> + Knuckle,
{
    let points = POINTS.map(|point| Vector3::from(point).map(T::constant));
    let points = L::Points::from_values(points);
    let lengths = LINKS.into_iter().chain(L::DISTANCES);
    let lengths = L::Lengths::from_values(lengths.map(T::constant));
    let model = L::new(&points).ok()?.with_lengths(&lengths).ok()?;
    let mut position = model.unknowns(&points);
    assemble(
        &Newton::from_afar(),
        &model,
        &inputs::<T, L>(0),
        &mut position,
    )
    .ok()?;
    Some((model, Motion::at_rest(position)))
}

/// Value, rate and second rate of `theta(t) = 0.7 + 0.5 t + 0.125 t^2`, rad, at a step.
pub fn theta(step: u32) -> [f64; 3] {
    let t = f64::from(step) * STEP;
    [0.7 + (0.5 + 0.125 * t) * t, 0.5 + 0.25 * t, 0.25]
}

/// The inputs at a step.
pub fn inputs<T, L>(step: u32) -> Inputs<Still, L::Drives>
where
    T: Real,
    L: Build<15, Scalar = T, Listing: Default>,
{
    let [value, rate, second_rate] =
        theta(step).map(|number| L::Drives::from_values([T::constant(number)]));
    Inputs::still(Signal {
        value,
        rate,
        second_rate,
    })
}

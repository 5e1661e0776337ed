//! The published mechanism and motion, that of examples/attia2003.toml: both listings.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::nalgebra::Vector3;
use suspension_core::{
    Bounded, Build, Inputs, Motion, Newton, Real, Signal, Still, Values, assemble,
};

use crate::steps;

/// The length of a step, s.
pub const STEP: f64 = 1e-3;

/// The number of steps, from 0 to 1.9 s. The mechanism locks at 1.978 s; the last of the published instants, 1.95 s, is so
/// near that one correction per step does not reach the tolerance of `f64` there.
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

/// A model of the published mechanism in a number type. Its functions are compiled here, once, and not for each gauge.
pub trait Published: Build<15, Listing: Default> {
    /// Returns the motion at t = 0 with its rates; `None` if it cannot be assembled.
    fn start() -> Option<(Self, Motion<Self::Scalar, 15>)>;

    /// Steps to the tolerance; returns `false` if that fails.
    fn advance(&self, number: u32, motion: &mut Motion<Self::Scalar, 15>) -> bool;
}

/// The distances within the knuckle are the lengths of a mechanism, in the order of its listing.
macro_rules! published {
    ($linkage:ident, $distances:expr; $($number:ty: $step:ident),*) => {
        $(impl Published for $linkage::Model<$number> {
            #[inline(never)]
            fn start() -> Option<(Self, Motion<$number, 15>)> {
                start(LINKS.into_iter().chain($distances))
            }

            #[inline(never)]
            fn advance(&self, number: u32, motion: &mut Motion<$number, 15>) -> bool {
                steps::$step(self, &inputs::<_, Self>(number), motion).is_ok()
            }
        })*
    };
}

// 7-6, 8-6, 9-6, 10-6, 8-7, 9-7, 10-7, 9-8, 10-8.
published!(attia2003, [
    0.214453, 0.214367, 0.098894, 0.190070, 0.078413, 0.256446, 0.139680, 0.224708, 0.141405,
]; f32: attia2003_f32_exact, f64: attia2003_f64_exact);
// 6-7, 6-8, 7-8, 9-6, 9-7, 9-8, 10-6, 10-7, 10-8.
published!(five_link, [
    0.214453, 0.214367, 0.078413, 0.098894, 0.256446, 0.224708, 0.190070, 0.139680, 0.141405,
]; f32: five_link_f32_exact, f64: five_link_f64_exact);

fn start<T, L>(lengths: impl Iterator<Item = f64>) -> Option<(L, Motion<T, 15>)>
where
    T: Real,
    L: Build<15, Scalar = T, Listing: Default>,
{
    let points = POINTS.map(|point| Vector3::from(point).map(T::constant));
    let points = L::Points::from_values(points);
    let lengths = L::Lengths::from_values(lengths.map(T::constant));
    let model = L::new(&points).ok()?.with_lengths(&lengths).ok()?;
    let mut position = model.unknowns(&points);
    let first = inputs::<T, L>(0);
    assemble(&Newton::from_afar(), &model, &first, &mut position).ok()?;
    let mut motion = Motion::at_rest(position);
    let set_off = Bounded::<T>::default();
    set_off.step(&model, &first, T::zero(), &mut motion).ok()?;
    Some((model, motion))
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

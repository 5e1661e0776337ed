//! The kinds of equation, each with its residual, gradient and curvature.
//!
//! Every kind is at most quadratic in the coordinates, so its second derivative is a constant
//! bilinear form `C(v, w)` and
//!
//! ```text
//! F(q + d) = F(q) + J(q) d + C(d, d) / 2        exactly.
//! ```
//!
//! Residuals are in units of length. Generated code calls these functions; no derivative is
//! written anywhere else.

mod along;
mod bilinear;
mod carried;
mod distance;
mod frame;
mod held;
mod product;
mod stretch;
mod turn;

use crate::arithmetic::scalar::Scalar;
use crate::arithmetic::trigonometry::sine_cosine;
use crate::signal::Signal;

pub use along::{Along, AlongGradient, InPlane, OnLine};
pub use bilinear::Bilinear;
pub use carried::{Carried, CarriedGradient};
pub use distance::Distance;
pub use frame::Frame;
pub use held::Held;
pub use product::Product;
pub use stretch::Stretch;
pub use turn::{Turn, turn_to_coordinate};

/// The coordinate `h = L cos(theta)` that a driving angle prescribes, and its rates by the chain rule. The angle
/// itself stays outside the algebra (Attia 2003, eq. 1.15).
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn angle_to_coordinate<T: Scalar>(length: T, angle: Signal<T>) -> Signal<T> {
    let (sine, cosine) = sine_cosine(angle.value);
    Signal {
        value: length * cosine,
        rate: -length * sine * angle.rate,
        second_rate: -length * (cosine * angle.rate * angle.rate + sine * angle.second_rate),
    }
}

/// The square root by `ROUNDS` rounds of Heron's method, which starts from a guess.
#[inline]
fn square_root<const ROUNDS: usize, T: Scalar>(square: T, guess: T) -> T {
    let half = T::constant(0.5);
    (0..ROUNDS).fold(guess, |root, _| (root + square / root) * half)
}

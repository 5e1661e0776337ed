//! Carriers as the drives of both wheels of an axle move them at once.

use suspension_core::wheel::Carrier;

use crate::quantities::number::Number;
use crate::quantities::reader::wheel::MovingWheel;

/// The rates of two drives that make two points rise at the rates `at`; `rises` are the rates of each point per
/// drive.
pub(crate) fn rates<N: Number>([[a, b], [c, d]]: [[N; 2]; 2], at: [f64; 2]) -> [N; 2] {
    let [first, second] = at.map(N::still);
    let determinant = a * d - b * c;
    [
        (d * first - b * second) / determinant,
        (a * second - c * first) / determinant,
    ]
}

/// A carrier that both drives move at these rates.
pub(crate) fn combined<N: Number>(
    [one, other]: &[MovingWheel<N>; 2],
    [p, q]: [N; 2],
) -> Carrier<N> {
    let [one, other] = [&one.carrier, &other.carrier];
    Carrier {
        centre: one.centre,
        velocity: one.velocity * p + other.velocity * q,
        omega: one.omega * p + other.omega * q,
    }
}

//! Wheels whose travel depends on that of others, as on a twist beam.

use nalgebra::{Matrix2, Vector2, Vector3};

use crate::mechanism::{Coupling, Names, Pair, Suspension};
use crate::prepare::design::Design;

/// The speed of a point per unit of travel up to which rounding alone may cause its motion.
const ROUNDING: f64 = 1e-9;

/// The coupling of each wheel at the design position.
pub(crate) fn couplings<L: Suspension<N>, const N: usize>(
    names: &Names,
    design: &Design<L, N>,
) -> Vec<Coupling> {
    let wheels = &names.wheels;
    let per = wheels.iter().map(|wheel| design.per(wheel.travel?));
    let travels = Travels {
        names,
        pairs: Pair::all(wheels),
        per: per.collect(),
    };
    let all: Vec<Option<Travel>> = (0..wheels.len())
        .map(|wheel| travels.wheel_travel(wheel))
        .collect();
    let moves = |mover: usize, moved: usize| {
        let rates = all[mover].as_ref().map(|travel| &travel.rates);
        let [one, other] = [mover, moved].map(|wheel| &wheels[wheel]);
        let mut carrier = other.points.carrier.into_iter();
        // Dual wheels count as one: neither moves the other.
        let are_dual = one.points.carrier == other.points.carrier && one.is_on_the_side_of(other);
        !are_dual
            && mover != moved
            && rates.is_some_and(|rates| carrier.any(|point| rates[point].amax() > ROUNDING))
    };
    let of_one = |number: usize| Coupling {
        moves_another: (0..wheels.len()).any(|other| moves(number, other)),
        is_moved: (0..wheels.len()).any(|other| moves(other, number)),
        takes_both_drives: all[number].as_ref().is_some_and(|travel| travel.takes_both),
    };
    (0..wheels.len()).map(of_one).collect()
}

/// The effect of each wheel's drive of travel on all points.
struct Travels<'a> {
    names: &'a Names,
    pairs: Vec<Pair>,
    per: Vec<Option<Vec<Vector3<f64>>>>,
}

/// A wheel in travel.
struct Travel {
    /// The velocities of all points.
    rates: Vec<Vector3<f64>>,
    takes_both: bool,
}

impl Travels<'_> {
    /// The travel of a wheel, with the other wheel of its axle held at its height if that has a drive of its own.
    fn wheel_travel(&self, wheel: usize) -> Option<Travel> {
        let own = self.per[wheel].as_ref()?;
        let alone = Travel {
            rates: own.clone(),
            takes_both: false,
        };
        let Some((other, of_other)) = self.opposite(wheel) else {
            return Some(alone);
        };
        let rise = |rates: &[Vector3<f64>], of: usize| {
            let [_, centre] = self.names.wheels[of].points.axis;
            rates[centre].z
        };
        let rises = Matrix2::new(
            rise(own, wheel),
            rise(of_other, wheel),
            rise(own, other),
            rise(of_other, other),
        );
        let across = rises[(0, 1)].abs().max(rises[(1, 0)].abs());
        let is_singular = rises.determinant().abs() <= ROUNDING * rises.norm_squared();
        if across <= ROUNDING * rises.norm() || is_singular {
            return Some(alone);
        }
        let parts = rises.try_inverse()? * Vector2::new(1.0, 0.0);
        let both = own.iter().zip(of_other);
        Some(Travel {
            rates: both.map(|(a, b)| a * parts[0] + b * parts[1]).collect(),
            takes_both: true,
        })
    }

    /// The other wheel of an axle, if it has another drive of travel, with the effect of that drive.
    fn opposite(&self, wheel: usize) -> Option<(usize, &[Vector3<f64>])> {
        let mut pairs = self.pairs.iter();
        let other = pairs.find_map(|pair| pair.other(wheel))?;
        let travel = |wheel: usize| self.names.wheels[wheel].travel;
        let rates = self.per[other].as_deref()?;
        (travel(wheel) != travel(other)).then_some((other, rates))
    }
}

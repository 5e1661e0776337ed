//! The sides of a vehicle in names, and wheels opposite each other.

use crate::file::Axle;
use crate::mechanism::parts::vehicle::Wheel;

/// The sides of a vehicle, as used in names of wheels.
const SIDES: [&str; 2] = ["left", "right"];

/// Two wheels opposite each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pair {
    /// The common part of their names; empty for the only two wheels of a listing.
    pub name: String,
    /// Their numbers.
    pub wheels: [usize; 2],
}

impl Pair {
    /// The pairs of all wheels: two single wheels that are not a front and a rear one, or those whose names differ by
    /// their sides, such as `front_left` and `front_right`; none for two on one side of the vehicle.
    pub fn all(wheels: &[Wheel]) -> Vec<Self> {
        if let [one, other] = wheels {
            let are_in_line = match [one, other].map(|wheel| Axle::from_wheel_name(&wheel.name)) {
                [Some(one), Some(other)] => one != other,
                _ => false,
            };
            let pair = Self {
                name: String::new(),
                wheels: [0, 1],
            };
            return if are_in_line || one.is_on_the_side_of(other) {
                Vec::new()
            } else {
                vec![pair]
            };
        }
        let names: Vec<String> = wheels
            .iter()
            .map(|wheel| remove_side(&wheel.name))
            .collect();
        let pair = |(first, name): (usize, &String)| {
            let others = names.iter().enumerate().skip(first + 1);
            let mut same = others.filter(|(_, other)| *other == name);
            let (second, _) = same.next()?;
            let earlier = names[..first].contains(name);
            let is_across = !wheels[first].is_on_the_side_of(&wheels[second]);
            (!earlier && same.next().is_none() && is_across).then(|| Self {
                name: name.clone(),
                wheels: [first, second],
            })
        };
        names.iter().enumerate().filter_map(pair).collect()
    }

    /// The wheel beside one of the two.
    pub fn other(&self, wheel: usize) -> Option<usize> {
        match self.wheels {
            [one, other] if one == wheel => Some(other),
            [one, other] if other == wheel => Some(one),
            _ => None,
        }
    }
}

/// The side of the vehicle in a name, if it has one.
pub fn side_of(name: &str) -> Option<&'static str> {
    let mut words = name.split('_');
    words.find_map(|word| SIDES.into_iter().find(|side| *side == word))
}

/// The name with the other side instead of its own; `None` for a name without a side.
pub(crate) fn name_on_other_side(name: &str) -> Option<String> {
    let [left, right] = SIDES;
    let exchange = |word| match word {
        word if word == left => right,
        word if word == right => left,
        word => word,
    };
    let words: Vec<&str> = name.split('_').map(exchange).collect();
    let other = words.join("_");
    (other != name).then_some(other)
}

fn remove_side(name: &str) -> String {
    let words = name.split('_').filter(|word| !SIDES.contains(word));
    words.collect::<Vec<_>>().join("_")
}

//! Points that listings need and hardpoint files seldom have, computed from other points.

use super::hardpoints::{Hardpoints, Number};
use super::names::Names;
use crate::vehicle_corner::Side;

/// The distance of an added point of the spin axis from the wheel centre, m.
const INBOARD: f64 = 0.1;

/// The statement of a layout whose right side is the image of its left one.
const MIRROR: &str = "\nmirror: left -> right;";

/// Returns whether a missing point of a layout, given by its statements, can be computed from points that there are.
pub(super) fn has_stand_in(point: &str, statements: &str, has: impl Fn(&str) -> bool) -> bool {
    match point {
        "axle" | "shaft_outer" => has("wheel_centre"),
        "left_axle" | "right_axle" => has("left_wheel_centre"),
        "bar_inner" => has("bar_outer"),
        "strut_high" => has("strut_low") && has("top"),
        _ => {
            let left = of_left(point).filter(|_| statements.contains(MIRROR));
            left.is_some_and(|left| has(&left))
        }
    }
}

/// Returns the name of the point of the left side whose image a point of the right side is.
fn of_left(point: &str) -> Option<String> {
    let words = point.split('_').map(|word| match word {
        "right" => "left",
        word => word,
    });
    let left = words.collect::<Vec<_>>().join("_");
    (left != point).then_some(left)
}

/// Returns the coordinates of a missing point, as the motion file states them, and the reason for them. The other points are
/// in ISO 8855; `metre` is one metre in their unit, and `before` is the prefix of point names.
pub(super) fn stand_in(
    point: &str,
    at: impl Fn(&str) -> Option<[f64; 3]>,
    spin: &Spin,
    (metre, before): (f64, &str),
) -> Option<(String, String)> {
    match point {
        "axle" | "shaft_outer" | "left_axle" | "right_axle" => {
            let mut side = ["left_", "right_"].into_iter();
            let side = side.find(|side| point.starts_with(side));
            let mut offset = spin.inboard(INBOARD * metre);
            if side == Some("right_") {
                offset[1] = 0.0 - offset[1];
            }
            let centre = format!("{before}{}wheel_centre", side.unwrap_or_default());
            let position = format!("{{ from = \"{centre}\", offset = {offset:?} }}");
            let why = format!(
                "on the spin axis, inboard of the wheel centre: {}",
                spin.why
            );
            Some((position, why))
        }
        "bar_inner" => {
            let [x, y, z] = at("bar_outer")?;
            let why = "halfway from bar_outer to the middle of the vehicle: the bar twists about a line across it";
            Some((format!("{:?}", [x, 0.5 * y, z]), why.to_owned()))
        }
        "strut_high" => {
            let [low, top] = [at("strut_low")?, at("top")?];
            let middle = [0, 1, 2].map(|axis| 0.5 * (low[axis] + top[axis]));
            let why = "halfway from strut_low to top: the strut points at its top mount";
            Some((format!("{middle:?}"), why.to_owned()))
        }
        _ => {
            let [x, y, z] = at(&of_left(point)?)?;
            let why = "as the mirror image of the left one";
            Some((format!("{:?}", [x, 0.0 - y, z]), why.to_owned()))
        }
    }
}

/// The direction of the spin axis.
#[derive(Debug)]
pub(super) struct Spin {
    /// Outboard, of length 1, in ISO 8855.
    direction: [f64; 3],
    why: String,
}

impl Spin {
    /// Computes the spin axis of a corner on a `side` from the toe and camber that the file states for `stated_side`;
    /// without them it points straight outboard.
    pub(super) fn new(
        stated: &Hardpoints<'_>,
        names: &Names,
        side: Side,
        stated_side: Side,
    ) -> Self {
        let number = |name: &str| number(stated, names, name, stated_side);
        let (toe, camber) = (number("toe"), number("camber"));
        let radians = |number: Option<&Number>| {
            let value = number.map_or(0.0, |number| number.value);
            if stated.radians {
                value
            } else {
                value.to_radians()
            }
        };
        let (toe_sin, toe_cos) = radians(toe).sin_cos();
        let (camber_sin, camber_cos) = radians(camber).sin_cos();
        let said = [("toe", toe), ("camber", camber)].map(|(what, number)| match number {
            Some(Number { value, place, .. }) => {
                format!("{what} {value} {} ({})", angle(stated), stated.line(place))
            }
            None => format!("no {what} in the file, 0 taken"),
        });
        Self {
            direction: [
                camber_cos * toe_sin,
                side.sign() * camber_cos * toe_cos,
                -camber_sin,
            ],
            why: said.join(", "),
        }
    }

    /// Returns the point at a distance inboard of the wheel centre.
    fn inboard(&self, length: f64) -> [f64; 3] {
        self.direction.map(|part| 0.0 - length * part)
    }
}

fn angle(stated: &Hardpoints<'_>) -> &'static str {
    if stated.radians { "rad" } else { "deg" }
}

/// Returns a number that the file states for a side, or for both.
pub(super) fn number<'a>(
    stated: &'a Hardpoints<'_>,
    names: &Names,
    name: &str,
    side: Side,
) -> Option<&'a Number> {
    let is_of_side = |number: &&Number| number.side.is_none_or(|other| other == side);
    let mut numbers = stated.numbers.iter().filter(is_of_side);
    numbers.find(|number| names.is_of_number(name, &number.key))
}

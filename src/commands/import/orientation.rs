//! The axes of a file, deduced from the order of its points.

use super::hardpoints::Hardpoint;
use super::layout_choice::Choice;
use super::names::Arrangement;
use crate::mechanism::Axes;
use crate::number::number;
use crate::vehicle_corner::Side;

/// The direction of one axis, as a pair of points shows it.
struct Clue {
    axis: usize,
    /// 1 if the axis points as in ISO 8855, -1 if it points the other way.
    sign: f64,
    /// How far the points are from each other along the axis.
    apart: f64,
    why: String,
}

/// Axes and the reasons for them.
#[derive(Debug)]
pub(super) struct Orientation {
    pub(super) axes: Axes,
    /// The points that show these axes.
    pub(super) why: String,
    /// A sentence on each pair of points that contradicts the axes.
    pub(super) doubts: Vec<String>,
}

/// Returns the axes that the user states, or else those that the points show.
///
/// # Errors
///
/// A sentence on what the points show, if no known axes agree with it.
pub(super) fn orientation(
    choice: &Choice<'_>,
    arrangement: &Arrangement,
    stated: Option<Axes>,
    usual: Axes,
) -> Result<Orientation, String> {
    check_side_of_wheel(choice)?;
    check_outboard(choice)?;
    let (clues, against) = clues(choice, arrangement);
    let fits = |axes: &Axes, clue: &Clue| axes.signs()[clue.axis] == clue.sign;
    if let Some(axes) = stated {
        // The side of the corner is checked separately.
        let doubts = clues
            .iter()
            .filter(|clue| clue.axis != 1 && !fits(&axes, clue));
        return Ok(Orientation {
            axes,
            why: "as --axes says".to_owned(),
            doubts: doubts
                .map(|clue| format!("that is doubtful, as {}", clue.why))
                .collect(),
        });
    }
    let why: Vec<&str> = clues.iter().map(|clue| clue.why.as_str()).collect();
    let why = why.join(", ");
    let fit = Axes::ALL.into_iter();
    let fit: Vec<Axes> = fit
        .filter(|axes| clues.iter().all(|clue| fits(axes, clue)))
        .collect();
    match fit.as_slice() {
        [] => Err(format!(
            "the axes are none of iso, adams, sae, as {why}; for iso change the signs of {}, or exchange two points that have each \
             other's names, or say --axes, and --side for the corner that it is",
            turned(&clues)
        )),
        [axes] => Ok(Orientation {
            axes: *axes,
            why: format!("as {why}"),
            doubts: against,
        }),
        [first, ..] => Ok(Orientation {
            axes: if fit.contains(&usual) { usual } else { *first },
            why: "as is usual in such files".to_owned(),
            doubts: against,
        }),
    }
}

/// Returns a clue for each axis of which the points show the direction, and a sentence on points that show another.
fn clues(choice: &Choice<'_>, arrangement: &Arrangement) -> (Vec<Clue>, Vec<String>) {
    let Arrangement { ahead, above, .. } = arrangement;
    let mut otherwise = arrangement.otherwise.iter();
    let is_otherwise = otherwise.any(|name| name == choice.linkage());
    let ahead = if is_otherwise { &[][..] } else { ahead };
    let along = majority(clues_from_order(choice, ahead, 0, "behind"));
    let up = majority(clues_from_order(choice, above, 2, "below"));
    let against = [along.1, up.1].into_iter().flatten();
    let clues = [along.0, up.0, clue_from_side(choice)].into_iter();
    (
        clues.flatten().collect(),
        against
            .map(|clue| {
                format!(
                    "{}: is a coordinate mistyped, or have they each other's names?",
                    clue.why
                )
            })
            .collect(),
    )
}

/// Names the columns whose axes point the other way than those of ISO 8855.
fn turned(clues: &[Clue]) -> String {
    let is_turned = |axis: usize| {
        let mut clues = clues.iter();
        clues.any(|clue| clue.axis == axis && clue.sign < 0.0)
    };
    let names = ["x", "y", "z"].into_iter().enumerate();
    let names = names.filter_map(|(axis, name)| is_turned(axis).then_some(name));
    names.collect::<Vec<_>>().join(" and ")
}

/// Checks that the wheel centre is not alone on its side of the vehicle.
fn check_side_of_wheel(choice: &Choice<'_>) -> Result<(), String> {
    let Some(centre) = choice.point("wheel_centre") else {
        return Ok(());
    };
    let others = choice.off_axis().map(|(_, point)| point);
    let mut others = others.filter(|point| point.at[1] != 0.0);
    let is_across = |point: &Hardpoint| point.at[1] * centre.at[1] < 0.0;
    let first = others.clone().find(|point| is_across(point));
    match first.filter(|_| others.all(is_across)) {
        Some(other) => Err(format!(
            "y is {} at `{}` and {} at `{}`, and all points but the wheel centre are on that side of the vehicle: is the sign of y \
             at `{}` right?",
            number(centre.at[1]),
            centre.name,
            number(other.at[1]),
            other.name,
            centre.name
        )),
        None => Ok(()),
    }
}

/// The largest camber that a wheel may have, degrees.
const MOST_CAMBER: f64 = 15.0;

/// Checks that the columns are not exchanged: in every suspension the wheel centre is further from the middle of the vehicle
/// than all chassis points, and the spin axis lies across the vehicle.
fn check_outboard(choice: &Choice<'_>) -> Result<(), String> {
    let Some(centre) = choice.point("wheel_centre") else {
        return Ok(());
    };
    let is_outboard = |point: &Hardpoint| point.at[1].abs() >= centre.at[1].abs();
    let outboard = || choice.off_axis().filter(|(_, point)| is_outboard(point));
    let on_chassis = outboard().find(|(name, _)| choice.layout.is_on_chassis(name));
    if let Some((_, point)) = on_chassis {
        let [y, at] = [point, centre].map(|point| number(point.at[1]));
        let (name, of) = (&point.name, &centre.name);
        return Err(match outboard().count() {
            1 => format!(
                "y is {y} at `{name}` on the chassis, and no other point off the spin axis is as far from the middle of the vehicle as \
                 `{of}`, at {at}: correct it, or if the columns are swapped, {ORDER}"
            ),
            _ => swapped(&format!(
                "is {y} at `{name}` on the chassis, but {at} at `{of}`"
            )),
        });
    }
    let Some(axle) = choice.point("axle") else {
        return Ok(());
    };
    let [x, y, z] = [0, 1, 2].map(|axis| (axle.at[axis] - centre.at[axis]).abs());
    let (name, of) = (&axle.name, &centre.name);
    let camber = z.atan2(y).to_degrees();
    match x <= y {
        false => Err(swapped(&format!(
            "from `{name}` to `{of}` it changes less than x"
        ))),
        true if camber > MOST_CAMBER => Err(format!(
            "the spin axis, from `{name}` to `{of}`, has a camber of {camber:.0} degrees: correct these points or, if `{name}` is \
             no point of the spin axis, give it a name that import does not know"
        )),
        true => Ok(()),
    }
}

/// The usual order of columns, as a remedy.
const ORDER: &str = "put them in the order x (along), y (across), z (up or down)";

/// Says why the columns seem to be swapped.
fn swapped(why: &str) -> String {
    format!(
        "the columns seem to be swapped: the second one is y, across the vehicle, and {why}; {ORDER}, or correct that point"
    )
}

/// Returns the first clue of the direction that most clues of an axis show, or the points that are furthest apart, and the first
/// clue against it: a mistyped coordinate turns one pair of points round, not the others, and a mistyped sign leaves that pair
/// close together.
fn majority(clues: Vec<Clue>) -> (Option<Clue>, Option<Clue>) {
    let sum: f64 = clues.iter().map(|clue| clue.sign).sum();
    let furthest = clues.iter().max_by(|a, b| a.apart.total_cmp(&b.apart));
    let furthest = furthest.map_or(0.0, |clue| clue.sign);
    let sign = if sum == 0.0 { furthest } else { sum.signum() };
    let (with, against): (Vec<Clue>, Vec<Clue>) =
        clues.into_iter().partition(|clue| clue.sign == sign);
    (with.into_iter().next(), against.into_iter().next())
}

/// Deduces the direction of an axis from each of the pairs that the file has.
fn clues_from_order(
    choice: &Choice<'_>,
    pairs: &[[String; 2]],
    axis: usize,
    is: &str,
) -> Vec<Clue> {
    let clues = pairs.iter().filter_map(|[first, second]| {
        let [first, second] = [choice.point(first)?, choice.point(second)?];
        let [a, b] = [first.at[axis], second.at[axis]];
        let name = ["x", "y", "z"][axis];
        (a != b).then(|| Clue {
            axis,
            sign: (a - b).signum(),
            apart: (a - b).abs(),
            why: format!(
                "{name} is {a} at `{}` and {b} at `{}` {is} it",
                first.name, second.name
            ),
        })
    });
    clues.collect()
}

/// Deduces the direction of the lateral axis from the side that the name of a wheel centre states.
fn clue_from_side(choice: &Choice<'_>) -> Option<Clue> {
    let (point, side) = match choice.point("wheel_centre") {
        Some(point) => (point, point.side?),
        None => (choice.point("left_wheel_centre")?, Side::Left),
    };
    let y = point.at[1];
    (y != 0.0).then(|| Clue {
        axis: 1,
        sign: side.sign() * y.signum(),
        apart: y.abs(),
        why: format!("y is {y} at `{}` on the {}", point.name, side.name()),
    })
}

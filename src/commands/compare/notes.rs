//! What is said above the tables of two suspensions.

use crate::characteristics::{Curves, Parameter};
use crate::commands::compare::differences::{is_same, pair_by_title, same_ways, unmatched};
use crate::commands::compare::over_wheel_travel::{are_unlike, by_wheel, rises};
use crate::commands::compare::suspension::Suspension;
use crate::file::Dimension;
use crate::mechanism::Unit;
use crate::output::page::in_digits;
use crate::quantities::{Axis, CENTRE};

/// Returns one line for each file, with its letter and name.
pub(super) fn legend(sides: [&Suspension; 2]) -> [String; 2] {
    sides.map(|side| {
        let converted = side.converted.as_ref();
        let converted = converted.map_or_else(String::new, |how| format!(", converted {how}"));
        format!("{} ({}{converted})", side.file, side.linkage)
    })
}

/// Returns a sentence for everything that cannot be compared, or not at equal changes.
pub(super) fn notes(sides: [&Suspension; 2]) -> Vec<String> {
    let unit = sides[0].unit;
    let unlike = same_ways(sides).into_iter();
    let unlike = unlike.filter_map(|both| unlike_drives(both, unit));
    let across = opposite_sides_note(sides);
    let [a, b] = sides;
    let lacks = |side, other, name| {
        let curves = unmatched(side, other).into_iter();
        curves.map(move |Curves { title, .. }| {
            format!("{name} has nothing like `{title}`: no curves over it are compared")
        })
    };
    let lacks = lacks(a, b, "B").chain(lacks(b, a, "A"));
    let notes = unlike.chain(lacks).chain(across);
    let notes = notes.chain(unlike_steering(sides));
    let notes = notes.chain(opposite_steering(sides));
    let notes = notes.chain(no_radius(sides));
    let mut curves = sides.into_iter().flat_map(|side| &side.curves);
    let small_steer = curves.find_map(Curves::without_small_steer);
    let shorter_roll = sides.into_iter().find_map(|side| side.shorter_roll.clone());
    let notes = notes.chain(small_steer).chain(shorter_roll);
    let notes = notes.chain(only_in(a, b, "A")).chain(only_in(b, a, "B"));
    notes.collect()
}

/// Names the quantities that only `own` has, in a sentence in which `called` is its file; `None` if the other has all of
/// them.
fn only_in(own: &Suspension, other: &Suspension, called: &str) -> Option<String> {
    let has = |parameter: &Parameter| {
        let mut theirs = other.parameters.iter();
        theirs.any(|of_other| {
            is_same([&parameter.title, &of_other.title]) && parameter.symbol == of_other.symbol
        })
    };
    let mut names: Vec<String> = Vec::new();
    for parameter in own.parameters.iter().filter(|own| !has(own)) {
        let wheel = &parameter.title.wheel;
        let of_wheel = || {
            own.parameters
                .iter()
                .filter(|own| own.title.wheel == *wheel)
        };
        let name = match wheel {
            Some(wheel) if !of_wheel().any(has) => format!("all of `{wheel}`"),
            _ => format!("{} ({})", parameter.title, parameter.symbol),
        };
        if !names.contains(&name) {
            names.push(name);
        }
    }
    (!names.is_empty()).then(|| format!("only {called} has: {}", names.join(", ")))
}

/// Notes that only one of the suspensions has a wheel radius.
fn no_radius([a, b]: [&Suspension; 2]) -> Option<String> {
    let called = if a.lacks_radius { "A" } else { "B" };
    (a.lacks_radius != b.lacks_radius).then(|| {
        format!(
            "{called} states no wheel_radius: write it under [vehicle], so that contact point, scrub radius, mechanical trail and \
             roll centre are compared"
        )
    })
}

/// Notes that steering holds the wheels at their height in only one of the suspensions.
fn unlike_steering([a, b]: [&Suspension; 2]) -> Option<String> {
    let (in_a, in_b) = (a.keeps_height_in_steering()?, b.keeps_height_in_steering()?);
    let [keeps, other] = if in_a { ["A", "B"] } else { ["B", "A"] };
    (in_a != in_b).then(|| {
        format!(
            "the drive of travel of {keeps} keeps the height of the wheel centre in steering, that of {other} does not: what is per steer \
             and over steer is not of the same motion"
        )
    })
}

/// Notes that the drives of steering have opposite signs.
fn opposite_steering(sides: [&Suspension; 2]) -> Option<String> {
    let [(a, to_a), (b, to_b)] = [sides[0].steering()?, sides[1].steering()?];
    (to_a * to_b < 0.0 && opposite_sides_note(sides).is_none()).then(|| {
        format!(
            "`{a}` of A and `{b}` of B turn the wheels opposite ways: this causes most differences per steer and over steer"
        )
    })
}

/// Notes that a wheel on the left is compared with one on the right.
fn opposite_sides_note([a, b]: [&Suspension; 2]) -> Option<String> {
    let centres = pair_by_title([&a.parameters, &b.parameters], |parameter| &parameter.title);
    let across = centres.into_iter().filter(|[a, b]| {
        let is_across = |parameter: &Parameter| parameter.is(&CENTRE, Axis::Y);
        is_across(a) && is_across(b) && a.value * b.value < 0.0
    });
    let wheels = across.map(|[a, b]| match (&a.title.wheel, &b.title.wheel) {
        (Some(wheel), None) => format!("`{wheel}` of A and the wheel of B"),
        (None, Some(wheel)) => format!("the wheel of A and `{wheel}` of B"),
        (Some(wheel), Some(_)) => format!("`{wheel}` of A and of B"),
        (None, None) => "the wheels".to_owned(),
    });
    let wheels: Vec<String> = wheels.collect();
    (!wheels.is_empty()).then(|| {
        format!(
            "{} are on opposite sides of the vehicle: what is along y, the pitch of the virtual steering axis, and what steering does \
             have the other sign",
            wheels.join(", ")
        )
    })
}

/// Notes that drives are of different kinds, or that equal changes of them move the wheels unequally far.
fn unlike_drives(both: [&Curves; 2], unit: Unit) -> Option<String> {
    let [a, b] = both;
    let titles = both.map(|curves| &curves.title);
    let is_by_wheel = are_unlike(both) && by_wheel(both, unit).is_some();
    let by_wheel = "the curves are compared over the travel of the wheel, as far as both go";
    if a.dimension != b.dimension {
        let [what_a, what_b] = both.map(|curves| match curves.dimension {
            Dimension::Angle => "an angle",
            _ => "a length",
        });
        let [a, b] = titles;
        let compared = match is_by_wheel {
            true => by_wheel,
            false => "no curves along them are compared",
        };
        return Some(format!(
            "`{a}` of A is {what_a}, `{b}` of B {what_b}: {compared}"
        ));
    }
    let [rise_a, rise_b] = rises(both).filter(|_| are_unlike(both))?.map(in_digits);
    let compared = match is_by_wheel {
        true => by_wheel.to_owned(),
        false => format!(
            "what is compared over {} is at equal changes of the drives, not of the wheels",
            a.movement
        ),
    };
    let [a, b] = titles;
    Some(format!(
        "on average over the curve the wheel rises by {rise_a} per unit of `{a}` of A and by {rise_b} of `{b}` of B: {compared}"
    ))
}

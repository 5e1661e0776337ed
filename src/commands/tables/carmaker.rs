//! A linear suspension of CarMaker: values and derivatives at the design position.

use std::fmt::Write;

use nalgebra::Vector3;
use suspension_core::listing::MeasureKind;

use crate::commands::tables::wheel::{Rates, Wheel};
use crate::mechanism::{Axle, Description, Measure, is_within};
use crate::number::{exact, without_rounding};

const SPRING: &str = "lSpring";
const BAR: &[&str] = &["bar", "stabi", "arb"];

/// The lengths of force elements, each with the words that measures of them have.
const LENGTHS: [(&str, &[&str]); 3] = [
    (SPRING, &["spring"]),
    ("lDamp", &["damper"]),
    ("lStabi", BAR),
];

/// The lines of an infofile.
pub(super) fn text(
    file: &str,
    mechanism: &Description,
    wheel: &Wheel,
    opposite: Option<&Wheel>,
) -> String {
    let axle = match wheel.axle {
        Some(Axle::Rear) => "SuspR",
        _ => "SuspF",
    };
    let side = if wheel.side < 0.0 { "right" } else { "left" };
    let is_mirrored = opposite.is_none_or(|opposite| wheel.is_mirrored(opposite));
    let valid = if is_mirrored { "left+right" } else { side };
    let mut text = format!(
        "## Kinematics of {}, {side} wheel, of {file}, by suspension {}\n\
         ## Each row: at the design position, per compression, per steering to the left; m and rad\n\
         {axle}.Kin.N = 1\n{axle}.Kin.0.Kind = Linear2D 1\n{axle}.Kin.0.ValidSide = {valid}\n\
         {axle}.Kin.0.InputSide = {side}\n",
        mechanism.linkage,
        env!("CARGO_PKG_VERSION"),
    );
    // A wheel on the left that points inboard is turned to the right.
    let turned = Vector3::new(wheel.about_x, 0.0, -wheel.side * wheel.toe);
    let steer = wheel.per_steer.as_ref();
    let mut row = |name: &str, value: f64, of: &dyn Fn(&Rates) -> f64| {
        let numbers = [value, of(&wheel.per_compression), steer.map_or(0.0, of)];
        let [value, per_compression, per_steer] =
            numbers.map(|number| exact(without_rounding(number)));
        // Writing into a string has no way to fail.
        let _ = writeln!(
            text,
            "{axle}.Kin.0.L.{name} = {value} {per_compression} {per_steer}"
        );
    };
    for (index, name) in ["tx", "ty", "tz"].into_iter().enumerate() {
        row(name, 0.0, &|rates| rates.velocity[index]);
    }
    for (index, name) in ["rx", "ry", "rz"].into_iter().enumerate() {
        row(name, turned[index], &|rates| rates.angles[index]);
    }
    let mut angles = Vec::new();
    for (name, words) in LENGTHS {
        let mut of_element = measures_of(mechanism, wheel, (name, words));
        let is_length = |measure: &Measure| measure.kind == MeasureKind::Length;
        match of_element.clone().find(|(_, measure)| is_length(measure)) {
            Some((measure, _)) => row(name, 0.0, &|rates| rates.measures[measure]),
            None => angles.extend(of_element.next().map(|(_, measure)| (name, &measure.name))),
        }
    }
    for (name, measure) in angles {
        let _ = writeln!(
            text,
            "## no {name}: `{measure}` is an angle, {name} a length"
        );
    }
    text
}

/// The measures of a wheel that may be a force element's: those with one of its words, and as springs those of [springs] that are no
/// bars.
fn measures_of<'a>(
    mechanism: &'a Description,
    wheel: &'a Wheel,
    (element, words): (&'a str, &'a [&'a str]),
) -> impl Iterator<Item = (usize, &'a Measure)> + Clone {
    let has = |words: &[&str], name: &str| words.iter().any(|word| is_within(word, name));
    // Of several wheels, that of this one.
    let is_own = |name: &str| wheel.name.is_empty() || is_within(&wheel.name, name);
    let measures = mechanism.names.measures.iter().enumerate();
    let own = measures.filter(move |(_, measure)| is_own(&measure.name));
    let with_word = own
        .clone()
        .filter(move |(_, measure)| has(words, &measure.name));
    let is_sprung = move |number: usize, measure: &Measure| {
        let mut springs = mechanism.names.vehicle.springs.iter();
        let names = |name: &str| !has(BAR, name) && !has(BAR, &measure.name);
        springs.any(|spring| spring.measure == number && names(&spring.name))
    };
    let sprung =
        own.filter(move |(number, measure)| element == SPRING && is_sprung(*number, measure));
    with_word.chain(sprung)
}

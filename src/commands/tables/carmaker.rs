//! A linear suspension of CarMaker: values and derivatives at the design position.

use std::fmt::Write;

use nalgebra::Vector3;
use suspension_core::listing::MeasureKind;

use crate::commands::tables::wheel_motion::{Rates, WheelMotion};
use crate::mechanism::{Axle, Description, Measure, is_within};
use crate::number::{exact, without_rounding};

const SPRING: &str = "lSpring";
const BAR: &[&str] = &["bar", "stabi", "arb"];

/// The lengths of force elements, each with words in the names of their measures.
const LENGTHS: [(&str, &[&str]); 3] = [
    (SPRING, &["spring"]),
    ("lDamp", &["damper"]),
    ("lStabi", BAR),
];

/// What the file says where the axle is not known.
const ASSUMED: &str = "## SuspF is assumed: the file does not say which axle this is, as axle = \"rear\" under [vehicle] would\n";

/// What the file says of a wheel in the middle.
const NO_SIDE: &str = "## The side is that of the signs of ty, rx and rz: the form has none for a wheel in the middle\n";

pub(super) fn text(
    file: &str,
    mechanism: &Description,
    wheel: &WheelMotion,
    opposite: Option<&WheelMotion>,
) -> String {
    let (axle, assumed) = match wheel.axle {
        Some(Axle::Front) => ("SuspF", ""),
        Some(Axle::Rear) => ("SuspR", ""),
        None => ("SuspF", ASSUMED),
    };
    let (place, side) = (wheel.in_words(), wheel.side_in_words());
    let no_side = if wheel.is_in_middle { NO_SIDE } else { "" };
    let is_mirrored = opposite.is_none_or(|opposite| wheel.is_mirrored(opposite));
    let valid = if is_mirrored { "left+right" } else { side };
    let mut text = format!(
        "## Kinematics of {}, {place}, of {file}, by suspension {}\n\
         ## Each row: at the design position, per m of compression, {}; in m and rad\n\
         {assumed}{no_side}{axle}.Kin.N = 1\n{axle}.Kin.0.Kind = Linear2D 1\n{axle}.Kin.0.ValidSide = {valid}\n\
         {axle}.Kin.0.InputSide = {side}\n",
        mechanism.linkage,
        env!("CARGO_PKG_VERSION"),
        per_steer(mechanism, wheel),
    );
    let (lengths, angles) = force_elements(mechanism, wheel);
    // Writing into a string cannot fail.
    for (name, numbers) in position(wheel).into_iter().chain(lengths) {
        let [value, per_compression, per_steer] =
            numbers.map(|number| exact(without_rounding(number)));
        let _ = writeln!(
            text,
            "{axle}.Kin.0.L.{name} = {value} {per_compression} {per_steer}"
        );
    }
    for (name, measure) in angles {
        let _ = writeln!(
            text,
            "## no {name}: `{measure}` is an angle, {name} a length"
        );
    }
    text
}

/// Says per what the last number of a row is: a rack is driven in metres, a steering arm in radians.
fn per_steer(mechanism: &Description, wheel: &WheelMotion) -> String {
    match wheel.steer.map(|drive| &mechanism.names.drives[drive]) {
        Some(drive) if drive.kind.is_angle() => {
            format!("per rad of `{}` that steers to the left", drive.name)
        }
        Some(drive) => format!("per m of `{}` that steers to the left", drive.name),
        None => "no steering".to_owned(),
    }
}

/// A name with the value at the design position and the derivatives with respect to compression and steering.
type Row = (&'static str, [f64; 3]);

fn row(name: &'static str, value: f64, wheel: &WheelMotion, of: impl Fn(&Rates) -> f64) -> Row {
    let per_steer = wheel.per_steer.as_ref().map_or(0.0, &of);
    (name, [value, of(&wheel.per_compression), per_steer])
}

/// Returns the wheel's position and rotation.
fn position(wheel: &WheelMotion) -> [Row; 6] {
    // A wheel on the left that points inboard is turned to the right.
    let turned = Vector3::new(wheel.about_x, 0.0, -wheel.side * wheel.toe);
    let along = |name, axis: usize| row(name, 0.0, wheel, |rates| rates.velocity[axis]);
    let about = |name, axis: usize| row(name, turned[axis], wheel, |rates| rates.angles[axis]);
    [
        along("tx", 0),
        along("ty", 1),
        along("tz", 2),
        about("rx", 0),
        about("ry", 1),
        about("rz", 2),
    ]
}

/// Returns the rows of the lengths of force elements, and names of elements that have only an angle, with the name of the
/// angle.
fn force_elements<'a>(
    mechanism: &'a Description,
    wheel: &'a WheelMotion,
) -> (Vec<Row>, Vec<(&'static str, &'a str)>) {
    let (mut lengths, mut angles) = (Vec::new(), Vec::new());
    for (name, words) in LENGTHS {
        let mut of_element = measures_of(mechanism, wheel, (name, words));
        let is_length = |measure: &Measure| measure.kind == MeasureKind::Length;
        match of_element.clone().find(|(_, measure)| is_length(measure)) {
            Some((measure, _)) => {
                lengths.push(row(name, 0.0, wheel, |rates| rates.measures[measure]));
            }
            None => angles.extend(of_element.next().map(|(_, measure)| (name, &*measure.name))),
        }
    }
    (lengths, angles)
}

/// Returns the measures of a wheel for a force element: those with one of its words in their names, and for springs the
/// measures of `[springs]` that are not bars.
fn measures_of<'a>(
    mechanism: &'a Description,
    wheel: &'a WheelMotion,
    (element, words): (&'a str, &'a [&'a str]),
) -> impl Iterator<Item = (usize, &'a Measure)> + Clone {
    let has = |words: &[&str], name: &str| words.iter().any(|word| is_within(word, name));
    // With several wheels, the measures of this one.
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

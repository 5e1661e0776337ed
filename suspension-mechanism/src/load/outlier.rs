//! A point that lies far from all others: one of its coordinates is in another unit, as it seems.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::Values;

use crate::failure::Failure;
use crate::file::{Position, Source};
use crate::load::task::Task;
use crate::mechanism::Length;
use crate::number::rounded;

/// How many times as far from the others as these are from each other. Between metres, inches and millimetres lie
/// factors of 25 and more.
const FAR: f64 = 10.0;

/// Fewer other points say too little of a mechanism's size.
const FEWEST: usize = 3;

/// A point that lies far from all others.
#[derive(Clone, Debug)]
pub(super) struct Outlier {
    /// Where the file has it.
    place: Range<usize>,
    pub(super) in_words: String,
}

impl Outlier {
    /// Among the points that the file has by coordinates, as they are given.
    pub(super) fn among<P: Values<Vector3<f64>>>(task: &Task<'_>, given: &P) -> Option<Self> {
        let stated = task.file.points.get_ref();
        let named = task.names.points.iter().zip(given.values());
        let by_coordinates = named.filter_map(|(name, at)| {
            let position = stated.get(name.as_str())?;
            let is_one = matches!(position.get_ref(), Position::At(_));
            is_one.then(|| ((name, position.span()), at))
        });
        let (points, places): (Vec<_>, Vec<_>) = by_coordinates.unzip();
        let mut points = points.into_iter().enumerate();
        points.find_map(|(index, (name, place))| {
            let [away, apart] = distances(&places, index)?;
            (away > FAR * apart).then(|| Self {
                place,
                in_words: in_words(name, task.file.length, [away, apart]),
            })
        })
    }

    /// What is wrong, perhaps in consequence, behind what this says.
    pub(super) fn before(&self, failure: Failure, source: &Source) -> Failure {
        let first = source.refuse(&self.place, &self.in_words);
        let both = |text: String| format!("{first}\n{text}");
        match failure {
            Failure::Input(text) => Failure::Input(both(text)),
            Failure::Solver(text) => Failure::Solver(both(text)),
            other => other,
        }
    }
}

fn in_words(name: &str, unit: Length, [away, apart]: [f64; 2]) -> String {
    let doubt = match unit_within(unit, [away, apart]) {
        Some(other) => format!("is it in {}?", other.in_words()),
        None => "is it mistyped?".to_owned(),
    };
    let (away, unit) = (rounded(away, 3), unit.symbol());
    format!("`{name}` lies {away} {unit} from the other points: {doubt}")
}

/// How far a point is from the nearest of the others, and how far these are apart.
fn distances(places: &[Vector3<f64>], index: usize) -> Option<[f64; 2]> {
    let at = places.get(index)?;
    let others = places.iter().enumerate();
    let others: Vec<_> = others.filter(|(other, _)| *other != index).collect();
    let mut corners = others.iter().map(|(_, at)| (**at, **at));
    let first = corners.next()?;
    let (low, high) = corners.fold(first, |(low, high), (at, _)| (low.inf(&at), high.sup(&at)));
    let away = others.iter().map(|(_, other)| (at - *other).norm());
    let away = away.fold(f64::INFINITY, f64::min);
    (others.len() >= FEWEST).then_some([away, (high - low).norm()])
}

/// The unit in which it would lie among the others; of several the largest.
fn unit_within(unit: Length, [away, apart]: [f64; 2]) -> Option<Length> {
    let factor = |other: &Length| other.metre() / unit.metre();
    let others = Length::ALL.into_iter();
    let within = others.filter(|other| *other != unit && away <= apart * factor(other));
    within.min_by(|a, b| factor(a).total_cmp(&factor(b)))
}

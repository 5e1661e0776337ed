//! A point that lies far from all others, or beside the origin: its coordinates are probably in another unit, or a decimal point
//! has slipped.

use std::ops::Range;

use nalgebra::Vector3;

use crate::failure::Failure;
use crate::file::{Position, Source};
use crate::mechanism::Length;
use crate::number::{exact, rounded};
use crate::prepare::task::Task;

/// The distance of a point from the others above which it is an outlier, as a multiple of the extent of the others.
/// Metres, inches and millimetres differ by factors of 25 and more.
const FAR: f64 = 10.0;

/// The same multiple if one coordinate would lie among those of the others if it were a tenth.
const FAR_BY_ONE_DIGIT: f64 = 1.0;

/// How far beyond the coordinates of the others a tenth, and the other two coordinates, may lie, as a fraction of their extent.
const BESIDE: f64 = 0.25;

/// How far from the middle of two points a point may lie that counts as halfway, as a fraction of their distance: more than the
/// rounding of a file.
const HALFWAY: f64 = 1e-6;

/// The distance of a point from the others once its unit is corrected, as a multiple of the extent of the others.
const IN_UNIT: f64 = 1.5;

/// The distance from the origin below which a point may be in a larger unit, as a fraction of the extent of the others.
const AT_ORIGIN: f64 = 0.01;

/// The distance from the nearest other point above which such a point is alone there, as the same fraction: an origin at the wheel
/// centre has others beside it.
const ALONE: f64 = 0.1;

/// The smallest number of other points: fewer tell too little of a mechanism's size.
const FEWEST: usize = 3;

/// A point that lies far from all others.
#[derive(Clone, Debug)]
pub(crate) struct Outlier {
    /// Its place in the file.
    place: Range<usize>,
    in_words: String,
}

impl Outlier {
    /// The outlier among the points that the file states by coordinates, as given.
    pub(crate) fn find(task: &Task<'_>, given: &[Vector3<f64>]) -> Option<Self> {
        let stated = task.file.points.get_ref();
        let named = task.names.points.iter().zip(given);
        let by_coordinates = named.filter_map(|(name, at)| {
            let position = stated.get(name.as_str())?;
            let is_one = matches!(position.get_ref(), Position::At(_));
            is_one.then(|| ((name, position.span()), *at))
        });
        let (points, places): (Vec<_>, Vec<_>) = by_coordinates.unzip();
        let mut points = points.into_iter().enumerate();
        points.find_map(|(index, (name, place))| {
            let surroundings = Surroundings::new(&places, index)?;
            let unit = task.file.length;
            let far = surroundings.is_far();
            let far = far.then(|| surroundings.in_words(name, unit));
            let in_words = far.or_else(|| surroundings.in_larger_unit(name, unit))?;
            Some(Self { place, in_words })
        })
    }

    /// The note on it, with its place.
    pub(crate) fn note(&self, source: &Source) -> String {
        format!("{}: {}", source.place(&self.place), self.in_words)
    }

    /// A failure that may be a consequence, preceded by this note.
    pub(crate) fn prepend_to(&self, failure: Failure, source: &Source) -> Failure {
        let first = source.refuse(&self.place, &self.in_words);
        let both = |text: String| format!("{first}\n{text}");
        match failure {
            Failure::Input(text) => Failure::Input(both(text)),
            Failure::Solver(text) => Failure::Solver(both(text)),
            other => other,
        }
    }
}

/// A point, and the box of the others' coordinates.
struct Surroundings {
    at: Vector3<f64>,
    low: Vector3<f64>,
    high: Vector3<f64>,
    /// The distance of the point from the nearest of the others, and the extent of the others.
    away: f64,
    apart: f64,
}

impl Surroundings {
    fn new(places: &[Vector3<f64>], index: usize) -> Option<Self> {
        let at = *places.get(index)?;
        // A point that `import` places halfway, or that `mirror` makes, follows the mistake.
        let is_halfway = |point: &Vector3<f64>| {
            let mut ends = places.iter();
            ends.any(|end| (at + end - 2.0 * point).norm() < HALFWAY * (at - end).norm())
        };
        let others = places.iter().enumerate();
        let is_image =
            |place: &Vector3<f64>| *place == at.component_mul(&Vector3::new(1.0, -1.0, 1.0));
        let others = others
            .filter(|(other, place)| *other != index && !is_halfway(place) && !is_image(place));
        let others: Vec<_> = others.map(|(_, place)| *place).collect();
        let first = others.first()?;
        let (low, high) = others.iter().fold((*first, *first), |(low, high), at| {
            (low.inf(at), high.sup(at))
        });
        let away = others.iter().map(|other| (at - other).norm());
        (others.len() >= FEWEST).then(|| Self {
            at,
            low,
            high,
            away: away.fold(f64::INFINITY, f64::min),
            apart: (high - low).norm(),
        })
    }

    fn is_far(&self) -> bool {
        let times = self.away / self.apart;
        times > FAR || (times > FAR_BY_ONE_DIGIT && self.slipped().is_some())
    }

    /// Describes a point beside the origin, with no other near it, that would be among the others if its coordinates were in a
    /// larger unit.
    fn in_larger_unit(&self, name: &str, unit: Length) -> Option<String> {
        let off = self.at.norm();
        let is_at_origin = self.at.amin() > 0.0 && off < AT_ORIGIN * self.apart;
        if !is_at_origin || self.away < ALONE * self.apart {
            return None;
        }
        let is_among = |other: &Length| {
            let at = self.at * (unit.metre() / other.metre());
            (0..3).all(|axis| self.is_among(axis, at[axis]))
        };
        let larger = Length::ALL.into_iter();
        let larger = larger.filter(|other| other.metre() < unit.metre());
        let other = larger.filter(is_among).map(Length::in_words).next()?;
        let (off, unit) = (rounded(off, 4), unit.symbol());
        Some(format!(
            "`{name}` lies {off} {unit} from the origin: is it in {other}?"
        ))
    }

    /// Whether a coordinate lies among those of the others, or beside them.
    fn is_among(&self, axis: usize, value: f64) -> bool {
        let room = BESIDE * self.apart;
        (self.low[axis] - room..=self.high[axis] + room).contains(&value)
    }

    /// The axis of the only coordinate that is not among the others', if a tenth of it is.
    fn slipped(&self) -> Option<usize> {
        let mut off = (0..3).filter(|&axis| !self.is_among(axis, self.at[axis]));
        let (axis, others) = (off.next()?, off.next());
        (others.is_none() && self.is_among(axis, self.at[axis] / 10.0)).then_some(axis)
    }

    fn in_words(&self, name: &str, unit: Length) -> String {
        let doubt = match (self.slipped(), unit_within(unit, [self.away, self.apart])) {
            (Some(axis), _) => {
                let (letter, stated) = (["x", "y", "z"][axis], self.at[axis]);
                let tenth = rounded(stated / 10.0, 12);
                format!(
                    "should its {letter} be {tenth} instead of {}?",
                    exact(stated)
                )
            }
            (None, Some(other)) => format!("is it in {}?", other.in_words()),
            (None, None) => "is it mistyped?".to_owned(),
        };
        let (away, unit) = (rounded(self.away, 4), unit.symbol());
        format!("`{name}` lies {away} {unit} from the other points: {doubt}")
    }
}

/// The unit in which it would be among or near the others; if there are several, the largest.
fn unit_within(unit: Length, [away, apart]: [f64; 2]) -> Option<Length> {
    let factor = |other: &Length| other.metre() / unit.metre();
    let others = Length::ALL.into_iter();
    let within = others.filter(|other| *other != unit && away <= IN_UNIT * apart * factor(other));
    within.min_by(|a, b| factor(a).total_cmp(&factor(b)))
}

//! A measured quantity beside that of the model.

use super::smoothing::smoothed;
use crate::characteristics::Title;
use crate::commands::compare::differences::{Difference, Place};
use crate::output::plot::{Chart, Curve};

pub(super) struct MeasuredQuantity {
    pub(super) title: String,
    pub(super) symbol: String,
    /// The name of the quantity without that of its wheel.
    pub(super) kind: &'static str,
    /// The least change over the places that is well above what rigs resolve, in the unit of the model.
    pub(super) least_change: f64,
    /// Places with the numbers of the model and of the table there.
    pub(super) places: Vec<Place>,
    /// How far along the course the places around one tell of its noise.
    pub(super) around: f64,
    /// How many places are between those that are drawn.
    pub(super) stride: usize,
    /// The curve of the model.
    pub(super) curve: Vec<(f64, f64)>,
}

impl MeasuredQuantity {
    /// Says that no place has a number of both.
    pub(super) fn unknown(&self) -> Option<String> {
        let title = &self.title;
        let message = format!("{title}: no measured place has a value of both");
        self.places.is_empty().then_some(message)
    }

    /// The title of its differences; the name of its wheel, if it has one, is part of it.
    fn title(&self) -> Title {
        Title {
            wheel: None,
            of_wheel: self.title.clone(),
        }
    }

    pub(super) fn largest(&self) -> Option<Difference> {
        self.largest_of(&self.places)
    }

    pub(super) fn largest_without_offset(&self) -> Option<Difference> {
        self.largest_of(&self.without_offset())
    }

    fn largest_of(&self, places: &[Place]) -> Option<Difference> {
        Difference::largest((self.title(), self.symbol.clone()), places)
    }

    /// The model's number at the place nearest to the design position, and the difference there without the noise of the rig
    /// and, between the way there and the way back, in the middle.
    pub(super) fn offset(&self) -> Option<Difference> {
        let places = || self.places.iter();
        let far = |place: &&Place| place.from_design.abs();
        let nearest = places().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        let differences = places().map(|place| (place.at, place.difference()));
        let [model, _] = nearest.values;
        Some(Difference {
            title: self.title(),
            symbol: self.symbol.clone(),
            at: Some(nearest.at),
            values: [
                model,
                model + smoothed(differences, nearest.at, self.around),
            ],
            rms: None,
        })
    }

    fn without_offset(&self) -> Vec<Place> {
        let offset = self.offset().map_or(0.0, |offset| offset.value());
        let shifted = |place: &Place| {
            let [model, measured] = place.values;
            Place {
                values: [model, measured - offset],
                ..*place
            }
        };
        self.places.iter().map(shifted).collect()
    }

    /// The number of the model's curve at a place along it; `None` beyond its ends.
    pub(super) fn on_curve(&self, at: f64) -> Option<f64> {
        let mut pieces = self.curve.windows(2);
        let piece = pieces.find(|ends| (ends[0].0..=ends[1].0).contains(&at))?;
        let [(from, start), (to, end)] = [piece[0], piece[1]];
        Some(start + (end - start) * (at - from) / (to - from))
    }

    /// Draws the curve of the model and the measured points, as they are and without the offset. A curve of one place is a mark,
    /// on which those without the offset would lie.
    pub(super) fn chart(&self, [model, measured]: &[String; 2], across: &str) -> Chart {
        let marks = |name: String, places: &[Place]| Curve {
            name,
            marks: self.drawn(places),
            ..Curve::default()
        };
        let [line, of_one] = match self.curve[..] {
            [_] => [Vec::new(), self.curve.clone()],
            _ => [self.curve.clone(), Vec::new()],
        };
        let model = Curve {
            name: model.clone(),
            line,
            marks: of_one,
            ..Curve::default()
        };
        let mut curves = vec![model, marks(measured.clone(), &self.places)];
        let offset = self.offset().map_or(0.0, |offset| offset.value());
        if offset != 0.0 && self.curve.len() > 1 {
            let shifted = self.without_offset();
            curves.push(marks("without offset".to_owned(), &shifted));
        }
        Chart {
            title: self.title.clone(),
            across: across.to_owned(),
            quantity: self.symbol.clone(),
            curves,
        }
    }

    /// Returns the measured points of places to draw: of many the one with the largest difference, and others.
    fn drawn(&self, places: &[Place]) -> Vec<(f64, f64)> {
        let off = |place: &Place| place.difference().abs();
        let farthest = places.iter().max_by(|a, b| off(a).total_cmp(&off(b)));
        let drawn = places.iter().step_by(self.stride).chain(farthest);
        let drawn = drawn.take(places.len());
        drawn.map(|place| (place.at, place.values[1])).collect()
    }
}

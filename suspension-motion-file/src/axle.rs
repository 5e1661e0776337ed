//! The axles of a car, from the words of names.

use serde::Deserialize;

/// An axle of a car.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axle {
    /// The leading one.
    Front,
    /// The trailing one.
    Rear,
}

impl Axle {
    /// The one that a wheel's name tells, as `front_left` does.
    pub fn of(wheel: &str) -> Option<Self> {
        let axles = [("front", Self::Front), ("rear", Self::Rear)];
        let told = axles.into_iter().find(|(word, _)| is_within(word, wheel));
        told.map(|(_, axle)| axle)
    }
}

/// Whether all words of one name are in another: those of `front` are in `front_left`.
pub fn is_within(words: &str, name: &str) -> bool {
    let has = |word: &str| name.split('_').any(|other| other == word);
    words.split('_').all(has)
}

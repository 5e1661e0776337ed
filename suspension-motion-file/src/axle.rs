//! The axles of a car, recognised by the words of names.

use serde::Deserialize;

/// An axle of a car.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axle {
    /// The front axle.
    Front,
    /// The rear axle.
    Rear,
}

impl Axle {
    /// Returns the axle that a wheel's name states, as `front_left` does.
    pub fn from_wheel_name(wheel: &str) -> Option<Self> {
        let axles = [("front", Self::Front), ("rear", Self::Rear)];
        let found = axles.into_iter().find(|(word, _)| is_within(word, wheel));
        found.map(|(_, axle)| axle)
    }
}

/// Returns whether a name contains all words of another: `front_left` contains `front`.
pub fn is_within(words: &str, name: &str) -> bool {
    let has = |word: &str| name.split('_').any(|other| other == word);
    words.split('_').all(has)
}

//! Sides and ends of the vehicle, and how files state them.

use clap::ValueEnum;

/// A side of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Side {
    /// The left one.
    Left,
    /// The right one.
    Right,
}

impl Side {
    pub(crate) fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// Returns the sign of y on this side: 1 on the left, -1 on the right.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// Returns the side in words.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// Returns the side of the vehicle that a word in small letters names.
pub(crate) fn side_of(word: &str) -> Option<Side> {
    match word {
        "left" | "lh" | "lhs" => Some(Side::Left),
        "right" | "rh" | "rhs" => Some(Side::Right),
        _ => None,
    }
}

/// The sides of the vehicle to which a row of a file belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sides {
    /// The row does not say, or its point is in the middle of the vehicle.
    Unsaid,
    /// One side.
    One(Side),
    /// Both: the row states the left one, and the right one is its mirror image.
    Mirrored,
}

/// An end of the vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum End {
    /// The front axle.
    Front,
    /// The rear axle.
    Rear,
}

impl End {
    /// Returns the end in words.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Front => "front",
            Self::Rear => "rear",
        }
    }
}

/// The corners to which the rows below a heading or a group of columns belong, as far as the heading says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Section {
    pub(crate) end: Option<End>,
    pub(crate) side: Option<Side>,
}

impl Section {
    /// Returns what a word in small letters says.
    pub(crate) fn of_word(word: &str) -> Option<Self> {
        let (end, side) = match corner_of(word) {
            Some((end, side)) => (Some(end), Some(side)),
            None => (end_of(word), side_of(word)),
        };
        (end.is_some() || side.is_some()).then_some(Self { end, side })
    }

    /// Returns its words, the end first.
    pub(crate) fn words(self) -> Vec<&'static str> {
        let (end, side) = (self.end.map(End::name), self.side.map(Side::name));
        end.into_iter().chain(side).collect()
    }

    /// Returns this section, with what it does not say from another one.
    pub(crate) fn or(self, other: Self) -> Self {
        Self {
            end: self.end.or(other.end),
            side: self.side.or(other.side),
        }
    }

    /// Returns whether this section says nothing of what another one says.
    pub(crate) fn lacks(self, other: Self) -> bool {
        (self.end.is_none() || other.end.is_none()) && (self.side.is_none() || other.side.is_none())
    }

    /// Returns the section below another heading, which names an end, a side, both or neither.
    pub(crate) fn below(self, end: Option<End>, side: Option<Side>) -> Self {
        match (end, side) {
            (None, None) => self,
            _ => Self {
                end: end.or(self.end),
                side,
            },
        }
    }
}

/// Returns what to do about two rows of one name, which belong to these ends of the vehicle.
pub(crate) fn remedy(first: Option<End>, second: Option<End>) -> &'static str {
    match (first, second) {
        (Some(first), Some(second)) if first != second => {
            "to import one axle of the two, say --end front or --end rear"
        }
        _ => {
            "leave one of them; if they are of two axles, write headings such as `Front suspension` and `Rear suspension` above \
             the points and say --end front or --end rear"
        }
    }
}

/// Returns the end of the vehicle that spelled words name; `None` if they name none or both.
pub(crate) fn end_of(words: &str) -> Option<End> {
    let [front, rear] = ["front", "rear"].map(|end| words.split('_').any(|word| word == end));
    match (front, rear) {
        (true, false) => Some(End::Front),
        (false, true) => Some(End::Rear),
        _ => None,
    }
}

/// The corners of a vehicle by their codes: front or rear, and left or right, in either order.
const CORNERS: [(&str, End, Side); 7] = [
    ("fl", End::Front, Side::Left),
    ("lf", End::Front, Side::Left),
    ("fr", End::Front, Side::Right),
    ("rf", End::Front, Side::Right),
    ("rl", End::Rear, Side::Left),
    ("lr", End::Rear, Side::Left),
    ("rr", End::Rear, Side::Right),
];

/// Returns the corner that a code in small letters states.
pub(crate) fn corner_of(code: &str) -> Option<(End, Side)> {
    let mut corners = CORNERS.into_iter();
    corners.find_map(|(known, end, side)| (known == code).then_some((end, side)))
}

/// Returns the sides that a field states.
pub(crate) fn sides_of(field: &str) -> Option<Sides> {
    match field.to_ascii_lowercase().as_str() {
        "l" => Some(Sides::One(Side::Left)),
        "r" => Some(Sides::One(Side::Right)),
        "left/right" => Some(Sides::Mirrored),
        "single" => Some(Sides::Unsaid),
        word => Section::of_word(word)?.side.map(Sides::One),
    }
}

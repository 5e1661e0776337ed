//! The heading above rows of numbers.

use serde::Serialize;

use suspension_mechanism::mechanism::Description;

/// The name of a column, and the format of its numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Heading {
    /// The column's name.
    pub name: String,
    /// Whether its numbers are counts, written without a fraction.
    pub counts: bool,
}

impl Heading {
    /// The heading of real numbers.
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            counts: false,
        }
    }
}

/// The description of the rows: the header of a JSON file.
#[derive(Clone, Debug, Serialize)]
pub struct Header {
    linkage: String,
    length: &'static str,
    angle: &'static str,
    time: &'static str,
    axes: String,
}

impl Header {
    /// Describes results of a mechanism.
    pub fn new(mechanism: &Description) -> Self {
        Self {
            linkage: mechanism.linkage.clone(),
            length: mechanism.unit.symbol(),
            angle: mechanism.unit.angle.symbol(),
            time: "s",
            axes: mechanism.axes.in_words(),
        }
    }

    /// Returns the entries with their names.
    #[cfg(feature = "parquet")]
    pub(crate) fn entries(&self) -> [(&'static str, &str); 5] {
        [
            ("linkage", &self.linkage),
            ("length", self.length),
            ("angle", self.angle),
            ("time", self.time),
            ("axes", &self.axes),
        ]
    }
}

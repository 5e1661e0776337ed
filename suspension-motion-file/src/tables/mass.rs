//! The mass of a moving part.

use nalgebra::Vector3;
use serde::{Deserialize, Deserializer};
use toml::Spanned;

use crate::tables::number_list::number_list;
use crate::tables::several_notations::{Written, read_written};

/// The mass of a moving part.
#[derive(Clone, Debug)]
pub enum MassTable {
    /// The mass of a link, which is a uniform rod, or of what is at a point, kg.
    Alone(f64),
    /// The mass and inertia of a body.
    OfBody(BodyMass),
}

/// Mass and inertia of a body.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BodyMass {
    /// The mass, kg.
    pub mass: f64,
    /// The centre of mass at the design position.
    pub centre: Spanned<Centre>,
    /// The inertia about the centre in the file's axes, kg m^2: xx, yy, zz, then, unless they are zero, xy, yz, zx (entries
    /// of the tensor, that is, the products of inertia with a minus sign).
    #[serde(default)]
    pub inertia: Vec<f64>,
}

impl BodyMass {
    /// Converts the mass to other axes with a half turn.
    pub(crate) fn turn(&mut self, turned: impl Fn(Vector3<f64>) -> Vector3<f64>) {
        if let Centre::At(at) = self.centre.get_mut() {
            *at = turned((*at).into()).into();
        }
        let [x, y, z] = turned(Vector3::repeat(1.0)).into();
        let products = self.inertia.iter_mut().skip(3);
        for (product, sign) in products.zip([x * y, y * z, z * x]) {
            *product *= sign;
        }
    }
}

/// A centre of mass.
#[derive(Clone, Debug, Deserialize)]
#[serde(
    untagged,
    expecting = "expected the name of a point, or coordinates [x, y, z]"
)]
pub enum Centre {
    /// At a point of the listing.
    Point(String),
    /// At coordinates.
    At(#[serde(deserialize_with = "number_list")] [f64; 3]),
}

impl<'de> Deserialize<'de> for MassTable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        read_written(deserializer)
    }
}

impl<'de> Written<'de> for MassTable {
    const EXPECTED: &'static str = "a mass in kg, or of a body { mass = 25.0, centre = \"wheel_centre\", inertia = [0.8, 1.2, 0.8] }";

    fn number(mass: f64) -> Option<Self> {
        Some(Self::Alone(mass))
    }

    fn table<D: Deserializer<'de>>(table: D) -> Result<Self, D::Error> {
        BodyMass::deserialize(table).map(Self::OfBody)
    }
}

//! The mass of a moving part.

use std::fmt;

use nalgebra::Vector3;
use serde::Deserialize;
use serde::de::{self, MapAccess, Visitor, value::MapAccessDeserializer};
use toml::Spanned;

use crate::tables::number_list::number_list;

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
    fn deserialize<D: de::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(MassVisitor)
    }
}

struct MassVisitor;

impl<'de> Visitor<'de> for MassVisitor {
    type Value = MassTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a mass in kg, or of a body { mass = 25.0, centre = \"wheel_centre\", inertia = [0.8, 1.2, 0.8] }")
    }

    fn visit_f64<E: de::Error>(self, mass: f64) -> Result<MassTable, E> {
        Ok(MassTable::Alone(mass))
    }

    fn visit_i64<E: de::Error>(self, mass: i64) -> Result<MassTable, E> {
        Ok(MassTable::Alone(mass as f64))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<MassTable, A::Error> {
        BodyMass::deserialize(MapAccessDeserializer::new(map)).map(MassTable::OfBody)
    }
}

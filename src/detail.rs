//! How finely to model: the cheapest method that a scene's needs allow, from measured figures.
//!
//! ```
//! use suspension::detail::{Method, Need, Outputs, choose};
//!
//! // A car far away: 0.1 mm is plenty, and nobody reads accelerations.
//! let need = Need { tolerance: 1e-4, outputs: Outputs::Velocity, step: 1e-3 };
//! let detail = choose(&need).expect("met by a method that was measured");
//! assert_eq!(detail.method, Method::Baked { tolerance: 1e-4 });
//! ```

use std::fmt;
use std::str::FromStr;

use serde::de::{Deserialize, Deserializer, Error};

pub use suspension_core::bounded::Outputs;

use crate::failure::Failure;

/// A way to compute a motion, under the names that tables of figures use.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The solver to its tolerance: `generated`.
    Exact,
    /// One factorisation and a fixed number of corrections: `bounded_1`, `bounded_2`, ...
    Bounded {
        /// Corrections.
        corrections: u8,
    },
    /// Taylor series of this order: `series_2`, ...
    Series {
        /// Order.
        order: u8,
    },
    /// A baked curve of this tolerance in metres: `baked_1e-6`, ...
    Baked {
        /// Tolerance, m.
        tolerance: f64,
    },
}

/// A name that is not a [`Method`]'s: tables also hold methods that are there for comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotAMethod;

impl FromStr for Method {
    type Err = NotAMethod;

    fn from_str(name: &str) -> Result<Self, NotAMethod> {
        fn number<T: FromStr>(digits: &str) -> Result<T, NotAMethod> {
            digits.parse().map_err(|_| NotAMethod)
        }
        match name.split_once('_') {
            None if name == "generated" => Ok(Self::Exact),
            Some(("bounded", digits)) => {
                number(digits).map(|corrections| Self::Bounded { corrections })
            }
            Some(("series", digits)) => number(digits).map(|order| Self::Series { order }),
            Some(("baked", digits)) => number(digits).map(|tolerance| Self::Baked { tolerance }),
            _ => Err(NotAMethod),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("generated"),
            Self::Bounded { corrections } => write!(f, "bounded_{corrections}"),
            Self::Series { order } => write!(f, "series_{order}"),
            Self::Baked { tolerance } => write!(f, "baked_{tolerance:e}"),
        }
    }
}

/// What a part of a scene needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// How far a point may be off, m.
    pub tolerance: f64,
    /// What is read.
    pub outputs: Outputs,
    /// From one instant to the next, s.
    pub step: f64,
}

/// A method and what it was measured to cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// The method.
    pub method: Method,
    /// What it computes.
    pub outputs: Outputs,
    /// Time a step and suspension, ns.
    pub nanoseconds: f64,
    /// The largest error of a position, m.
    pub error: f64,
}

/// One measurement, as tables have it; columns that are not needed here are left out.
#[derive(Clone, Debug, serde::Deserialize)]
struct Row {
    method: String,
    scalar: String,
    lanes: u32,
    step_s: f64,
    #[serde(deserialize_with = "outputs")]
    outputs: Outputs,
    nanoseconds: f64,
    error_position_m: f64,
}

fn outputs<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Outputs, D::Error> {
    match String::deserialize(deserializer)?.as_str() {
        "position" => Ok(Outputs::Position),
        "velocity" => Ok(Outputs::Velocity),
        "acceleration" => Ok(Outputs::Acceleration),
        other => Err(D::Error::custom(format!("unknown outputs `{other}`"))),
    }
}

/// Measured figures of methods.
#[derive(Clone, Debug)]
pub struct Figures {
    rows: Vec<(f64, Detail)>,
}

impl Figures {
    /// Those that were measured for this version, on the published five-point suspension.
    ///
    /// # Errors
    ///
    /// None: the table is part of the program and tested.
    pub fn built_in() -> Result<Self, Failure> {
        Self::parse(
            "src/detail/measured.csv",
            include_str!("detail/measured.csv"),
        )
    }

    /// Reads a table as `suspension chart --csv` writes it: of its rows those in `f64` and one
    /// lane. `name` is for messages.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] where a column is missing or holds no number.
    pub fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let rows = reader.deserialize().collect::<Result<Vec<Row>, _>>();
        let rows = rows.map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        let detail = |row: Row| {
            let detail = Detail {
                method: row.method.parse().ok()?,
                outputs: row.outputs,
                nanoseconds: row.nanoseconds,
                error: row.error_position_m,
            };
            (row.scalar == "f64" && row.lanes == 1).then_some((row.step_s, detail))
        };
        let rows = rows.into_iter().filter_map(detail).collect();
        Ok(Self { rows })
    }

    /// The cheapest of the methods that were measured to meet a need; `None` where there is none.
    ///
    /// Errors grow with the step: a method counts where it was measured with the same step or a
    /// longer one.
    pub fn choose(&self, need: &Need) -> Option<Detail> {
        let meets = |(step, detail): &&(f64, Detail)| {
            *step >= need.step && detail.outputs >= need.outputs && detail.error <= need.tolerance
        };
        let cheapest = self
            .rows
            .iter()
            .filter(meets)
            .min_by(|(_, a), (_, b)| a.nanoseconds.total_cmp(&b.nanoseconds));
        cheapest.map(|(_, detail)| *detail)
    }
}

/// [`Figures::choose`] from the figures of this version.
pub fn choose(need: &Need) -> Option<Detail> {
    Figures::built_in().ok()?.choose(need)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "\
method,scalar,lanes,step_s,outputs,nanoseconds,spread_ns,error_position_m,error_velocity_m_s,error_acceleration_m_s2
nalgebra_lu,f64,1,0.001,position,5,1,1e-15,,
generated,f64,1,0.001,position,400,1,1e-15,,
generated,f64,1,0.001,acceleration,800,1,1e-15,1e-12,1e-10
bounded_1,f64,1,0.001,position,150,1,2e-12,,
bounded_1,f64,1,0.02,position,150,1,1e-5,,
bounded_1,f64,4,0.001,position,40,1,2e-12,,
series_4,f32,1,0.001,position,30,1,1e-7,,
baked_1e-4,f64,1,0.02,velocity,8,1,9e-5,1e-2,
baked_1e-6,f64,1,0.02,velocity,9,1,9e-7,1e-4,
";

    fn chosen(tolerance: f64, outputs: Outputs, step: f64) -> Option<String> {
        let figures = Figures::parse("table", TABLE).expect("a table");
        let need = Need {
            tolerance,
            outputs,
            step,
        };
        figures
            .choose(&need)
            .map(|detail| detail.method.to_string())
    }

    #[test]
    fn the_cheapest_that_meets_the_need() {
        use Outputs::{Acceleration, Position, Velocity};
        for (tolerance, outputs, step, expected) in [
            (1e-4, Position, 1e-3, Some("baked_1e-4")),
            (1e-4, Velocity, 1e-3, Some("baked_1e-4")),
            (1e-5, Velocity, 1e-3, Some("baked_1e-6")),
            (1e-9, Position, 1e-3, Some("bounded_1")),
            (1e-9, Velocity, 1e-3, Some("generated")),
            (1e-9, Position, 2e-3, None),
            (1e-14, Position, 1e-3, Some("generated")),
            (1e-4, Acceleration, 1e-3, Some("generated")),
            (1e-16, Position, 1e-3, None),
        ] {
            let found = chosen(tolerance, outputs, step);
            assert_eq!(
                found.as_deref(),
                expected,
                "{tolerance:e} {outputs:?} {step}"
            );
        }
    }

    #[test]
    fn names_of_methods_are_read_as_written() {
        for name in ["generated", "bounded_2", "series_8", "baked_1e-8"] {
            assert_eq!(
                name.parse::<Method>().map(|m| m.to_string()),
                Ok(name.to_owned())
            );
        }
        for name in [
            "dense_lu",
            "nalgebra_lu",
            "absolute",
            "relative",
            "baked_",
            "bounded_-1",
        ] {
            assert_eq!(name.parse::<Method>(), Err(NotAMethod));
        }
    }

    #[test]
    fn a_wrong_table_is_refused_with_its_line() {
        let text = TABLE.replace("400", "fast");
        let refused = Figures::parse("table.csv", &text).expect_err("not a number");
        let message = refused.to_string();
        assert!(
            message.starts_with("table.csv: ") && message.contains("line: 3"),
            "{message}"
        );
    }

    #[test]
    fn the_built_in_figures_have_a_method_for_every_output() {
        for outputs in [Outputs::Position, Outputs::Velocity, Outputs::Acceleration] {
            let need = Need {
                tolerance: 1e-14,
                outputs,
                step: 1e-3,
            };
            assert_eq!(
                choose(&need).map(|detail| detail.method),
                Some(Method::Exact)
            );
        }
    }
}

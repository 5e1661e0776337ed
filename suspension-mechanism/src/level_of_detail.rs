//! Levels of detail: the cheapest method that a scene's needs allow, from measured figures.
//!
//! ```
//! use suspension_mechanism::level_of_detail::{Method, Need, Outputs, Points, choose};
//!
//! // A car far away: 0.1 mm is plenty, and nobody reads accelerations.
//! let need = Need {
//!     tolerance: 1e-4,
//!     outputs: Outputs::Velocity,
//!     points: Points::Wheel,
//!     step: 1e-3,
//! };
//! let detail = choose(&need).expect("met by a method that was measured");
//! assert_eq!(detail.method, Method::Baked { tolerance: 1e-4 });
//! ```

mod method;
mod row;

pub use method::{Method, NotAMethod};
pub use suspension_core::step::bounded::Outputs;

use crate::failure::Failure;
use row::Row;

/// The points that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Points {
    /// Every free point and marker.
    All,
    /// The centre and the spin axis of the wheel.
    Wheel,
}

/// The need of a part of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Need {
    /// The largest permitted error of a point's position, m.
    pub tolerance: f64,
    /// The outputs that are read.
    pub outputs: Outputs,
    /// The points at which they are read.
    pub points: Points,
    /// The time from one instant to the next, s.
    pub step: f64,
}

/// A method and its measured cost.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detail {
    /// The method.
    pub method: Method,
    /// The outputs that it computes.
    pub outputs: Outputs,
    /// The points for which it computes them.
    pub points: Points,
    /// The time per step and suspension, ns.
    pub nanoseconds: f64,
    /// The largest error of a position, m.
    pub error: f64,
}

/// Measured figures of methods.
#[derive(Clone, Debug)]
pub struct Figures {
    rows: Vec<(f64, Detail)>,
}

impl Figures {
    /// The figures that were measured for this version, on the published five-point suspension.
    ///
    /// # Errors
    ///
    /// None: the table is part of the program and tested.
    pub fn built_in() -> Result<Self, Failure> {
        Self::parse("measured.csv", include_str!("level_of_detail/measured.csv"))
    }

    /// Reads a table as written by the laboratory's `chart --csv`, and keeps its rows in `f64` and one lane. `name`
    /// is for messages.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if a column is missing or holds no number.
    pub fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let rows = reader.deserialize().collect::<Result<Vec<Row>, _>>();
        let rows = rows.map_err(|error| Failure::Input(format!("{name}: {error}")))?;
        let steps = rows.iter().map(|row| Some((row.step_s, row.detail()?)));
        let rows = steps.flatten().collect();
        Ok(Self { rows })
    }

    /// The cheapest of the methods that were measured to meet a need; `None` if there is none.
    ///
    /// Errors grow with the step: a method counts if it was measured with the same step or a longer one.
    pub fn choose(&self, need: &Need) -> Option<Detail> {
        let meets = |(step, detail): &&(f64, Detail)| {
            *step >= need.step
                && detail.outputs >= need.outputs
                && (detail.points == Points::All || need.points == Points::Wheel)
                && detail.error <= need.tolerance
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
method,scalar,lanes,step_s,outputs,nanoseconds,spread_ns,error_position_m,error_velocity_m_s,error_acceleration_m_s2,points
nalgebra_lu,f64,1,0.001,position,5,1,1e-15,,,all
generated,f64,1,0.001,position,400,1,1e-15,,,all
generated,f64,1,0.001,acceleration,800,1,1e-15,1e-12,1e-10,all
bounded_1,f64,1,0.001,position,150,1,2e-12,,,all
bounded_1,f64,1,0.02,position,150,1,1e-5,,,all
bounded_1,f64,4,0.001,position,40,1,2e-12,,,all
series_4,f32,1,0.001,position,30,1,1e-7,,,all
baked_1e-4,f64,1,0.02,velocity,8,1,9e-5,1e-2,,wheel
baked_1e-6,f64,1,0.02,velocity,9,1,9e-7,1e-4,,wheel
baked_1e-6,f64,1,0.02,velocity,27,1,9e-7,1e-4,,all
";

    fn chosen(need: &Need) -> Option<String> {
        let figures = Figures::parse("table", TABLE).expect("a table");
        let detail = figures.choose(need);
        detail.map(|detail| detail.method.to_string())
    }

    #[test]
    fn choose_picks_the_cheapest_method_that_meets_the_need() {
        use Outputs::{Acceleration, Position, Velocity};
        use Points::{All, Wheel};
        for (tolerance, outputs, points, step, expected) in [
            (1e-4, Position, Wheel, 1e-3, Some("baked_1e-4")),
            (1e-4, Velocity, Wheel, 1e-3, Some("baked_1e-4")),
            (1e-7, Velocity, All, 1e-3, Some("generated")),
            (1e-7, Position, All, 1e-3, Some("bounded_1")),
            (1e-5, Velocity, Wheel, 1e-3, Some("baked_1e-6")),
            (1e-5, Velocity, All, 1e-3, Some("baked_1e-6")),
            (1e-9, Position, Wheel, 1e-3, Some("bounded_1")),
            (1e-9, Velocity, Wheel, 1e-3, Some("generated")),
            (1e-9, Position, Wheel, 2e-3, None),
            (1e-14, Position, Wheel, 1e-3, Some("generated")),
            (1e-4, Acceleration, Wheel, 1e-3, Some("generated")),
            (1e-16, Position, Wheel, 1e-3, None),
        ] {
            let need = Need {
                tolerance,
                outputs,
                points,
                step,
            };
            assert_eq!(chosen(&need).as_deref(), expected, "{need:?}");
        }
    }

    #[test]
    fn a_wrong_table_of_figures_is_refused_with_its_line() {
        let text = TABLE.replace("400", "fast");
        let refused = Figures::parse("table.csv", &text).expect_err("not a number");
        let message = refused.to_string();
        assert!(
            message.starts_with("table.csv: ") && message.contains("line: 3"),
            "{message}"
        );
    }

    #[test]
    fn built_in_figures_have_a_method_for_every_output() {
        for outputs in [Outputs::Position, Outputs::Velocity, Outputs::Acceleration] {
            let need = Need {
                tolerance: 1e-14,
                outputs,
                points: Points::All,
                step: 1e-3,
            };
            let method = choose(&need).map(|detail| detail.method);
            let is_exact_or_bounded =
                matches!(method, Some(Method::Exact | Method::Bounded { .. }));
            assert!(is_exact_or_bounded, "{method:?}");
        }
    }
}

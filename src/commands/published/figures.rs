//! The contents of the paper's Fig. 4 and Fig. 5, as text and as plots.

use std::fmt::Write;

use crate::mechanism::{Description, Names, State, Unit};
use crate::output::motion::plots::{Charts, TIME, over_time};
use crate::output::plot::{Chart, Curve};
use crate::quantities::{Axis, CAMBER, CENTRE, Column, KINGPIN, Quantity, columns};

const TITLES: [&str; 2] = [
    "Fig. 4: height of the wheel centre, z of point 11",
    "Fig. 5: kingpin angle and camber angle",
];

/// The curves of the figures, the first in Fig. 4: the paper's name, the name in a legend, the sign in the paper, and the
/// quantity of the catalogue. `alpha = atan((y8 - y6) / (z8 - z6))` has the opposite sign of the usual kingpin angle.
const SHOWN: [(&str, &str, f64, &Quantity); 3] = [
    ("z11", "point 11", 1.0, &CENTRE),
    (
        "alpha",
        "alpha, points 6 and 8: top outboard positive (usual kingpin angle: -alpha)",
        -1.0,
        &KINGPIN,
    ),
    (
        "beta",
        "beta, points 8 and 11: top outboard positive",
        1.0,
        &CAMBER,
    ),
];

const NOTES: &str = "  \
  alpha   kingpin angle: the line of points 6 and 8, positive where point 6 is displaced in the negative y direction
          (top outboard). The usual kingpin angle, positive where the top leans inboard, is -alpha: `kingpin_rad` in
          the CSV file. The printed arctangent of a quotient jumps by 180 deg where z8 passes z6 (at 0.06 s);
          atan2(y8 - y6, z8 - z6) equals it modulo 180 deg and is continuous.
  beta    camber angle: the line of points 8 and 11, positive where the top of the wheel leans outboard.
  The published motion leads the mechanism far beyond the angles of a road car.
  The coordinates of point 11, on which z11 and beta rest, are an assumption: the paper prints none.
";

/// A curve of a figure.
struct Shown {
    name: &'static str,
    legend: &'static str,
    sign: f64,
    column: Column,
}

impl Shown {
    fn all(names: &Names) -> Vec<Self> {
        let of_one = |(name, legend, sign, quantity): (_, _, _, &'static Quantity)| {
            let mut columns = columns([quantity], names).into_iter();
            let column = columns.find(|column| matches!(column.axis, None | Some(Axis::Z)))?;
            Some(Self {
                name,
                legend,
                sign,
                column,
            })
        };
        SHOWN.into_iter().filter_map(of_one).collect()
    }

    /// Returns the value in the unit of plots, with the paper's sign.
    fn value(&self, state: &State) -> f64 {
        let (scale, _) = self.column.dimension.display_scale(Unit::METRE);
        self.column.value(state) * scale * self.sign
    }

    fn heading(&self) -> String {
        let (_, symbol) = self.column.dimension.display_scale(Unit::METRE);
        format!("{} ({symbol})", self.name)
    }

    fn curve(&self, states: [&[State]; 2]) -> Curve {
        over_time(self.legend.to_owned(), states, |state| self.value(state))
    }
}

/// Returns the figures' curves at the kept instants as text.
pub(super) fn text(names: &Names, states: &[State]) -> String {
    let [height, angles] = TITLES;
    let mut out = format!("\n{height}\n{angles}\n\n  t (s)");
    let all = Shown::all(names);
    for shown in &all {
        let _ = write!(out, " | {:>11}", shown.heading());
    }
    out.push('\n');
    for state in states {
        let _ = write!(out, "  {:5.2}", state.t);
        for shown in &all {
            let decimals = shown.column.dimension.decimals(Unit::METRE);
            let _ = write!(out, " | {:>11.decimals$}", shown.value(state));
        }
        out.push('\n');
    }
    out.push('\n');
    out + NOTES
}

/// Returns both figures as plots.
pub(super) fn charts(mechanism: &Description, states: [&[State]; 2]) -> Charts {
    let curves: Vec<_> = Shown::all(&mechanism.names)
        .iter()
        .map(|shown| shown.curve(states))
        .collect();
    let (height, angles) = curves.split_at(1);
    let chart = |title: &str, quantity: &str, curves: &[Curve]| Chart {
        title: title.to_owned(),
        across: TIME.to_owned(),
        quantity: quantity.to_owned(),
        curves: curves.to_vec(),
    };
    vec![
        ("height", chart(TITLES[0], "height z (m)", height)),
        ("angles", chart(TITLES[1], "angle (deg)", angles)),
    ]
}

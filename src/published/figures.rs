//! What the paper's Fig. 4 and Fig. 5 show, as text and as plots.

use std::fmt::Write;

use crate::output::plot::{Chart, Curve};
use crate::study::sweep::Rows;

const TITLES: [&str; 2] = [
    "Fig. 4: height of the wheel centre, z of point 11",
    "Fig. 5: kingpin angle and camber angle",
];

/// A quantity of the figures.
struct Quantity {
    heading: &'static str,
    /// The column of our results, and what it is multiplied with.
    column: &'static str,
    scale: f64,
    digits: usize,
}

/// `alpha = atan((y8 - y6) / (z8 - z6))` has the opposite sign of the usual kingpin angle.
fn quantities() -> [Quantity; 3] {
    let degrees = 1_f64.to_degrees();
    [
        ("z11 (m)", "p11_z", 1.0, 5),
        ("alpha (deg)", "kingpin_rad", -degrees, 3),
        ("beta (deg)", "camber_rad", degrees, 3),
    ]
    .map(|(heading, column, scale, digits)| Quantity {
        heading,
        column,
        scale,
        digits,
    })
}

const NOTES: &str = "  \
  alpha   kingpin angle: the line of points 6 and 8, positive where point 6 is displaced in the negative y direction
          (top outboard). The usual kingpin angle, positive where the top leans inboard, is -alpha: `kingpin_rad` in
          the CSV file. The printed arctangent of a quotient jumps by 180 deg where z8 passes z6 (at 0.06 s);
          atan2(y8 - y6, z8 - z6) equals it modulo 180 deg and is continuous.
  beta    camber angle: the line of points 8 and 11, positive where the top of the wheel leans outboard.
  The coordinates of point 11, on which z11 and beta rest, are an assumption: the paper prints none.
";

/// The figures' curves at the kept instants.
pub fn text(rows: &Rows) -> String {
    let [height, angles] = TITLES;
    let mut out = format!("\n{height}\n{angles}\n\n  t (s)");
    let quantities = quantities();
    for quantity in &quantities {
        let _ = write!(out, " | {:>11}", quantity.heading);
    }
    out.push('\n');
    let times = rows.column("t_s").unwrap_or_default();
    let columns = quantities.map(|quantity| {
        let values = rows.column(quantity.column).unwrap_or_default();
        (quantity, values)
    });
    for (row, t) in times.iter().enumerate() {
        let _ = write!(out, "  {t:5.2}");
        for (quantity, values) in &columns {
            let value = values[row] * quantity.scale;
            let _ = write!(out, " | {value:>11.*}", quantity.digits);
        }
        out.push('\n');
    }
    out.push('\n');
    out + NOTES
}

/// Both figures, by what they show.
pub fn charts(rows: [&Rows; 2]) -> [(&'static str, Chart); 2] {
    let [height, angles] = TITLES;
    let [z11, alpha, beta] = quantities();
    let curve = |name: &str, of: &Quantity| Curve::new(name, of.column, of.scale, rows);
    let chart = |title: &str, quantity: &str, curves| Chart {
        title: title.to_owned(),
        across: "time t (s)".to_owned(),
        quantity: quantity.to_owned(),
        curves,
    };
    let alpha = curve(
        "alpha, points 6 and 8: top outboard positive (usual kingpin angle: -alpha)",
        &alpha,
    );
    let beta = curve("beta, points 8 and 11: top outboard positive", &beta);
    [
        (
            "height",
            chart(height, "height z (m)", vec![curve("point 11", &z11)]),
        ),
        ("angles", chart(angles, "angle (deg)", vec![alpha, beta])),
    ]
}

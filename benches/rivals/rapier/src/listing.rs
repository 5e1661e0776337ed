//! The published listing, from which Rapier's mechanism is built.

use rapier3d_f64::math::Vector;

const DATA: &str = include_str!("../../../../src/commands/published/attia2003.toml");
const LINKS: [&str; 5] = ["d6_1", "d7_2", "d8_3", "d9_4", "d10_5"];

/// Chassis points, lengths of the links to them, the drive.
pub struct Listing {
    pub chassis: [Vector; 5],
    pub lengths: [f64; 5],
    pub theta: [f64; 3],
}

impl Listing {
    pub fn height(&self, t: f64) -> f64 {
        let [c0, c1, c2] = self.theta;
        self.chassis[0].z + self.lengths[0] * (c0 + (c1 + c2 * t) * t).cos()
    }

    /// Returns the published listing, with the printed sign of point 4's x corrected.
    pub fn published() -> Self {
        let data: toml::Table = DATA.parse().expect("valid TOML");
        let numbers = |value: &toml::Value| -> Vec<f64> {
            let values = value.as_array().expect("an array").iter();
            values.map(|x| x.as_float().expect("a number")).collect()
        };
        let mut chassis = std::array::from_fn(|p| {
            Vector::from_slice(&numbers(&data["table1"][format!("p{}", p + 1).as_str()]))
        });
        chassis[3].x = -chassis[3].x;
        let theta = numbers(&data["drive"]["theta_coefficients"]);
        Self {
            chassis,
            lengths: LINKS.map(|name| data["lengths"][name].as_float().expect("a number")),
            theta: std::array::from_fn(|k| theta[k]),
        }
    }
}

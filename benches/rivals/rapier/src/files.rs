//! What the other rivals are given, and what they write.

use std::path::Path;

use rapier3d_f64::math::Vector;

use crate::mechanism::Listing;

const DATA: &str = include_str!("../../../../src/commands/published/attia2003.toml");
const LINKS: [&str; 5] = ["d6_1", "d7_2", "d8_3", "d9_4", "d10_5"];

/// A recorded motion: theta and its rates, then position, velocity and acceleration of five points.
pub struct Start([f64; 48]);

impl Start {
    pub fn points(&self) -> [Vector; 5] {
        self.vectors(3)
    }

    pub fn speeds(&self) -> [Vector; 5] {
        self.vectors(18)
    }

    fn vectors(&self, first: usize) -> [Vector; 5] {
        std::array::from_fn(|point| Vector::from_slice(&self.0[first + 3 * point..]))
    }

    /// From the velocities of three points, rad/s.
    pub fn spin(&self) -> Vector {
        let (q, v) = (self.points(), self.speeds());
        let (first, second) = (v[1] - v[0], v[2] - v[0]);
        first.cross(second) / first.dot(q[2] - q[0])
    }
}

pub fn starts(path: &Path) -> Vec<Start> {
    let numbers = doubles(path);
    let rows = numbers.chunks_exact(48);
    rows.map(|row| Start(std::array::from_fn(|i| row[i])))
        .collect()
}

fn doubles(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).expect("a file of numbers");
    let numbers = bytes.chunks_exact(8);
    numbers
        .map(|bytes| f64::from_le_bytes(bytes.try_into().expect("eight bytes")))
        .collect()
}

pub fn write(path: &Path, numbers: impl IntoIterator<Item = f64>) {
    let bytes: Vec<u8> = numbers.into_iter().flat_map(f64::to_le_bytes).collect();
    std::fs::write(path, bytes).expect("a folder to write to");
}

/// The printed sign of point 4's x corrected.
pub fn listing() -> Listing {
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
    Listing {
        chassis,
        lengths: LINKS.map(|name| data["lengths"][name].as_float().expect("a number")),
        theta: std::array::from_fn(|k| theta[k]),
    }
}

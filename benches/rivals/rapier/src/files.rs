//! The input and output files, the same as those of the other rivals.

use std::path::Path;

use rapier3d_f64::math::Vector;

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

    /// Returns the angular velocity from the velocities of three points, rad/s.
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

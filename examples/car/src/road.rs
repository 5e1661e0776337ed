//! The road: a height above the ground plane, the same in every run.

use std::f64::consts::TAU;

use nalgebra::Vector3;

/// A road surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Road {
    /// z = 0.
    Flat,
    /// Sines along x and y of wavelengths from 1 m to 11 m.
    Bumpy {
        /// Amplitude of the longest, m.
        size: f64,
        /// The beginning of the waves, x in m; they grow over 20 m.
        from: f64,
    },
}

/// The sines: wavelength along x and along y in m, part of the size.
const WAVES: [[f64; 3]; 4] = [
    [11.0, 23.0, 1.0],
    [5.3, 7.9, 0.4],
    [2.3, 4.1, 0.15],
    [1.0, 1.7, 0.04],
];
/// m.
const GROWTH: f64 = 20.0;

impl Road {
    /// Returns the height at a place, and the unit normal there.
    pub fn at(&self, x: f64, y: f64) -> (f64, Vector3<f64>) {
        let Self::Bumpy { size, from } = *self else {
            return (0.0, Vector3::z());
        };
        let grown = ((x - from) / GROWTH).clamp(0.0, 1.0);
        if grown == 0.0 {
            return (0.0, Vector3::z());
        }
        let [mut height, mut along, mut across] = [0.0; 3];
        for [length_x, length_y, part] in WAVES {
            let [k, l] = [TAU / length_x, TAU / length_y];
            let (sine, cosine) = (k * x + l * y).sin_cos();
            height += size * part * sine;
            along += size * part * k * cosine;
            across += size * part * l * cosine;
        }
        let growth = if grown < 1.0 { height / GROWTH } else { 0.0 };
        let normal = Vector3::new(-(along * grown + growth), -across * grown, 1.0);
        (height * grown, normal.normalize())
    }
}

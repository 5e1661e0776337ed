//! The road: a height over the ground plane, the same in every run.

use nalgebra::Vector3;

/// A road surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Road {
    /// z = 0.
    Flat,
    /// Sines along x and y of wavelengths from 1 m to 11 m; this is the height of the longest, m.
    Bumpy(f64),
}

/// The sines: wavelength along x and along y in m, part of the height. Wavelengths along x are no multiples of each other.
const WAVES: [[f64; 3]; 4] = [
    [11.0, 23.0, 1.0],
    [5.3, 7.9, 0.4],
    [2.3, 4.1, 0.15],
    [1.0, 1.7, 0.04],
];

impl Road {
    /// Its height above a place, and the normal there, of unit length.
    pub fn at(&self, x: f64, y: f64) -> (f64, Vector3<f64>) {
        let Self::Bumpy(size) = *self else {
            return (0.0, Vector3::z());
        };
        let [mut height, mut along, mut across] = [0.0; 3];
        for [length_x, length_y, part] in WAVES {
            let [k, l] = [length_x, length_y].map(|length| std::f64::consts::TAU / length);
            let (sine, cosine) = (k * x + l * y).sin_cos();
            height += size * part * sine;
            along += size * part * k * cosine;
            across += size * part * l * cosine;
        }
        (height, Vector3::new(-along, -across, 1.0).normalize())
    }
}

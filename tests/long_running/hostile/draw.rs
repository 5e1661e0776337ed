//! The numbers of a case, made of raw words: from a generator, from proptest or from a fuzzer.

use nalgebra::Vector3;

/// Numbers that arithmetic trips over, in f64 and in f32.
const HOSTILE: [f64; 16] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    1e300,
    -1e300,
    1e160,
    1e39,
    1e20,
    1e6,
    1e-20,
    1e-45,
    1e-200,
    1e-310,
    5e-324,
    -0.0,
    0.0,
];

/// Draws the numbers of one case.
pub(crate) struct Draw<'a> {
    words: &'a mut dyn FnMut() -> u32,
    scale: f64,
    origin: f64,
    reach: f64,
    one_in: u32,
}

impl<'a> Draw<'a> {
    /// The first word decides the size of the mechanism, how far from the origin it is,
    /// how far guesses and drives are from its design, and whether hostile numbers come up.
    pub(crate) fn new(words: &'a mut dyn FnMut() -> u32) -> Self {
        let style = words();
        let scale = match style % 8 {
            0 => 10_f64.powi(((style >> 8) % 41) as i32 - 20),
            _ => 1.0,
        };
        let origin = [0.0, 0.0, 10.0, 1e6][(style >> 16) as usize % 4];
        let reach = [1.0, 0.1, 1e-3, 1e-3][(style >> 12) as usize % 4];
        let one_in = [0, 0, 32, 128][(style >> 24) as usize % 4];
        Self {
            words,
            scale,
            origin: origin * scale,
            reach: reach * scale,
            one_in,
        }
    }

    /// A whole number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.words)() as usize % end
    }

    /// Between -1 and 1, or hostile.
    pub(crate) fn number(&mut self) -> f64 {
        let word = (self.words)();
        if self.one_in > 0 && word.is_multiple_of(self.one_in) {
            HOSTILE[(word >> 8) as usize % HOSTILE.len()]
        } else {
            f64::from(word.cast_signed()) / 2_f64.powi(31)
        }
    }

    /// Zero, small, moderate or large, either way.
    pub(crate) fn moderate(&mut self) -> f64 {
        let size = [0.0, 1e-6, 1e-3, 1e-2, 0.1, 1.0, 1.0, 10.0][self.below(8)];
        self.number() * size
    }

    /// A distance from the design.
    pub(crate) fn distance(&mut self) -> f64 {
        self.moderate() * self.reach
    }

    /// Points of a mechanism; in half of all cases some coincide, lie in line or in a plane.
    pub(crate) fn points(&mut self, count: usize) -> Vec<Vector3<f64>> {
        let mut points: Vec<_> = (0..count)
            .map(|_| {
                let at = Vector3::from_fn(|_, _| self.number());
                at * self.scale + Vector3::repeat(self.origin)
            })
            .collect();
        let [a, b, c] = [0; 3].map(|_| self.below(count));
        match self.below(8) {
            0 => points[a] = points[b],
            1 => points[a] = points[b] + (points[c] - points[b]) * self.number(),
            2 => points.iter_mut().for_each(|point| point.z = self.origin),
            3 => points.iter_mut().for_each(|point| point.x = point.y),
            _ => {}
        }
        points
    }
}

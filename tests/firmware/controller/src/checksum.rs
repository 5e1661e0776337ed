//! A number that distinguishes two motions by their last bit.

/// A number whose bits can be seen.
pub trait Bits: Copy {
    /// The bits, those of `f32` in the lower half.
    fn bits(self) -> u64;
}

impl Bits for f32 {
    fn bits(self) -> u64 {
        u64::from(self.to_bits())
    }
}

impl Bits for f64 {
    fn bits(self) -> u64 {
        self.to_bits()
    }
}

/// FNV-1a with numbers in place of bytes.
#[derive(Clone, Copy)]
pub struct Checksum(u64);

impl Checksum {
    pub fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub fn add<'a, T: Bits + 'a>(&mut self, numbers: impl IntoIterator<Item = &'a T>) {
        for number in numbers {
            self.0 = (self.0 ^ number.bits()).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    pub fn value(self) -> u64 {
        self.0
    }
}

//! Baked motions against the solver and the 40-digit reference.

mod curve;
mod surface;

/// Evenly mixed numbers from 0 to 1, always the same (splitmix64).
fn mixed(seed: u64) -> impl Iterator<Item = f64> {
    (1..).map(move |k: u64| {
        let mut z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (z ^ (z >> 31)) as f64 / u64::MAX as f64
    })
}

//! The model from its points and lengths.

use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, Real};

fn construct<T, L>(points: &L::Points, lengths: &L::Lengths, model: &mut L) -> bool
where
    T: Real,
    L: Build<15, Scalar = T, Listing: Default>,
{
    match L::new(points).and_then(|built| built.with_lengths(lengths)) {
        Ok(built) => {
            *model = built;
            true
        }
        Err(_) => false,
    }
}

/// Exports it for one linkage and one number type.
macro_rules! export {
    ($name:ident, $linkage:ident, $number:ty) => {
        #[unsafe(no_mangle)]
        extern "C" fn $name(
            points: &$linkage::Points<$number>,
            lengths: &$linkage::Lengths<$number>,
            model: &mut $linkage::Model<$number>,
        ) -> bool {
            construct(points, lengths, model)
        }
    };
}

export!(firmware_attia2003_f32_construct, attia2003, f32);
export!(firmware_attia2003_f64_construct, attia2003, f64);
export!(firmware_five_link_f32_construct, five_link, f32);
export!(firmware_five_link_f64_construct, five_link, f64);

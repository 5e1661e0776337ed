//! Proofs of roots, and their preparation.

use suspension_core::certificate::{Certificate, Certifier};
use suspension_core::chassis::RigidMotion;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::signal::ChassisMotion;
use suspension_core::{Inputs, Linkage, Listing, Motion, Real, Signal, Still};

/// The certifier of a model.
fn make<T, L>(linkage: &L, certifier: &mut Certifier<L, 15>)
where
    T: Real,
    L: Linkage<15, Scalar = T, Listing: Listing<15, Model<T> = L>> + Copy,
{
    *certifier = Certifier::new(linkage);
}

/// Radius of the proof and distance of another root.
fn certify<T, L, C>(
    certifier: &Certifier<L, 15>,
    chassis: C,
    drives: &Signal<L::Drives>,
    motion: &Motion<T, 15>,
    read: &mut [T; 2],
) -> bool
where
    T: Real,
    L: Linkage<15, Scalar = T, Listing: Listing<15, Model<T> = L>> + Copy,
    C: ChassisMotion<L::Fixed>,
{
    let inputs = Inputs {
        chassis,
        drives: *drives,
    };
    let Certificate::Proved {
        radius,
        unique_within,
    } = certifier.certify(&inputs, &motion.position)
    else {
        return false;
    };
    *read = [radius, unique_within];
    true
}

/// Exports each call for one linkage and one number type.
macro_rules! export {
    ($linkage:ident, $number:ty: $make:ident, $certify:ident, $moving:ident) => {
        #[unsafe(no_mangle)]
        extern "C" fn $make(
            linkage: &$linkage::Model<$number>,
            certifier: &mut Certifier<$linkage::Model<$number>, 15>,
        ) {
            make(linkage, certifier);
        }

        #[unsafe(no_mangle)]
        extern "C" fn $certify(
            certifier: &Certifier<$linkage::Model<$number>, 15>,
            drives: &Signal<$linkage::Drives<$number>>,
            motion: &Motion<$number, 15>,
            read: &mut [$number; 2],
        ) -> bool {
            certify(certifier, Still, drives, motion, read)
        }

        #[unsafe(no_mangle)]
        extern "C" fn $moving(
            certifier: &Certifier<$linkage::Model<$number>, 15>,
            linkage: &$linkage::Model<$number>,
            chassis: &RigidMotion<$number>,
            drives: &Signal<$linkage::Drives<$number>>,
            motion: &Motion<$number, 15>,
            read: &mut [$number; 2],
        ) -> bool {
            let anchors = chassis.anchors(linkage.fixed());
            certify(certifier, anchors, drives, motion, read)
        }
    };
}

export!(attia2003, f32: firmware_attia2003_f32_certifier, firmware_attia2003_f32_certify,
    firmware_attia2003_f32_moving_certify);
export!(attia2003, f64: firmware_attia2003_f64_certifier, firmware_attia2003_f64_certify,
    firmware_attia2003_f64_moving_certify);
export!(five_link, f32: firmware_five_link_f32_certifier, firmware_five_link_f32_certify,
    firmware_five_link_f32_moving_certify);
export!(five_link, f64: firmware_five_link_f64_certifier, firmware_five_link_f64_certify,
    firmware_five_link_f64_moving_certify);

//! The baked motion of both left corners, and the parts of it that a car uses.
//!
//! ```sh
//! cargo run --release -- bake examples/car/front.toml --drive bump=0.18:0.42 --drive steer=0.32:0.36 --tolerance 1e-5 --points all \
//!     --out examples/car/src/tables/front.rs
//! cargo run --release -- bake examples/car/rear.toml --drive bump=0.20:0.44 --tolerance 1e-5 --points all \
//!     --out examples/car/src/tables/rear.rs
//! ```

/// All points in front.
#[rustfmt::skip]
pub mod front;
/// All points behind.
#[rustfmt::skip]
pub mod rear;

use suspension_core::baked::{Curve, Patch, Surface};

use crate::kinematics::COORDINATES;
use front::FRONT_POINTS_BY_BUMP_AND_STEER as ALL_FRONT;
use rear::REAR_POINTS_BY_BUMP as ALL_REAR;

const TERMS: usize = 6;

/// Places of wheel centre, axle, lower ball and strut among the points of the listing.
pub const IN_FRONT: [usize; 4] = [3, 4, 0, 5];
/// The indices of wheel centre, axle, lateral ball, and of the strut, whose lower end is the lateral ball.
pub const BEHIND: [usize; 4] = [5, 6, 0, 0];

static FRONT_PATCHES: [Patch<f64, COORDINATES, TERMS>; ALL_FRONT.patches.len()] = {
    let mut picked = [[[[0.0; COORDINATES]; TERMS]; TERMS]; ALL_FRONT.patches.len()];
    let mut patch = 0;
    while patch < picked.len() {
        let mut power = 0;
        while power < TERMS {
            picked[patch][power] = pick(&ALL_FRONT.patches[patch][power], &IN_FRONT);
            power += 1;
        }
        patch += 1;
    }
    picked
};

static REAR_SEGMENTS: [[[f64; COORDINATES]; TERMS]; ALL_REAR.segments.len()] = {
    let mut picked = [[[0.0; COORDINATES]; TERMS]; ALL_REAR.segments.len()];
    let mut segment = 0;
    while segment < picked.len() {
        picked[segment] = pick(&ALL_REAR.segments[segment], &BEHIND);
        segment += 1;
    }
    picked
};

/// The front left corner over bump and steer.
pub static FRONT: Surface<'static, f64, COORDINATES, TERMS> = Surface {
    ranges: ALL_FRONT.ranges,
    patches_per_unit: ALL_FRONT.patches_per_unit,
    across: ALL_FRONT.across,
    patches: &FRONT_PATCHES,
};

/// The rear left corner over bump.
pub static REAR: Curve<'static, f64, COORDINATES, TERMS> = Curve {
    range: ALL_REAR.range,
    segments_per_unit: ALL_REAR.segments_per_unit,
    segments: &REAR_SEGMENTS,
};

/// The coordinates of some points, of each power. While it compiles there are no iterators.
const fn pick<const ALL: usize>(
    from: &[[f64; ALL]; TERMS],
    points: &[usize; COORDINATES / 3],
) -> [[f64; COORDINATES]; TERMS] {
    let mut picked = [[0.0; COORDINATES]; TERMS];
    let mut power = 0;
    while power < TERMS {
        let mut at = 0;
        while at < COORDINATES {
            picked[power][at] = from[power][3 * points[at / 3] + at % 3];
            at += 1;
        }
        power += 1;
    }
    picked
}

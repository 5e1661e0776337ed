//! The results of `assemble`, for models of all capacities.

use suspension_core::linkages::double_wishbone;
use suspension_core::nalgebra::SVector;
use suspension_core::{Build, Corner, Inputs, Newton, Signal, Still, assemble};
use suspension_runtime::{Listing, Room, Size, catalogue};

const UNKNOWNS: usize = 12;

/// Returns the configuration for a guess with errors of some metres.
fn found<L: Build<N, Scalar = f64>, const N: usize>(
    corner: &Corner<L, N>,
    off: &[f64; UNKNOWNS],
) -> Option<[f64; UNKNOWNS]> {
    let inputs: Inputs<Still, _> = Inputs::still(Signal::still(corner.drives()));
    let mut q: SVector<f64, N> = corner.motion().position;
    for (x, off) in q.iter_mut().zip(off) {
        *x += off;
    }
    let assembled = assemble(&Newton::from_afar(), corner.model(), &inputs, &mut q);
    assembled.is_ok().then(|| std::array::from_fn(|k| q[k]))
}

fn in_room<const N: usize>(listing: &Listing, off: &[f64; UNKNOWNS]) -> Option<[f64; UNKNOWNS]>
where
    Room<N>: Size,
{
    let design = listing.design().expect("points");
    found(&listing.corner::<N>(&design).expect("a corner"), off)
}

/// Guesses with errors so large that several assemblies are near.
#[test]
fn a_guess_leads_to_the_same_assembly_at_every_model_capacity() {
    let text = catalogue::listing("double_wishbone").expect("a layout");
    let listing = Listing::parse(text).expect("a listing");
    let written: double_wishbone::Corner = Corner::design().expect("a design");
    let mut random = fastrand::Rng::with_seed(4);
    let mut count = 0;
    for _ in 0..60 {
        let off = std::array::from_fn(|_| 0.4 * (random.f64() - 0.5));
        let expected = found(&written, &off);
        count += usize::from(expected.is_some());
        let all = [
            in_room::<15>(&listing, &off),
            in_room::<30>(&listing, &off),
            in_room::<60>(&listing, &off),
            in_room::<120>(&listing, &off),
        ];
        for other in all {
            let apart = match (expected, other) {
                (Some(a), Some(b)) => a
                    .iter()
                    .zip(b)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, f64::max),
                (None, None) => 0.0,
                _ => f64::INFINITY,
            };
            assert!(apart < 1e-9, "{apart} m from the written model's");
        }
    }
    assert!(count > 50, "{count}");
}

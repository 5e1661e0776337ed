//! A motion file for a linkage of your own program.

use crate::failure::Failure;
use crate::file::{MotionFile, Source, check};
use crate::mechanism::{Mechanism, Suspension};
use crate::prepare::mechanism::prepare;
use crate::prepare::task::{Request, Start};

/// Reads a motion file for your own linkage, under the name that the file must give, and brings its mechanism to the
/// first instant. The file states all points and drives, as `suspension motion --help` explains; without `wheel` or
/// `kingpin` in the listing there are no quantities of these. Such a program depends on `suspension-mechanism` and
/// `suspension-core`.
///
/// ```no_run
/// use std::ops::ControlFlow;
/// use std::path::Path;
///
/// use suspension_mechanism::file::Source;
/// use suspension_mechanism::prepare::load_own;
///
/// suspension_core::linkage! {
///     mod double_wishbone {
///         fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
///         free: lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
///         link lower_fore: lower_front -> lower_ball;
///         link lower_aft: lower_rear -> lower_ball;
///         link upper_fore: upper_front -> upper_ball;
///         link upper_aft: upper_rear -> upper_ball;
///         link tie_rod: rack -> tie_ball;
///         body upright: lower_ball, upper_ball, tie_ball, axle_inner, axle_outer;
///         drive bump: axle_outer.z;
///         drive steer: rack.y;
///         wheel: axle_inner -> axle_outer;
///         kingpin: lower_ball -> upper_ball;
///     }
/// }
///
/// # fn main() -> Result<(), suspension_mechanism::failure::Failure> {
/// let source = Source::read(Path::new("my.toml"))?; // linkage = "double_wishbone"
/// let mechanism = load_own::<double_wishbone::Model<f64>, _>("double_wishbone", &source)?;
/// println!("{:?}", mechanism.names.points);
/// let end = mechanism.move_through(&mechanism.instants, &mut |state| {
///     println!("{} s: {:?}", state.t, state.points.value);
///     Ok(ControlFlow::Continue(()))
/// })?;
/// println!("{end:?}"); // whether the motion went through
/// # Ok(())
/// # }
/// ```
///
/// # Errors
///
/// [`Failure::Input`] with a place if the file is wrong, [`Failure::Solver`] if the mechanism does not assemble or
/// does not reach the first instant.
pub fn load_own<L, const N: usize>(
    linkage: &str,
    source: &Source,
) -> Result<Mechanism<L, N>, Failure>
where
    L: Suspension<N, Listing: Default>,
{
    let file = MotionFile::parse(source)?;
    match &file.linkage {
        Some(name) if name.get_ref() == linkage => {}
        Some(name) => {
            let message = format!("unknown linkage `{}`; known are {linkage}", name.get_ref());
            return Err(source.refuse(&name.span(), message));
        }
        None => {
            let message = format!("`linkage = \"{linkage}\"` is missing");
            return Err(source.refuse(&(0..0), message));
        }
    }
    let instants = check::instants(source, &file.time)?;
    let request = Request {
        source,
        file: &file,
        listing: None,
        instants: &instants,
        to: Start::FirstInstant,
    };
    prepare(request, linkage, L::Listing::default())
}

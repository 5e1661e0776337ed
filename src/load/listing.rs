//! Which listing: the linkages that motion files know by name.

use suspension_core::linkages::{attia2003, five_link};

use crate::failure::Failure;
use crate::file::{MotionFile, Source};
use crate::load::prepare::prepare;
use crate::mechanism::{Instants, Mechanism, Suspension, Work};

/// The catalogue: each linkage under the name of its module.
macro_rules! catalogue {
    ($($linkage:ident),+) => {
        /// The names that files use.
        pub(super) const NAMES: &[&str] = &[$(stringify!($linkage)),+];

        /// Does the work on the mechanism of a file that names one of the catalogue.
        pub(super) fn run<W: Work>(
            source: &Source,
            file: &MotionFile,
            instants: &Instants,
            work: W,
        ) -> Result<W::Answer, Failure> {
            match file.linkage.get_ref().as_str() {
                $(stringify!($linkage) => {
                    work.on(&compiled::<$linkage::Model<f64>, _>(source, file, instants)?)
                })+
                _ => Err(unknown(source, file, NAMES)),
            }
        }
    };
}
catalogue!(attia2003, five_link);

/// The mechanism of a file, of a listing that is compiled in.
pub(super) fn compiled<L, const N: usize>(
    source: &Source,
    file: &MotionFile,
    instants: &Instants,
) -> Result<Mechanism<L, N>, Failure>
where
    L: Suspension<N, Listing: Default>,
{
    prepare(source, file, instants, L::Listing::default())
}

/// The file names none of the known linkages.
pub(super) fn unknown(source: &Source, file: &MotionFile, known: &[&str]) -> Failure {
    let wanted = file.linkage.get_ref();
    let message = format!("unknown linkage `{wanted}`; known are {}", known.join(", "));
    source.refuse(&file.linkage.span(), message)
}

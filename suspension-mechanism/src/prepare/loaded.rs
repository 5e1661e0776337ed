//! A motion file that was read, and the mechanism that it describes.

use suspension_runtime::Listing;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{MotionFile, Position, Source, check};
use crate::kinematics::Kinematics;
use crate::mechanism::{Axes, Description, Instants, Mechanism, Suspension, Unit};
use crate::prepare::listing::ChosenListing;
use crate::prepare::mechanism::prepare;
use crate::prepare::task::{Request, Start};

/// A motion file that was read. Its mechanism is prepared on demand.
#[derive(Clone, Debug)]
pub struct Loaded<'a> {
    pub(super) source: &'a Source,
    pub(super) file: MotionFile,
    pub(super) listing: ChosenListing,
    instants: Instants,
}

/// Reads a motion file and its listing, which is in the catalogue, in a file beside it, or in the motion file itself.
///
/// # Errors
///
/// [`Failure::Input`] with a place if the file or the listing is wrong.
pub fn load(source: &Source) -> Result<Loaded<'_>, Failure> {
    let mut file = MotionFile::parse(source)?;
    let instants = check::instants(source, &file.time);
    let listing = ChosenListing::read(source, &mut file);
    let (listing, instants) = Failure::both(listing, instants)?;
    Ok(Loaded {
        source,
        file,
        listing,
        instants,
    })
}

impl Loaded<'_> {
    /// The file with the drives of another text, which differs from its own in nothing else: the listing is not read again.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with a place if the text is no motion file.
    pub fn with_drives_of<'b>(&self, source: &'b Source) -> Result<Loaded<'b>, Failure> {
        let drives = MotionFile::parse(source)?.drives;
        let same = self.clone();
        Ok(Loaded {
            source,
            file: MotionFile {
                drives,
                ..same.file
            },
            listing: same.listing,
            instants: same.instants,
        })
    }

    /// The linkage's name.
    pub fn linkage(&self) -> &str {
        &self.listing.name
    }

    /// The name in the catalogue, if the listing is in it.
    pub fn catalogue_name(&self) -> Option<&str> {
        let name = self.file.linkage.as_ref();
        name.map(|name| name.get_ref().as_str())
    }

    /// The unit of its lengths.
    pub fn unit(&self) -> Unit {
        self.file.unit()
    }

    /// The axes of its coordinates.
    pub fn axes(&self) -> Axes {
        self.file.axes
    }

    /// The position of a point that the file states, or otherwise its listing.
    pub fn stated_position(&self, point: &str) -> Option<&Position> {
        self.file.points.get_ref().get(point).map(Spanned::get_ref)
    }

    /// The listing.
    pub fn listing(&self) -> &Listing {
        &self.listing.listing
    }

    /// The instants.
    pub fn instants(&self) -> &Instants {
        &self.instants
    }

    /// Brings the mechanism of the same linkage, compiled in, to the first instant.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] with a place if the file is wrong, [`Failure::Solver`] if the mechanism does not assemble
    /// or does not reach the first instant.
    pub fn mechanism<L, const N: usize>(&self) -> Result<Mechanism<L, N>, Failure>
    where
        L: Suspension<N, Listing: Default>,
    {
        prepare(
            self.request(Start::FirstInstant),
            self.linkage(),
            L::Listing::default(),
        )
    }

    /// The mechanism at the first instant. It has [`notes`](Description::notes) on the file.
    ///
    /// # Errors
    ///
    /// As [`mechanism`](Self::mechanism).
    pub fn at_first_instant(&self) -> Result<Box<dyn Kinematics + '_>, Failure> {
        self.listing.kinematics(self.request(Start::FirstInstant))
    }

    /// As [`at_first_instant`](Self::at_first_instant), for a command that also has an answer if the first instant is
    /// out of reach: the mechanism then stays at its design position, and a note says so.
    ///
    /// # Errors
    ///
    /// As [`at_first_instant`](Self::at_first_instant), except for the way there.
    pub fn within_reach(&self) -> Result<Box<dyn Kinematics + '_>, Failure> {
        self.listing.kinematics(self.request(Start::WithinReach))
    }

    /// As [`within_reach`](Self::within_reach), for a command that works from the design position, whatever the
    /// file's motion.
    ///
    /// # Errors
    ///
    /// As [`within_reach`](Self::within_reach).
    pub fn at_design(&self) -> Result<Box<dyn Kinematics + '_>, Failure> {
        self.listing.kinematics(self.request(Start::Design))
    }

    /// Checks that drives lead the motion, which a command requires.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] if a measure stands in for a drive.
    pub fn check_driven(&self, command: &str, mechanism: &Description) -> Result<(), Failure> {
        let Some(measure) = mechanism.led_by else {
            return Ok(());
        };
        let table = &self.file.drives;
        let measure = &mechanism.names.measures[measure].name;
        let mut stated = table.get_ref().names();
        let stated = stated.find(|name| name.get_ref() == measure);
        let place = stated.map_or_else(|| table.span(), Spanned::span);
        let message = format!(
            "`{measure}` is a measure that prescribes the motion; {command} needs a motion that is prescribed by drives alone"
        );
        Err(self.source.refuse(&place, message))
    }

    pub(super) fn request(&self, to: Start) -> Request<'_> {
        Request {
            source: self.source,
            file: &self.file,
            listing: Some(self.listing()),
            instants: &self.instants,
            to,
        }
    }
}

//! Which listing a motion file is about: one of the catalogue, one in a file beside it, or one that it states.

use std::ops::Range;
use std::path::Path;

use nalgebra::Vector3;
use suspension_core::linkages::{LISTINGS, attia2003, five_link};
use suspension_core::{Kind, Part, Parts};
use suspension_runtime::{Fitted, Listing, Mistakes, Model, Room, Size};
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{MotionFile, Position, Source};
use crate::load::prepare::prepare;
use crate::mechanism::{Instants, Mechanism, Suspension, Unit, Work};

/// The listing of a motion file.
#[derive(Clone, Debug)]
pub(super) struct Chosen {
    /// What it is called in results.
    pub(super) name: String,
    /// As it is walked at run time; none where it is compiled in.
    read: Option<Listing>,
}

/// The listings of the catalogue that are compiled in: the published mechanism, whose motion is timed.
macro_rules! compiled {
    ($($linkage:ident),+) => {
        const COMPILED: &[&str] = &[$(stringify!($linkage)),+];

        fn run_compiled<W: Work>(
            source: &Source,
            file: &MotionFile,
            instants: &Instants,
            name: &str,
            work: W,
        ) -> Result<W::Answer, Failure> {
            match name {
                $(stringify!($linkage) => {
                    work.on(&compiled::<$linkage::Model<f64>, _>(source, file, instants, name)?)
                })+
                _ => Err(Failure::Input(format!("{}: no listing", source.name()))),
            }
        }
    };
}
compiled!(attia2003, five_link);

/// The mechanism of a file, of a listing that is compiled in.
pub(super) fn compiled<L, const N: usize>(
    source: &Source,
    file: &MotionFile,
    instants: &Instants,
    name: &str,
) -> Result<Mechanism<L, N>, Failure>
where
    L: Suspension<N, Listing: Default>,
{
    prepare(source, file, instants, name, L::Listing::default())
}

impl Chosen {
    /// A linkage of one's own, compiled in, under the name that the file must give.
    pub(super) fn own(source: &Source, file: &MotionFile, known: &str) -> Result<Self, Failure> {
        match &file.linkage {
            Some(name) if name.get_ref() == known => Ok(Self {
                name: known.to_owned(),
                read: None,
            }),
            Some(name) => Err(unknown(source, name, known)),
            None => {
                let message = format!("`linkage = \"{known}\"` is missing");
                Err(source.refuse(&(0..0), message))
            }
        }
    }

    /// What the file names, or states. Points that the listing states and the file does not are taken over.
    pub(super) fn of(source: &Source, file: &mut MotionFile) -> Result<Self, Failure> {
        let stated = [&file.linkage, &file.listing, &file.statements];
        let places: Vec<_> = stated.into_iter().flatten().map(Spanned::span).collect();
        let [place] = places.as_slice() else {
            let place = places.get(1).cloned().unwrap_or(0..0);
            let message = "one of these says which suspension it is: `linkage` (a name of the catalogue), \
                           `listing` (a file of statements) or `statements`";
            return Err(source.refuse(&place, message));
        };
        let (name, listing) = match (&file.linkage, &file.listing, &file.statements) {
            (Some(name), ..) => (name.get_ref().clone(), of_catalogue(source, file, name)?),
            (None, Some(path), _) => of_file(source, path)?,
            (None, None, Some(text)) => ("statements".to_owned(), Some(of_text(source, text)?)),
            (None, None, None) => return Err(source.refuse(place, "no listing")),
        };
        let read = listing.map(|listing| with_points(listing, file, place));
        Ok(Self { name, read })
    }

    /// The listing itself.
    pub(super) fn listing(&self, source: &Source) -> Result<Listing, Failure> {
        if let Some(listing) = &self.read {
            return Ok(listing.clone());
        }
        let mut known = LISTINGS.iter();
        let Some((name, text)) = known.find(|(name, _)| *name == self.name) else {
            let message = format!(
                "{}: the statements of `{}` are compiled in",
                source.name(),
                self.name
            );
            return Err(Failure::Input(message));
        };
        Listing::parse_file(text, name).map_err(refused)
    }

    /// Does the work on the mechanism.
    pub(super) fn run<W: Work>(
        &self,
        source: &Source,
        file: &MotionFile,
        instants: &Instants,
        work: W,
    ) -> Result<W::Answer, Failure> {
        let name = &self.name;
        match &self.read {
            None => run_compiled(source, file, instants, name, work),
            Some(listing) => listing.in_its_size(Walked {
                source,
                file,
                instants,
                name,
                work,
            }),
        }
    }
}

/// Work on the mechanism of a listing that is walked.
struct Walked<'a, W> {
    source: &'a Source,
    file: &'a MotionFile,
    instants: &'a Instants,
    name: &'a str,
    work: W,
}

impl<W: Work> suspension_runtime::Work for Walked<'_, W> {
    type Answer = Result<W::Answer, Failure>;

    fn on<const N: usize>(self, listing: Fitted<'_, N>) -> Self::Answer
    where
        Room<N>: Size,
    {
        let Self {
            source,
            file,
            instants,
            name,
            work,
        } = self;
        let mechanism: Mechanism<Model<'_, f64, N>, N> =
            prepare(source, file, instants, name, listing)?;
        work.on(&mechanism)
    }
}

/// A name of the catalogue; none for a listing that is compiled in.
fn of_catalogue(
    source: &Source,
    file: &MotionFile,
    name: &Spanned<String>,
) -> Result<Option<Listing>, Failure> {
    let wanted = name.get_ref().as_str();
    let Some((_, text)) = LISTINGS.iter().find(|(known, _)| *known == wanted) else {
        let known: Vec<&str> = LISTINGS.iter().map(|(known, _)| *known).collect();
        let known = known.join(", ");
        let others = format!("{known}; `listing` names a file of your own statements");
        return Err(unknown(source, name, &others));
    };
    if COMPILED.contains(&wanted) {
        return Ok(None);
    }
    let listing = Listing::parse_file(text, wanted).map_err(refused)?;
    let stated = file.points.get_ref();
    let all_are_stated = points(&listing).all(|point| stated.contains_key(point));
    if file.unit != Unit::Metre && !all_are_stated {
        let message = format!(
            "the catalogue has the hardpoints of `{wanted}` in metres; state all points, or unit = \"m\""
        );
        return Err(source.refuse(&name.span(), message));
    }
    Ok(Some(listing))
}

/// The file names none of the known linkages.
fn unknown(source: &Source, name: &Spanned<String>, known: &str) -> Failure {
    let message = format!("unknown linkage `{}`; known are {known}", name.get_ref());
    source.refuse(&name.span(), message)
}

/// The statements of a file beside the motion file, under the file's stem.
fn of_file(source: &Source, path: &Spanned<String>) -> Result<(String, Option<Listing>), Failure> {
    let folder = Path::new(source.name()).parent().unwrap_or(Path::new(""));
    let path = folder.join(path.get_ref());
    let text = Source::read(&path)?;
    let listing = Listing::parse_file(text.text(), text.name()).map_err(refused)?;
    let name = path
        .file_stem()
        .map_or("listing".into(), |stem| stem.to_string_lossy());
    Ok((name.into_owned(), Some(listing)))
}

/// The statements in the motion file itself; mistakes have its lines.
fn of_text(source: &Source, text: &Spanned<String>) -> Result<Listing, Failure> {
    Listing::parse_file(text.get_ref(), source.name()).map_err(|mut mistakes| {
        let before = source.text().get(..text.span().start).unwrap_or_default();
        let quoted = source.text().get(text.span()).unwrap_or_default();
        // A line break right behind the quotes is not of the text.
        let is_below = quoted
            .trim_start_matches(['\'', '"'])
            .starts_with(['\n', '\r']);
        let lines = before.matches('\n').count() + usize::from(is_below);
        for mistake in &mut mistakes.mistakes {
            mistake.line += lines;
        }
        refused(mistakes)
    })
}

/// All mistakes, one a line.
fn refused(mistakes: Mistakes) -> Failure {
    Failure::Input(mistakes.to_string())
}

/// The points' names, in the order of the listing.
fn points(listing: &Listing) -> impl Iterator<Item = &str> {
    let kinds = [Kind::ChassisPoint, Kind::FreePoint, Kind::Marker];
    let count: usize = kinds.into_iter().map(|kind| listing.count(kind)).sum();
    (0..count).map(|point| listing.name(Part::Point(point)))
}

/// Adds to the file the points that the listing alone states, and orders the elimination by the file's where
/// the listing states none.
fn with_points(listing: Listing, file: &mut MotionFile, place: &Range<usize>) -> Listing {
    let stated = file.points.get_mut();
    for (point, at) in listing.stated() {
        let name = listing.name(Part::Point(point));
        if !stated.contains_key(name) {
            let key = Spanned::new(place.clone(), name.to_owned());
            stated.insert(key, Spanned::new(place.clone(), Position::At(at.into())));
        }
    }
    let at = |name| match stated.get(name).map(Spanned::get_ref) {
        Some(Position::At(at)) => Vector3::from(*at),
        _ => Vector3::repeat(f64::NAN),
    };
    let hardpoints: Vec<Vector3<f64>> = points(&listing).map(at).collect();
    listing.ordered_at(&hardpoints)
}

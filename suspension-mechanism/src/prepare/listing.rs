//! The listing of a motion file: one of the catalogue, one in a file beside it, or one that it states.

mod flat_listing;
mod included;
pub(super) mod points;

use std::ops::Range;
use std::path::Path;

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_runtime::{Fitted, Listing, Mistakes, Model, Room, Size, catalogue};
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{MotionFile, Position, Source, check};
use crate::kinematics::{Kinematics, design_derivatives};
use crate::mechanism::{Axes, Length, Mechanism};
use crate::prepare::listing::points::{point_names, stated_at};
use crate::prepare::mechanism::prepare;
use crate::prepare::notes::listed_points;
use crate::prepare::task::Request;

/// The listing of a motion file.
#[derive(Clone, Debug)]
pub(super) struct ChosenListing {
    /// Its name in results.
    pub(super) name: String,
    /// Its statements.
    pub(super) listing: Listing,
    /// The text of its statements, under the name of its file or of its layout.
    pub(super) text: Source,
    /// Remarks on points that the file does not state.
    notes: Vec<String>,
}

impl ChosenListing {
    /// The listing that the file names or states. Points that the listing states and the file does not are taken
    /// over.
    pub(super) fn read(source: &Source, file: &mut MotionFile) -> Result<Self, Failure> {
        let stated = [&file.linkage, &file.listing, &file.statements];
        let places: Vec<_> = stated.into_iter().flatten().map(Spanned::span).collect();
        let (name, (listing, text)) = match (&file.linkage, &file.listing, &file.statements) {
            (Some(name), None, None) => (
                name.get_ref().clone(),
                find_in_catalogue(source, file, name)?,
            ),
            (None, Some(path), None) => read_listing_file(source, file, path)?,
            (None, None, Some(text)) => (
                stem(Path::new(source.name())),
                parse_statements(source, file, text)?,
            ),
            _ => {
                let place = places.get(1).cloned().unwrap_or_default();
                let message = "one of these says which suspension it is: `linkage` (a name of the catalogue), \
                               `listing` (a file of statements) or `statements`";
                return Err(source.refuse(&place, message));
            }
        };
        let axes = match file.linkage {
            Some(_) => file.axes,
            None => Axes::Iso,
        };
        let notes = listed_points::notes((&listing, &name), source, file, axes);
        let listing = add_listed_points(source, listing, file, &places[0], axes);
        Ok(Self {
            notes,
            name,
            listing,
            text,
        })
    }

    /// The mechanism, in one of two sizes. A third size of 60 unknowns would walk listings of 16 to 60 a sixth faster,
    /// and take a fifth of the build time of this crate.
    pub(super) fn kinematics(
        &self,
        request: Request<'_>,
    ) -> Result<Box<dyn Kinematics + '_>, Failure> {
        match (self.listing.fitted::<15>(), self.listing.fitted::<120>()) {
            (Some(listing), _) => self.prepared(request, listing),
            (None, Some(listing)) => self.prepared(request, listing),
            (None, None) => Err(Failure::Input(format!("`{}` is too large", self.name))),
        }
    }

    fn prepared<'c, const N: usize>(
        &'c self,
        request: Request<'_>,
        listing: Fitted<'c, N>,
    ) -> Result<Box<dyn Kinematics + 'c>, Failure>
    where
        Room<N>: Size,
    {
        let mut mechanism: Mechanism<Model<'c, f64, N>, N> = prepare(request, &self.name, listing)?;
        mechanism.description.notes.extend(self.notes.clone());
        mechanism.design_derivatives = Some(design_derivatives);
        Ok(Box::new(mechanism))
    }
}

/// A name of the catalogue.
fn find_in_catalogue(
    source: &Source,
    file: &MotionFile,
    name: &Spanned<String>,
) -> Result<(Listing, Source), Failure> {
    let wanted = name.get_ref().as_str();
    let Some(text) = catalogue::listing(wanted) else {
        let own = "; `listing` names a file of your own statements";
        let message = catalogue::unknown(wanted, own);
        return Err(source.refuse(&name.span(), message));
    };
    let text = Source::new(wanted, text);
    let listing = Listing::parse_file(text.text(), wanted);
    let listing = listing.map_err(|mistakes| refused(&text, &mistakes))?;
    let all: Vec<&str> = point_names(&listing).collect();
    let stated = file.points.get_ref();
    let missing: Vec<_> = all
        .iter()
        .filter(|point| !stated.has(point))
        .map(|point| format!("`{point}`"))
        .collect();
    if file.length != Length::Metre && !missing.is_empty() {
        check::known_points(source, file, &all)?;
        let missing = missing.join(", ");
        let message = format!(
            "[points] does not state {missing}: `{wanted}` of the catalogue has its hardpoints in metres; state all in {}",
            file.length.in_words()
        );
        return Err(source.refuse(&name.span(), message));
    }
    Ok((listing, text))
}

/// The statements of a file beside the motion file, under the file's stem.
fn read_listing_file(
    source: &Source,
    file: &MotionFile,
    path: &Spanned<String>,
) -> Result<(String, (Listing, Source)), Failure> {
    let place = path.span();
    if path.get_ref().is_empty() {
        let message = "`listing` names no file; write the path of a file of statements, as listing = \"corner.linkage\"";
        return Err(source.refuse(&place, message));
    }
    let text = source.read_beside(path).map_err(|unread| {
        let name = path.get_ref();
        let message = format!(
            "there is no file `{name}`; for the layout of the catalogue write linkage = \"{name}\""
        );
        let of_catalogue = catalogue::listing(name);
        of_catalogue.map_or(unread, |_| source.refuse(&place, message))
    })?;
    let parsed = included::parsed(text.text(), text.name());
    let parsed = parsed.map_err(|mistakes| refused(&text, &mistakes))?;
    included::check_unit(source, file, place, &parsed)?;
    let (listing, _) = parsed;
    check_places(&text, &listing, file)?;
    Ok((stem(Path::new(path.get_ref())), (listing, text)))
}

/// The name of a listing in a file, or in a motion file.
fn stem(file: &Path) -> String {
    let stem = file.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

/// Refuses two points in one place if the motion file states neither, because the mistake is then in the listing. A
/// direction from which an angle counts is an exception.
fn check_places(text: &Source, listing: &Listing, file: &MotionFile) -> Result<(), Failure> {
    let [chassis, free] = [Kind::ChassisPoint, Kind::FreePoint].map(|kind| listing.count(kind));
    let points = file.points.get_ref();
    let unjoined = listing.unjoined_points();
    let own = listing.stated().filter_map(|(point, at)| {
        let name = listing.name(Part::Point(point));
        let is_held = point < chassis + free && !unjoined.contains(&name);
        (is_held && !points.has(name)).then_some((name, at))
    });
    let own: Vec<(&str, Vector3<f64>)> = own.collect();
    for (index, (name, at)) in own.iter().enumerate() {
        if let Some((other, _)) = own[..index].iter().find(|(_, place)| place == at) {
            let place = statement_of(text.text(), name).unwrap_or_default();
            return Err(text.refuse(&place, check::in_one_place(name, other)));
        }
    }
    Ok(())
}

/// The place where a listing states a point: the name followed by `at`.
fn statement_of(text: &str, name: &str) -> Option<Range<usize>> {
    let mut places = text.match_indices(name).filter(|(place, _)| {
        let before = text[..*place].chars().next_back();
        let behind = &text[place + name.len()..];
        let stated =
            behind.trim_start().starts_with("at ") && behind.starts_with(char::is_whitespace);
        stated && !before.is_some_and(|c| c.is_alphanumeric() || c == '_')
    });
    places.next().map(|(place, _)| place..place + name.len())
}

/// The statements in the motion file itself; mistakes have its lines.
fn parse_statements(
    source: &Source,
    file: &MotionFile,
    text: &Spanned<String>,
) -> Result<(Listing, Source), Failure> {
    let parsed = included::parsed(text.get_ref(), source.name()).map_err(|mut mistakes| {
        let before = source.text().get(..text.span().start).unwrap_or_default();
        let quoted = source.text().get(text.span()).unwrap_or_default();
        // A line break directly after the quotes does not belong to the text.
        let is_below = quoted
            .trim_start_matches(['\'', '"'])
            .starts_with(['\n', '\r']);
        let lines = before.matches('\n').count() + usize::from(is_below);
        for mistake in &mut mistakes.mistakes {
            mistake.line += lines;
        }
        refused(source, &mistakes)
    })?;
    included::check_unit(source, file, text.span(), &parsed)?;
    let (listing, _) = parsed;
    Ok((listing, Source::new(source.name(), text.get_ref())))
}

/// All mistakes in a text.
pub(super) fn refused(source: &Source, mistakes: &Mistakes) -> Failure {
    source.refuse_all(&mistakes.mistakes, |mistake| {
        let place = source.span(mistake.line, mistake.column, mistake.length);
        (place, mistake.message.clone())
    })
}

/// Adds to the file the points that only the listing states (those of the catalogue turned to the file's axes), and
/// orders the elimination by the file's points if the listing states none. The file names the listing, or contains
/// it, at `place`.
fn add_listed_points(
    source: &Source,
    listing: Listing,
    file: &mut MotionFile,
    place: &Range<usize>,
    axes: Axes,
) -> Listing {
    let stated = file.points.get_mut();
    let written = source.text().get(place.clone()).unwrap_or_default();
    for (point, at) in listing.stated() {
        let name = listing.name(Part::Point(point));
        let at = axes.turned(at);
        if !stated.has(name) {
            let within = statement_of(written, name);
            let place = within.map_or_else(
                || place.clone(),
                |within| place.start + within.start..place.start + within.end,
            );
            let key = Spanned::new(place.clone(), name.to_owned());
            stated.add(key, Spanned::new(place, Position::At(at.into())));
        }
    }
    let hardpoints = point_names(&listing).map(|name| stated_at(&file.points, name));
    let hardpoints: Vec<Vector3<f64>> = hardpoints.collect();
    listing.ordered_at(&hardpoints)
}

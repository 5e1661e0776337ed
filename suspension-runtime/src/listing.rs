//! A listing read from text.

use nalgebra::Vector3;
use suspension_core::listing::{DriveKind, Kind, MeasureKind, Part, Parts, WheelPlaces};
use suspension_listing::eliminate::EliminationOrder;
use suspension_listing::form::Form;
use suspension_listing::include::IncludeSource;
use suspension_listing::name::Name;
use suspension_listing::system::{Equation, Quantity, Site, System};
use suspension_listing::text::{self, Mistake, Mistakes};

use crate::catalogue_and_files::CatalogueAndFiles;
use crate::names::Names;
use crate::plan::{Plan, Wheel};
use crate::size::LARGEST;

/// A listing: parsed, checked, and ready to be made into models.
#[derive(Clone, Debug)]
pub struct Listing {
    system: System,
    names: Names,
    plan: Plan,
}

impl Listing {
    /// Reads a listing: its statements, as they stand inside the braces of `linkage!`.
    ///
    /// The order of elimination is chosen as `linkage!` chooses it: by the positions that the listing states with
    /// `at`, otherwise by typical suspension designs; see [`ordered_at`](Self::ordered_at).
    ///
    /// # Errors
    ///
    /// All mistakes, including those of size: see [`Size`](crate::Size) for the room in models of 120 unknowns.
    pub fn parse(text: &str) -> Result<Self, Mistakes> {
        Self::parse_with(text, "listing", &CatalogueAndFiles::default())
    }

    /// As [`parse`](Self::parse), for a text from a file. The mistakes name the file, and the files that it includes
    /// are in its folder.
    ///
    /// # Errors
    ///
    /// As [`parse`](Self::parse).
    pub fn parse_file(text: &str, file: &str) -> Result<Self, Mistakes> {
        Self::parse_with(text, file, &CatalogueAndFiles::beside(file))
    }

    /// As [`parse`](Self::parse), for a listing whose included listings come from `includes`.
    ///
    /// # Errors
    ///
    /// As [`parse`](Self::parse).
    pub fn parse_with(
        text: &str,
        file: &str,
        includes: &dyn IncludeSource,
    ) -> Result<Self, Mistakes> {
        let system = text::parse(text, file, includes)?;
        let refuse = |message: String| Mistakes {
            file: file.to_owned(),
            mistakes: vec![Mistake {
                message,
                line: 1,
                column: 1,
                length: 0,
            }],
        };
        let order = suspension_listing::order(&system);
        let listing = Self {
            names: Names::new(&system),
            plan: Plan::new(&system, &order),
            system,
        };
        let Some(exceeded) = listing.plan.exceeded::<LARGEST>() else {
            return Ok(listing);
        };
        let (count, most, what) = (exceeded.count, exceeded.most, exceeded.what);
        Err(refuse(text::too_many(count, most, what, "")))
    }

    /// The listing with another order of elimination; unchanged if that is too large.
    pub(crate) fn with_order(self, order: &EliminationOrder) -> Self {
        let plan = Plan::new(&self.system, order);
        match plan.exceeded::<LARGEST>() {
            Some(_) => self,
            None => Self { plan, ..self },
        }
    }

    pub(crate) fn system(&self) -> &System {
        &self.system
    }

    pub(crate) fn plan(&self) -> &Plan {
        &self.plan
    }

    /// The number of unknowns.
    pub fn size(&self) -> usize {
        self.system.size()
    }

    /// The design position, if the listing states that of every point.
    pub fn design(&self) -> Option<Vec<Vector3<f64>>> {
        self.positions().collect()
    }

    /// The design positions that the listing states, of chassis points, free points and markers in order.
    pub fn stated(&self) -> impl Iterator<Item = (usize, Vector3<f64>)> {
        let stated = self.positions().enumerate();
        stated.filter_map(|(place, at)| Some((place, at?)))
    }

    fn positions(&self) -> impl Iterator<Item = Option<Vector3<f64>>> {
        let points = self.system.fixed.iter().chain(&self.system.free);
        let markers = self.system.markers.iter().map(|marker| marker.at);
        let stated = points.map(|point| point.at).chain(markers);
        stated.map(|at| at.map(Vector3::from))
    }

    /// The measures, each with the text of its `///` lines, which may be empty.
    pub fn described_measures(&self) -> impl Iterator<Item = (&str, String)> {
        let measures = self.system.measures.iter();
        measures.map(|measure| {
            let lines = measure.named.docs.iter().map(|line| line.trim());
            let text: Vec<&str> = lines.collect();
            (measure.named.name.as_str(), text.join(" "))
        })
    }

    /// The links: the two points of each, by their indices.
    pub fn links(&self) -> Vec<[usize; 2]> {
        let of_links = |equation: &&Equation| equation.origin.operand.is_none();
        let links = self.system.equations.iter().filter(of_links);
        let ends = links.filter_map(|equation| equation.form.equations().keeps());
        ends.map(|ends| ends.map(|site| self.place_of(site)))
            .collect()
    }

    /// The bodies of three points or more: their points, by their indices.
    pub fn bodies(&self) -> Vec<Vec<usize>> {
        let bodies = self.system.bodies.iter();
        let points = bodies.map(|body| body.points().map(|site| self.place_of(site)).collect());
        points.collect()
    }

    /// The slides: the two ends of each line and the point on it, by their indices.
    pub fn slides(&self) -> Vec<[usize; 3]> {
        let forms = self.system.equations.iter().map(|equation| &equation.form);
        let slides = forms.filter_map(|form| match form {
            Form::Along(along) => match along.ends.as_slice() {
                [to] => Some([&along.from, to, &along.point]),
                _ => None,
            },
            _ => None,
        });
        slides
            .map(|points| points.map(|site| self.place_of(site)))
            .collect()
    }

    /// The two points of a length that is driven, by name.
    pub fn driven_length(&self, drive: usize) -> Option<[&str; 2]> {
        match &self.system.drives.get(drive)?.quantity {
            Quantity::Length { line } => Some(line.each_ref().map(|point| point.as_str())),
            _ => None,
        }
    }

    /// The two points of each length that is driven or measured, by their indices.
    pub fn driven_and_measured_lengths(&self) -> Vec<[usize; 2]> {
        let drives = self.system.drives.iter().map(|drive| &drive.quantity);
        let measures = self.system.measures.iter().map(|measure| &measure.quantity);
        let lines = drives
            .chain(measures)
            .filter_map(|quantity| match quantity {
                Quantity::Length { line } => Some(line),
                _ => None,
            });
        self.places_of_lines(lines)
    }

    /// The lines of angles that are measured about a line, as those of a bar and its arms: that line, and the measured lines
    /// that start or end on one of its two points, each by the indices of its points. An angle without such an arm has none.
    pub fn measured_turns(&self) -> Vec<[usize; 2]> {
        let measures = self.system.measures.iter();
        let lines = measures.flat_map(|measure| match &measure.quantity {
            Quantity::Between {
                lines,
                about: Some(axis),
            } => {
                let is_arm = |line: &&[Name; 2]| line.iter().any(|end| axis.contains(end));
                let arms = lines.iter().filter(is_arm);
                let axis = arms.clone().next().map(|_| axis);
                axis.into_iter().chain(arms).collect()
            }
            _ => Vec::new(),
        });
        self.places_of_lines(lines)
    }

    /// The two lines of an angle that is measured between them, not about a third one: the points of each, by their indices.
    pub fn measured_between(&self, measure: usize) -> Option<[[usize; 2]; 2]> {
        match &self.system.measures.get(measure)?.quantity {
            Quantity::Between { lines, about: None } => {
                self.places_of_lines(lines.iter()).try_into().ok()
            }
            _ => None,
        }
    }

    /// The indices of the two points of each line.
    fn places_of_lines<'a>(&self, lines: impl Iterator<Item = &'a [Name; 2]>) -> Vec<[usize; 2]> {
        let places = lines
            .filter_map(|[from, to]| Some([self.point(from.as_str())?, self.point(to.as_str())?]));
        places.collect()
    }

    pub(crate) fn place_of(&self, site: &Site) -> usize {
        let before = if site.is_free() {
            self.system.fixed.len()
        } else {
            0
        };
        before + site.index
    }

    /// The index of a point among all: chassis points, free points, markers.
    pub fn point(&self, name: &str) -> Option<usize> {
        place(&self.names.points, name)
    }

    /// The index of a drive.
    pub fn drive(&self, name: &str) -> Option<usize> {
        place(&self.names.drives, name)
    }

    /// The index of a measure.
    pub fn measure(&self, name: &str) -> Option<usize> {
        place(&self.names.measures, name)
    }

    /// The index of a length.
    pub fn length(&self, name: &str) -> Option<usize> {
        place(&self.names.lengths, name)
    }
}

fn place(names: &[String], name: &str) -> Option<usize> {
    names.iter().position(|other| other == name)
}

impl Parts for Listing {
    fn name(&self, part: Part) -> &str {
        self.names.name(part)
    }

    fn count(&self, kind: Kind) -> usize {
        match kind {
            Kind::Unknown => self.system.size(),
            Kind::ChassisPoint => self.system.fixed.len(),
            Kind::FreePoint => self.system.free.len(),
            Kind::Marker => self.system.markers.len(),
            Kind::Drive => self.plan.drives.len(),
            Kind::Measure => self.plan.measures.len(),
            Kind::Length => self.plan.lengths.len(),
        }
    }

    fn drive_kind(&self, drive: usize) -> DriveKind {
        let drive = self.plan.drives.get(drive);
        drive.map_or(DriveKind::Coordinate, |drive| drive.quantity.drive_kind())
    }

    fn measure_kind(&self, measure: usize) -> MeasureKind {
        let quantity = self.plan.measures.get(measure);
        quantity.map_or(MeasureKind::Length, |quantity| quantity.measure_kind())
    }

    fn wheel(&self, wheel: usize) -> Option<WheelPlaces<'_>> {
        self.plan.wheels.get(wheel).map(Wheel::places)
    }
}

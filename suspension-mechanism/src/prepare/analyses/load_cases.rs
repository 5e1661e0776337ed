//! The load cases of a motion file.

mod acting_springs;
mod drive_loads;

use nalgebra::Vector3;
use suspension_listing::did_you_mean::did_you_mean;
use suspension_runtime::Listing;
use toml::Spanned;

use crate::failure::Failure;
use crate::file::{Load, LoadCase, Source, Wrench};
use crate::loads::{Case, Site, contact_of};
use crate::mechanism::Description;
use crate::prepare::loaded::Loaded;

/// The load that acts on all masses.
const GRAVITY: &str = "gravity";
const ACCELERATION: &str = "acceleration";
/// The springs that act by their rates.
const ACTING: &str = "acting";

impl Loaded<'_> {
    /// The load cases of the file, in its order.
    ///
    /// # Errors
    ///
    /// [`Failure::Input`] at the first name that is not a place of the mechanism, at a number that is not finite, and
    /// where a load cannot act.
    pub fn load_cases(&self, mechanism: &Description) -> Result<Vec<Case>, Failure> {
        let Some(table) = &self.file.loads else {
            return Ok(Vec::new());
        };
        let reader = Reader {
            source: self.source,
            listing: self.listing(),
            mechanism,
            has_masses: self.file.masses.is_some(),
        };
        let cases = table.get_ref().iter();
        Failure::all(cases.map(|(name, loads)| reader.case(name, loads.get_ref())))
    }
}

struct Reader<'a> {
    source: &'a Source,
    listing: &'a Listing,
    mechanism: &'a Description,
    has_masses: bool,
}

impl Reader<'_> {
    fn case(&self, name: &Spanned<String>, loads: &LoadCase) -> Result<Case, Failure> {
        let ends_names = |c: char| c.is_control() || ['/', '\\', ':'].contains(&c);
        if name.get_ref().contains(ends_names) {
            let message = "the name of a load case becomes part of file and column names; leave out `/`, `\\` and `:`";
            return Err(self.source.refuse(&name.span(), message));
        }
        let mut case = Case {
            name: name.get_ref().clone(),
            at: Vec::new(),
            along: Vec::new(),
            acting: Vec::new(),
            field: self.weight(),
            borne_by: Vec::new(),
        };
        let is_load = |(name, _): &(&Spanned<String>, _)| name.get_ref() != ACTING;
        let each = loads.0.iter().filter(is_load);
        Failure::all(each.map(|(place, load)| self.add(&mut case, place, load)))?;
        case.acting = self.acting(&case, loads)?;
        Ok(case)
    }

    fn add(
        &self,
        case: &mut Case,
        place: &Spanned<String>,
        load: &Spanned<Load>,
    ) -> Result<(), Failure> {
        let name = place.get_ref().as_str();
        let refuse = |message: String| Err(self.source.refuse(&load.span(), message));
        if let Some(field) = self.field(name, load)? {
            case.field += field;
            return Ok(());
        }
        let mut numbers = load.get_ref().numbers().into_iter();
        if numbers.any(|number| !is_computable(number)) {
            return refuse(format!(
                "load `{name}` is not finite, or too large to compute with: write forces in N and moments in N m"
            ));
        }
        let drive = self.mechanism.names.drive(name);
        match (load.get_ref(), self.measure(name)) {
            (Load::By(by), _) => match self.borne_by(case, name, by) {
                Ok(borne_by) => case.borne_by.push(borne_by),
                Err(message) => return refuse(message),
            },
            (Load::Along(along), Some(measure)) => case.along.push((measure, *along)),
            (Load::BySeveral(by), None) if drive.is_some() => {
                return refuse(self.one_bears(&case.name, name, by));
            }
            (Load::At(_) | Load::BySeveral(_), Some(_)) => {
                return refuse(format!(
                    "`{name}` is {}: write one number, positive where it makes the measure larger",
                    self.kind_of_measure(name)
                ));
            }
            (_, None) if drive.is_some() => return refuse(self.no_load_of_drive(name)),
            (Load::Along(_) | Load::BySeveral(_), None) => {
                self.site(place, false)?;
                return refuse(format!("`{name}` is a place: write a force [x, y, z] in N"));
            }
            (Load::At(Wrench { force, moment }), None) => {
                let site = self.site(place, *moment != [0.0; 3])?;
                let load = [Vector3::from(*force), Vector3::from(*moment)];
                case.at.push((site, load));
            }
        }
        Ok(())
    }

    /// The contribution of a field that the case states, m/s^2: gravity instead of the usual one, and the
    /// acceleration of the chassis.
    fn field(&self, name: &str, load: &Spanned<Load>) -> Result<Option<Vector3<f64>>, Failure> {
        if ![GRAVITY, ACCELERATION].contains(&name) {
            return Ok(None);
        }
        if !self.has_masses {
            let message = format!("`{name}` acts on masses: state them in [masses]");
            return Err(self.source.refuse(&load.span(), message));
        }
        match load.get_ref() {
            Load::At(Wrench { force, moment })
                if *moment == [0.0; 3] && force.iter().all(|x| is_computable(*x)) =>
            {
                let field = Vector3::from(*force);
                Ok(Some(if name == GRAVITY {
                    field - self.weight()
                } else {
                    -field
                }))
            }
            _ => {
                let message = format!("`{name}` is [x, y, z] in m/s^2, in the file's axes");
                Err(self.source.refuse(&load.span(), message))
            }
        }
    }

    /// Standard gravity.
    fn weight(&self) -> Vector3<f64> {
        const STANDARD: f64 = 9.806_65;
        let down = self.mechanism.axes.turned(-Vector3::z());
        down * STANDARD
    }

    /// The place of a name; `turned` if a moment acts there.
    fn site(&self, place: &Spanned<String>, turned: bool) -> Result<Site, Failure> {
        let name = place.get_ref().as_str();
        let refuse = |message: String| Err(self.source.refuse(&place.span(), message));
        let names = &self.mechanism.names;
        let Some(point) = names.point(name) else {
            return self.contact(place);
        };
        let mut carriers = self.listing.rigid_carriers().into_iter();
        if let Some((_, body)) = carriers.find(|(marker, _)| *marker == point) {
            return Ok(Site::Body(point, body));
        }
        if point < names.chassis && (turned || !self.listing.driven_points().contains(&point)) {
            return refuse(format!(
                "`{name}` is a chassis point: a load there acts on no part of the suspension"
            ));
        }
        if !turned {
            return Ok(Site::Point(point));
        }
        let bodies = self.listing.bodies().into_iter();
        let having = bodies.filter(|body| body.contains(&point));
        let held: Vec<Option<[usize; 3]>> =
            having.map(|body| body.first_chunk().copied()).collect();
        match *held {
            [Some(body)] => Ok(Site::Body(point, body)),
            [] | [None] => refuse(format!("`{name}` is in no body that could take a moment")),
            _ => refuse(format!(
                "several bodies join at `{name}`: state the moment at a point of one of them alone"
            )),
        }
    }

    /// `contact`, or `left_contact` for a named wheel.
    fn contact(&self, place: &Spanned<String>) -> Result<Site, Failure> {
        let names = &self.mechanism.names;
        let contacts: Vec<String> = names.wheels.iter().map(contact_of).collect();
        let name = place.get_ref();
        let Some(wheel) = contacts.iter().position(|contact| contact == name) else {
            let known = contacts.iter().chain(&names.points[names.chassis..]);
            let known: Vec<&str> = known
                .map(String::as_str)
                .chain(names.measure_names())
                .collect();
            let others = [GRAVITY, ACCELERATION, ACTING];
            let hint = did_you_mean(name, known.iter().copied().chain(others));
            let known = known.join(", ");
            let message = format!("unknown place `{name}`; loads act at {known}{hint}");
            return Err(self.source.refuse(&place.span(), message));
        };
        if names.wheels[wheel].radius.is_none() {
            let message = format!("`{name}` needs wheel_radius under [vehicle]");
            return Err(self.source.refuse(&place.span(), message));
        }
        Ok(Site::Contact(wheel))
    }
}

/// Whether a load is finite and so small that nothing overflows: results have products of loads, lengths and ratios.
fn is_computable(load: f64) -> bool {
    const TOO_LARGE: f64 = 1e100;
    load.abs() < TOO_LARGE
}

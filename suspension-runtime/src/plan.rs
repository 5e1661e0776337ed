//! What the solver walks: a listing as indices. Made once of a listing; nothing of it is a number of a
//! geometry.

mod elimination;
mod readout;

use syn::Ident;

use suspension_listing::ast::Named;
use suspension_listing::eliminate::Order;
use suspension_listing::system::{Equation, Site, SiteMotion, System};

use crate::site::CHASSIS;
use crate::form::{Body, Coordinate, Distance, Moving};

pub(crate) use elimination::{Elimination, Reduction, SPARE, Step, ZERO};
pub(crate) use readout::{Cluster, Drive, Measure};

/// The indices of a listing.
///
/// A site is a free point, or beyond all of those a chassis point.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) unknowns: u16,
    pub(crate) free: u16,
    pub(crate) chassis: u16,
    pub(crate) distances: Vec<Distance>,
    /// With the points that they carry. Those that carry none have no equation of their own.
    pub(crate) bodies: Vec<Body>,
    pub(crate) coordinates: Vec<Coordinate>,
    /// What moves with the drives, and what with the rest of the chassis.
    pub(crate) driven: Moving,
    pub(crate) undriven: Moving,
    pub(crate) elimination: Elimination,
    pub(crate) drives: Vec<Drive>,
    pub(crate) measures: Vec<Measure>,
    /// The sites that carry each marker.
    pub(crate) markers: Vec<[u16; 3]>,
    pub(crate) clusters: Vec<Cluster>,
}

impl Plan {
    pub(crate) fn new(system: &System, order: &Order) -> Self {
        let sites = Sites::new(system);
        let elimination = Elimination::new(system, order);
        let entry = |row, column| elimination.entry(row, column);
        let (mut distances, mut coordinates) = (Vec::new(), Vec::new());
        let mut bodies: Vec<Body> = (system.bodies.iter())
            .map(|body| Body::new(body.frame.each_ref().map(|site| sites.index(site))))
            .collect();
        let mut row = 0;
        for equation in &system.equations {
            match equation {
                Equation::Distance { from, to, .. } => {
                    let ends = [from, to].map(|site| sites.index(site));
                    distances.push(Distance::new(row, ends, entry));
                }
                Equation::Carried { body, point, .. } => {
                    let mut named = system.bodies.iter().zip(&mut bodies);
                    if let Some((_, of)) = named.find(|(known, _)| known.name == *body) {
                        let is_substituted = (system.substituted().iter())
                            .any(|other| other.point == &point.name);
                        let entry = (!is_substituted).then_some(entry);
                        of.carry(row, sites.index(point), entry);
                    }
                }
                Equation::Coordinate {
                    drive,
                    axis,
                    of,
                    minus,
                } => coordinates.push(Coordinate::new(
                    row,
                    drive_index(system, drive),
                    *axis,
                    [Some(of), minus.as_ref()].map(|site| site.map(|site| sites.index(site))),
                    entry,
                )),
            }
            row += equation.rows().len();
        }
        let moving = |motion| {
            let moves = |site: u16| sites.motion(site) == motion;
            Moving::new(&distances, &bodies, &coordinates, moves)
        };
        let [driven, undriven] = [SiteMotion::DrivenAnchor, SiteMotion::Anchor].map(moving);
        Self {
            unknowns: index(system.size()),
            free: sites.free,
            chassis: index(system.fixed.len()),
            driven,
            undriven,
            drives: readout::drives(system),
            measures: readout::measures(system),
            markers: readout::markers(system, &sites),
            clusters: readout::clusters(system, &sites),
            distances,
            bodies,
            coordinates,
            elimination,
        }
    }
}

/// The sites of a listing by name.
struct Sites<'a> {
    system: &'a System,
    free: u16,
}

impl<'a> Sites<'a> {
    fn new(system: &'a System) -> Self {
        let free = index(system.free.len());
        Self { system, free }
    }

    fn index(&self, site: &Site) -> u16 {
        let place = |points: &[Named]| position(points.iter().map(|point| &point.name), &site.name);
        if site.is_free() { 3 * place(&self.system.free) } else { CHASSIS | place(&self.system.fixed) }
    }

    /// How the drives move a site, which is free where no form has it as a chassis point.
    fn motion(&self, site: u16) -> SiteMotion {
        let is_driven = |point: &Ident| {
            let mut drives = self.system.drives.iter();
            drives.any(|drive| drive.minus.is_none() && drive.of.name == *point)
        };
        let chassis = (site & CHASSIS != 0).then_some(site & !CHASSIS);
        match chassis.and_then(|chassis| self.system.fixed.get(usize::from(chassis))) {
            Some(point) if is_driven(&point.name) => SiteMotion::DrivenAnchor,
            Some(_) => SiteMotion::Anchor,
            None => SiteMotion::Free,
        }
    }
}

fn drive_index(system: &System, name: &Ident) -> u16 {
    position(system.drives.iter().map(|drive| &drive.named.name), name)
}

/// Where a name is among others, all of which were checked.
fn position<'a>(mut names: impl Iterator<Item = &'a Ident>, name: &Ident) -> u16 {
    names.position(|other| other == name).map_or(u16::MAX, index)
}

/// An index as plans hold it. Listings are held to far fewer of everything.
fn index(index: usize) -> u16 {
    u16::try_from(index).unwrap_or(u16::MAX)
}

//! Forces at the points of a mechanism: what loads at places of bodies and in measures come to.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::listing::MeasureKind;
use suspension_core::statics::spread;
use suspension_core::wheel::contact;
use suspension_runtime::Statement;

use crate::kinematics::Kinematics;
use crate::loads::site::Site;
use crate::mechanism::{Borne, Mass, State};

/// A force at a point, with the points of the part on which it acts, none where it acts on the point itself.
pub(super) struct Force {
    pub(super) point: usize,
    pub(super) force: Vector3<f64>,
    part: Vec<usize>,
}

impl Force {
    /// Whether it acts on the body of a statement.
    pub(super) fn is_on(&self, statement: &Statement<'_>) -> bool {
        let has = |point: &usize| statement.points.contains(point);
        !self.part.is_empty() && self.part.iter().all(has)
    }
}

/// Forces at the points of a part that act on it.
fn on<const K: usize>(points: &[usize; K], forces: [Vector3<f64>; K]) -> Vec<Force> {
    let each = points.iter().zip(forces);
    each.map(|(point, force)| Force {
        point: *point,
        force,
        part: points.to_vec(),
    })
    .collect()
}

/// The forces at each point together.
pub(super) fn summed(forces: &[Force], points: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
    let mut sums = vec![Vector3::zeros(); points.len()];
    for Force { point, force, .. } in forces {
        sums[*point] += force;
    }
    sums
}

/// A mechanism at a place.
pub(super) struct Here<'a> {
    mechanism: &'a dyn Kinematics,
    /// Markers with three points of the body that carries each.
    carriers: &'a [(usize, [usize; 3])],
    state: &'a State,
}

impl<'a> Here<'a> {
    pub(super) fn new(
        mechanism: &'a dyn Kinematics,
        carriers: &'a [(usize, [usize; 3])],
        state: &'a State,
    ) -> Self {
        Self {
            mechanism,
            carriers,
            state,
        }
    }

    /// What forces at the points do, and groups of equations to the points; `None` where the mechanism locks.
    pub(super) fn under(
        &self,
        forces: &[Vector3<f64>],
        groups: &[Vec<Range<usize>>],
    ) -> Option<Borne> {
        self.mechanism.under(self.state, forces, groups)
    }

    /// All points, in local coordinates.
    pub(super) fn points(&self) -> &[Vector3<f64>] {
        &self.state.points.value
    }

    /// Where a site is, in local coordinates.
    pub(super) fn place_of(&self, site: Site) -> Vector3<f64> {
        match site {
            Site::Point(point) | Site::Body(point, _) => self.points()[point],
            Site::Contact(wheel) => self.contact(wheel),
        }
    }

    /// The forces of loads, N and N m, at places.
    pub(super) fn at_sites(&self, loads: &[(Site, [Vector3<f64>; 2])]) -> Vec<Force> {
        let each = loads.iter().map(|(site, [force, moment])| match *site {
            Site::Point(point) => vec![Force {
                point,
                force: *force,
                part: Vec::new(),
            }],
            Site::Body(_, body) => self.spread(body, self.place_of(*site), *force, *moment),
            Site::Contact(wheel) => {
                let body = self.mechanism.names.wheels[wheel].points.carrier;
                self.spread(body, self.place_of(*site), *force, *moment)
            }
        });
        each.flatten().collect()
    }

    /// The forces of what acts in measures, by number: N, or N m of an angle.
    pub(super) fn in_measures(&self, loads: &[(usize, f64)]) -> Vec<Force> {
        let each = loads.iter();
        each.flat_map(|(measure, along)| self.in_measure(*measure, *along))
            .collect()
    }

    /// The same of one: along its derivative with respect to each point.
    pub(super) fn in_measure(&self, measure: usize, along: f64) -> Vec<Force> {
        let along = match self.mechanism.names.measures[measure].kind {
            MeasureKind::Angle => along * self.mechanism.unit.metre(),
            MeasureKind::Length => along,
        };
        let gradient = self
            .mechanism
            .gradient(self.state, measure)
            .into_iter()
            .enumerate();
        let acting = gradient.filter(|(_, gradient)| *gradient != Vector3::zeros());
        let each = acting
            .map(|(point, gradient)| (self.site_of(point), [gradient * along, Vector3::zeros()]));
        self.at_sites(&each.collect::<Vec<_>>())
    }

    /// The forces of weight and inertia, in a field of gravity and acceleration, m/s^2; `None` where three points that hold a
    /// body are in line.
    pub(super) fn of_masses(&self, field: &Vector3<f64>) -> Option<Vec<Force>> {
        let metre = self.mechanism.unit.metre();
        let mut all = Vec::new();
        for mass in self.state.masses.iter() {
            let forces = mass.forces(&self.state.points, metre, field)?;
            if let (Mass::At(point, _), [(_, force)]) = (mass, forces.as_slice()) {
                all.extend(self.at_sites(&[(self.site_of(*point), [*force, Vector3::zeros()])]));
                continue;
            }
            let part: Vec<usize> = forces.iter().map(|(point, _)| *point).collect();
            all.extend(forces.into_iter().map(|(point, force)| Force {
                point,
                force,
                part: part.clone(),
            }));
        }
        Some(all)
    }

    fn site_of(&self, point: usize) -> Site {
        let carrier = self.carriers.iter().find(|(marker, _)| *marker == point);
        carrier.map_or(Site::Point(point), |(_, body)| Site::Body(point, *body))
    }

    /// A force and a moment at a place of a body, over three points of it.
    fn spread(
        &self,
        body: [usize; 3],
        place: Vector3<f64>,
        force: Vector3<f64>,
        moment: Vector3<f64>,
    ) -> Vec<Force> {
        let points = body.map(|point| self.points()[point]);
        let moment = moment * self.mechanism.unit.metre();
        on(&body, spread(points, force, place, moment))
    }

    /// Where a wheel touches the ground.
    fn contact(&self, wheel: usize) -> Vector3<f64> {
        let (wheel, axes) = (&self.mechanism.names.wheels[wheel], self.state.axes);
        let [inner, centre] = wheel
            .points
            .axis
            .map(|point| axes.turned(self.points()[point]));
        let radius = wheel.radius.unwrap_or(f64::NAN);
        axes.turned(contact(&centre, &(centre - inner), radius))
    }
}

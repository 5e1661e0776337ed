//! Forces at the points of a mechanism that are equivalent to loads at places of bodies and in measures.

use std::cell::OnceCell;

use nalgebra::Vector3;
use suspension_core::listing::MeasureKind;
use suspension_core::statics::spread;
use suspension_core::wheel::contact;
use suspension_listing::Kind;
use suspension_runtime::{AngleShare, PartForces, Statement};

use crate::kinematics::Kinematics;
use crate::loads::site::Site;
use crate::mechanism::{Borne, Mass, State};

/// The work of a force per unit of a drive below which it is rounding, as a fraction of the force; also for singular
/// values.
pub(super) const ROUNDING: f64 = 1e-12;

/// The kinds of statements that are parts with loads of their own. Others may name the same points, for example a couple of
/// three points of one body.
const RIGID: [Kind; 3] = [Kind::LINK, Kind::BODY, Kind::HINGE];

/// A force at a point, and the part on which it acts there.
pub(super) struct Force {
    pub(super) point: usize,
    pub(super) force: Vector3<f64>,
    on: On,
}

/// The object on which a force acts.
enum On {
    /// The point itself.
    Point,
    /// The rigid part with these points.
    Having(Vec<usize>),
    /// The part with this number, which has a share in the load along an angle.
    Angle(usize),
}

impl Force {
    /// Whether it acts on the part of a statement, and not on the point itself.
    pub(super) fn is_on(&self, number: usize, statement: &Statement<'_>) -> bool {
        match &self.on {
            On::Point => false,
            On::Having(points) => {
                RIGID.contains(&statement.kind)
                    && points.iter().all(|point| statement.points.contains(point))
            }
            On::Angle(part) => *part == number,
        }
    }

    /// Whether it is a share in the load along an angle.
    pub(super) fn is_of_angle(&self) -> bool {
        matches!(self.on, On::Angle(_))
    }
}

/// Forces at the points of a part that act on it.
fn forces_on_part(forces: Vec<(usize, Vector3<f64>)>) -> Vec<Force> {
    let part: Vec<usize> = forces.iter().map(|(point, _)| *point).collect();
    let each = forces.into_iter().map(|(point, force)| Force {
        point,
        force,
        on: On::Having(part.clone()),
    });
    each.collect()
}

/// A mechanism at a place.
pub(super) struct Here<'a> {
    pub(super) mechanism: &'a dyn Kinematics,
    /// Markers with three points of the body that carries each.
    pub(super) carriers: &'a [(usize, [usize; 3])],
    /// For each measure, the shares of parts in the load along it.
    pub(super) measured: &'a [Vec<AngleShare>],
    pub(super) state: &'a State,
    /// The derivatives of measures with respect to points, once a load in a measure needs them.
    pub(super) gradients: OnceCell<Vec<Vec<Vector3<f64>>>>,
}

impl Here<'_> {
    /// The effect of forces, and the forces of parts on the points; `None` if the mechanism locks.
    pub(super) fn solve(&self, forces: &[Force], parts: &[PartForces]) -> Option<Borne> {
        let mut at_points = vec![Vector3::zeros(); self.points().len()];
        for Force { point, force, .. } in forces {
            at_points[*point] += force;
        }
        self.mechanism.apply_forces(self.state, &at_points, parts)
    }

    /// The derivative of a measure with respect to each point.
    pub(super) fn gradient(&self, measure: usize) -> &[Vector3<f64>] {
        let gradients = || self.mechanism.gradients(self.state);
        &self.gradients.get_or_init(gradients)[measure]
    }

    /// All points, in local coordinates.
    pub(super) fn points(&self) -> &[Vector3<f64>] {
        &self.state.points.value
    }

    /// The position of a site, in local coordinates.
    pub(super) fn place_of(&self, site: Site) -> Vector3<f64> {
        match site {
            Site::Point(point) | Site::Body(point, _) => self.points()[point],
            Site::Contact(wheel) => self.contact(wheel),
        }
    }

    /// The forces of loads, N and N m, at places.
    pub(super) fn forces_at_sites(&self, loads: &[(Site, [Vector3<f64>; 2])]) -> Vec<Force> {
        let each = loads.iter();
        each.flat_map(|(site, load)| self.forces_at_site(*site, *load))
            .collect()
    }

    /// The forces of a force and a moment at a place; at a body they are spread over three points of it.
    fn forces_at_site(&self, site: Site, [force, moment]: [Vector3<f64>; 2]) -> Vec<Force> {
        let on = On::Point;
        let body = match site {
            Site::Point(point) => return vec![Force { point, force, on }],
            Site::Body(_, body) => body,
            Site::Contact(wheel) => self.mechanism.names.wheels[wheel].points.carrier,
        };
        let points = body.map(|point| self.points()[point]);
        let moment = moment * self.mechanism.unit.metre();
        let forces = spread(points, force, self.place_of(site), moment);
        forces_on_part(body.into_iter().zip(forces).collect())
    }

    /// The forces of a force at a point, which acts on the body that carries the point if it is a marker.
    fn forces_at_point(&self, point: usize, force: Vector3<f64>) -> Vec<Force> {
        let carrier = self.carriers.iter().find(|(marker, _)| *marker == point);
        let site = carrier.map_or(Site::Point(point), |(_, body)| Site::Body(point, *body));
        self.forces_at_site(site, [force, Vector3::zeros()])
    }

    /// The forces of loads in measures, by number: N, or N m for an angle.
    pub(super) fn forces_in_measures(&self, loads: &[(usize, f64)]) -> Vec<Force> {
        let each = loads.iter();
        each.flat_map(|(measure, along)| self.forces_in_measure(*measure, *along))
            .collect()
    }

    /// The forces of a load in one measure: along its derivative with respect to each point.
    pub(super) fn forces_in_measure(&self, measure: usize, along: f64) -> Vec<Force> {
        let mut acting = self.forces_of_measure(measure, along);
        let mut forces = Vec::new();
        // A load at a marker acts on its body in any case.
        let is_marker = |point: usize| self.carriers.iter().any(|(marker, _)| *marker == point);
        let at = |point: usize| self.points()[point];
        let shares = self.measured[measure].iter();
        let shares: Vec<(usize, Vec<_>)> = shares
            .map(|share| {
                (
                    share.part,
                    share.forces(|point| acting[point], at).collect(),
                )
            })
            .collect();
        for (part, on_part) in shares {
            for (point, force) in on_part.into_iter().filter(|(point, _)| !is_marker(*point)) {
                acting[point] -= force;
                forces.push(Force {
                    point,
                    force,
                    on: On::Angle(part),
                });
            }
        }
        let rest = acting.into_iter().enumerate();
        let rest = rest.filter(|(_, force)| *force != Vector3::zeros());
        forces.extend(rest.flat_map(|(point, force)| self.forces_at_point(point, force)));
        forces
    }

    /// The forces at the points of a load in a measure: along its derivative with respect to each.
    fn forces_of_measure(&self, measure: usize, along: f64) -> Vec<Vector3<f64>> {
        let along = match self.mechanism.names.measures[measure].kind {
            MeasureKind::Angle => along * self.mechanism.unit.metre(),
            MeasureKind::Length => along,
        };
        let gradient = self.gradient(measure).iter();
        gradient.map(|gradient| gradient * along).collect()
    }

    /// The moments, N m, of a load in an angle on each part, by number, that carries a line of the angle or its axis.
    pub(super) fn moments_in(&self, angle: usize, along: f64) -> Vec<(usize, Vector3<f64>)> {
        let acting = self.forces_of_measure(angle, along);
        let at = |point: usize| self.points()[point];
        let mut moments: Vec<(usize, Vector3<f64>)> = Vec::new();
        for share in &self.measured[angle] {
            let forces = share.forces(|point| acting[point], at);
            let about_origin = forces.map(|(point, force)| at(point).cross(&force));
            let moment = about_origin.sum::<Vector3<f64>>() / self.mechanism.unit.metre();
            match moments.iter_mut().find(|(part, _)| *part == share.part) {
                Some((_, sum)) => *sum += moment,
                None => moments.push((share.part, moment)),
            }
        }
        moments
    }

    /// The forces of weight and inertia, in a field of gravity and acceleration, m/s^2; `None` if three points that
    /// hold a body are collinear.
    pub(super) fn forces_of_masses(&self, field: &Vector3<f64>) -> Option<Vec<Force>> {
        let metre = self.mechanism.unit.metre();
        let mut all = Vec::new();
        for mass in self.state.masses.iter() {
            let forces = mass.forces(&self.state.points, metre, field)?;
            all.extend(match (mass, forces.as_slice()) {
                (Mass::At(point, _), [(_, force)]) => self.forces_at_point(*point, *force),
                _ => forces_on_part(forces),
            });
        }
        Some(all)
    }

    /// The point where a wheel touches the ground.
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

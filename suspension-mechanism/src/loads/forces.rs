//! Forces at the points of a mechanism: what loads at places of bodies and in measures come to.

use nalgebra::Vector3;
use suspension_core::listing::MeasureKind;
use suspension_core::statics::spread;
use suspension_core::wheel::contact;
use suspension_runtime::Statement;

use crate::loads::site::Site;
use crate::mechanism::{Description, Place, State};

/// A force at a point, with the body on which it acts, where it does not act on the point itself.
pub(super) struct Force {
    pub(super) point: usize,
    pub(super) force: Vector3<f64>,
    body: Option<[usize; 3]>,
}

impl Force {
    /// Whether it acts on the body of a statement.
    pub(super) fn is_on(&self, statement: &Statement<'_>) -> bool {
        let has = |points: [usize; 3]| points.iter().all(|point| statement.points.contains(point));
        self.body.is_some_and(has)
    }
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
    mechanism: &'a Description,
    /// Markers with three points of the body that carries each.
    carriers: &'a [(usize, [usize; 3])],
    pub(super) place: &'a dyn Place,
    state: State,
}

impl<'a> Here<'a> {
    pub(super) fn new(
        mechanism: &'a Description,
        carriers: &'a [(usize, [usize; 3])],
        place: &'a dyn Place,
    ) -> Self {
        Self {
            mechanism,
            carriers,
            place,
            state: place.state(),
        }
    }

    /// All points, in local coordinates.
    pub(super) fn points(&self) -> &[Vector3<f64>] {
        &self.state.points.value
    }

    /// The forces of loads, N and N m, at places.
    pub(super) fn at_sites(&self, loads: &[(Site, [Vector3<f64>; 2])]) -> Vec<Force> {
        let each = loads.iter().map(|(site, [force, moment])| match *site {
            Site::Point(point) => vec![Force {
                point,
                force: *force,
                body: None,
            }],
            Site::Body(point, body) => self.spread(body, self.points()[point], *force, *moment),
            Site::Contact(wheel) => {
                let body = self.mechanism.names.wheels[wheel].points.carrier;
                self.spread(body, self.contact(wheel), *force, *moment)
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
        let gradient = self.place.gradient(measure).into_iter().enumerate();
        let acting = gradient.filter(|(_, gradient)| *gradient != Vector3::zeros());
        let each = acting
            .map(|(point, gradient)| (self.site_of(point), [gradient * along, Vector3::zeros()]));
        self.at_sites(&each.collect::<Vec<_>>())
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
        let parts = spread(points, force, place, moment * self.mechanism.unit.metre());
        let each = body.into_iter().zip(parts);
        each.map(|(point, force)| Force {
            point,
            force,
            body: Some(body),
        })
        .collect()
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

//! The forces of the parts of a listing on the points that they join: those of their own equations, and their shares
//! in angles that are driven or held.

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::Values;

use crate::angle_share::AngleShare;
use crate::listing::Listing;
use crate::statement::Statement;

/// An angle has two lines, or one and an axis of the chassis.
const LINES_OF_AN_ANGLE: usize = 2;

/// A moment about an angle that equations drive or hold.
#[derive(Clone, Debug, PartialEq)]
struct Moment {
    /// The name of the statement that drives or holds the angle.
    angle: String,
    share: AngleShare,
    equations: Vec<Range<usize>>,
    /// Whether it acts on the part; if not, the part is the angle itself, and the share belongs to another part.
    acts: bool,
}

/// The contributions to the forces of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct PartForces {
    equations: Vec<Range<usize>>,
    moments: Vec<Moment>,
}

impl PartForces {
    /// The forces of the equations of a statement alone.
    pub fn from_statement(statement: &Statement<'_>) -> Self {
        Self {
            equations: statement.equations.clone(),
            moments: Vec::new(),
        }
    }

    /// Whether moments about driven or held angles act on the part.
    pub fn bears_moments(&self) -> bool {
        self.moments.iter().any(|moment| moment.acts)
    }

    /// Whether the part is a held angle whose lines are both carried by other parts: all its forces are theirs.
    pub fn all_on_others(&self) -> bool {
        let shares = self.moments.iter().filter(|moment| !moment.acts);
        shares.filter(|moment| moment.share.is_of_line()).count() == LINES_OF_AN_ANGLE
    }

    /// The forces that the part exerts on chassis points and free points, zero at markers, in the unit of the loads: from
    /// the forces `by` equations, as [`Loads::by`](suspension_core::statics::Loads::by) has them, and for the positions `at` of
    /// the points.
    pub fn forces<P: Values<Vector3<f64>>>(&self, by: impl Fn(&Range<usize>) -> P, at: &P) -> P {
        let mut forces = sum(&self.equations, &by);
        for moment in &self.moments {
            for (point, force) in moment.forces(&by, at) {
                let force = if moment.acts { force } else { -force };
                forces = forces.with(point, nth(&forces, point) + force);
            }
        }
        forces
    }

    /// The moments that driven or held angles exert on the part, each with the name of the statement that drives or
    /// holds the angle, in the unit of the loads times that of the points; `by` and `at` as for [`forces`](Self::forces).
    pub fn moments<P: Values<Vector3<f64>>>(
        &self,
        by: impl Fn(&Range<usize>) -> P,
        at: &P,
    ) -> Vec<(&str, Vector3<f64>)> {
        let mut moments: Vec<(&str, Vector3<f64>)> = Vec::new();
        for each in self.moments.iter().filter(|moment| moment.acts) {
            let about_origin = each.forces(&by, at);
            let about_origin = about_origin.map(|(point, force)| nth(at, point).cross(&force));
            let moment: Vector3<f64> = about_origin.sum();
            match moments.iter_mut().find(|(angle, _)| *angle == each.angle) {
                Some((_, sum)) => *sum += moment,
                None => moments.push((&each.angle, moment)),
            }
        }
        moments
    }
}

impl Moment {
    /// The forces at points that make up the share.
    fn forces<P: Values<Vector3<f64>>>(
        &self,
        by: impl Fn(&Range<usize>) -> P,
        at: &P,
    ) -> impl Iterator<Item = (usize, Vector3<f64>)> {
        let of_angle = sum(&self.equations, by);
        let force = move |point| nth(&of_angle, point);
        self.share.forces(force, |point| nth(at, point))
    }
}

/// The forces that equations exert on all points.
fn sum<P: Values<Vector3<f64>>>(equations: &[Range<usize>], by: impl Fn(&Range<usize>) -> P) -> P {
    equations
        .iter()
        .map(by)
        .fold(P::from_values([]), |sum, by| {
            let each = sum.values().zip(by.values());
            P::from_values(each.map(|(sum, by)| sum + by))
        })
}

fn nth<P: Values<Vector3<f64>>>(points: &P, point: usize) -> Vector3<f64> {
    points.values().nth(point).unwrap_or_default()
}

impl Listing {
    /// The contributions to the forces of each of [`parts`](Self::parts).
    ///
    /// ```
    /// use suspension_core::{Values, nalgebra::Vector3};
    /// use suspension_runtime::{Listing, catalogue};
    ///
    /// let listing = Listing::parse(catalogue::listing("double_wishbone_pushrod").unwrap())?;
    /// let corner = listing.corner::<30>(&listing.design().unwrap())?;
    /// let at = corner.points().value;
    /// let [inner, outer, upper] =
    ///     ["damper_inner", "damper_outer", "pushrod_upper"].map(|name| listing.point(name).unwrap());
    /// let [from, to] = at.at([inner, outer]);
    /// let push = (to - from).normalize() * 3000.0; // N, of the spring at the damper
    /// let forces = at.map(|_| Vector3::zeros()).with(outer, push).with(inner, -push);
    ///
    /// let loads = corner.statics().map_err(|failure| failure.to_string())?.under(&forces);
    /// let loads = loads.map_err(|failure| failure.to_string())?;
    /// let pushrod = listing.parts().position(|part| part.name == "pushrod").unwrap();
    /// let by_pushrod = listing.part_forces()[pushrod].forces(|equations| loads.by(equations.clone()), &at);
    /// let [on_rocker] = by_pushrod.at([upper]);
    /// assert_eq!(format!("{:.0} N", on_rocker.norm()), "2921 N");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn part_forces(&self) -> Vec<PartForces> {
        let parts: Vec<_> = self.parts().collect();
        let mut forces: Vec<PartForces> = parts.iter().map(PartForces::from_statement).collect();
        for statement in self.statements() {
            let itself = parts.iter().position(|part| part.name == statement.name);
            for share in self.shares_in(&statement, &parts) {
                let on_parts = [(Some(share.part), true), (itself, false)];
                for (part, acts) in on_parts {
                    let part = part.and_then(|part| forces.get_mut(part));
                    if let Some(part) = part {
                        part.moments.push(Moment {
                            angle: statement.name.to_owned(),
                            share: share.clone(),
                            equations: statement.equations.clone(),
                            acts,
                        });
                    }
                }
            }
        }
        forces
    }
}

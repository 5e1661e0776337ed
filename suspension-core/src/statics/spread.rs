//! A force and a moment at any place of a rigid body, converted to forces at three of its points.

use nalgebra::{Matrix3, Vector3};

use crate::arithmetic::scalar::Real;

/// Three forces at three points of a rigid body that are together equivalent to one force at a place of it and a
/// moment: `f_i = F / 3 + (I^-1 M) x r_i`. Here `r_i` is measured from the centroid of the points, `M` is the moment
/// about the centroid, and `I` the inertia of unit masses at the points. Not finite if the points are collinear.
///
/// A load of a wheel where it touches the ground acts on the body that carries the wheel:
///
/// ```
/// use suspension_core::linkages::double_wishbone::{Corner, Points};
/// use suspension_core::listing::Parts;
/// use suspension_core::nalgebra::Vector3;
/// use suspension_core::statics::spread;
/// use suspension_core::Values;
///
/// let corner: Corner = Corner::design()?;
/// let at = corner.points().value;
/// let contact = at.wheel_centre - Vector3::new(0.0, 0.0, 0.3);
/// let force = Vector3::new(0.0, 2000.0, 4000.0); // N, of a left wheel in a left turn
/// let carrier = corner.model().wheel(0).ok_or("no wheel")?.carrier;
/// let parts = spread(at.at(carrier), force, contact, Vector3::zeros());
/// let mut forces = Points::default();
/// for (point, part) in carrier.into_iter().zip(parts) {
///     forces = forces.with(point, part);
/// }
/// let on_drives = corner.statics()?.under(&forces)?.on_drives();
/// assert_eq!(format!("{:.0} N, {:.0} N", on_drives.bump, on_drives.steer), "4009 N, -296 N");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn spread<T: Real>(
    points: [Vector3<T>; 3],
    force: Vector3<T>,
    place: Vector3<T>,
    moment: Vector3<T>,
) -> [Vector3<T>; 3] {
    let third = T::one() / T::constant(3.0);
    let [a, b, c] = points;
    let middle = (a + b + c) * third;
    let from_middle = points.map(|point| point - middle);
    let inertia = from_middle.iter().fold(Matrix3::zeros(), |sum, r| {
        sum + Matrix3::from_diagonal_element(r.dot(r)) - r * r.transpose()
    });
    let moment = moment + (place - middle).cross(&force);
    let turning = inverse_times(&inertia, &moment);
    from_middle.map(|r| force * third + turning.cross(&r))
}

/// `A^-1 b` by Cramer's rule.
fn inverse_times<T: Real>(matrix: &Matrix3<T>, right: &Vector3<T>) -> Vector3<T> {
    let [a, b, c] = [0, 1, 2].map(|column| Vector3::from(matrix.column(column)));
    let determinant = a.dot(&b.cross(&c));
    Vector3::new(
        right.dot(&b.cross(&c)),
        a.dot(&right.cross(&c)),
        a.dot(&b.cross(right)),
    ) / determinant
}

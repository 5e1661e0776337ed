//! Vectors of three numbers.

pub type Vector = [f64; 3];

pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn norm(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

pub fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// The sine up to which points count as collinear: `FLATTEST_FRAME` of the core, on which this crate does not depend.
/// A test compares the two.
const IN_LINE: f64 = 1e-2;

/// Whether positions are collinear with the first two.
pub(crate) fn are_in_line(places: &[Vector]) -> bool {
    let [first, second, others @ ..] = places else {
        return false;
    };
    let along = minus(*second, *first);
    others.iter().all(|at| {
        let from = minus(*at, *first);
        norm(cross(along, from)) <= IN_LINE * norm(along) * norm(from)
    })
}

/// The sum of vectors, each multiplied by a factor.
pub fn combined(terms: impl IntoIterator<Item = (f64, Vector)>) -> Vector {
    let mut sum = [0.0; 3];
    for (factor, vector) in terms {
        for (sum, x) in sum.iter_mut().zip(vector) {
            *sum += factor * x;
        }
    }
    sum
}

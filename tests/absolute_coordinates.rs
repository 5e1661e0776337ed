//! The paper's own cross-check: the same mechanism in absolute coordinates, the knuckle's
//! position and a unit quaternion, written without any of the solver's code.

use nalgebra::{SMatrix, SVector, Vector3, Vector4};

use crate::support::{self, Reference};

type State = SVector<f64, 7>;

/// Five links, the drive, and the quaternion's norm, over the knuckle's seven coordinates.
struct Knuckle {
    /// Points 6 to 10 in knuckle axes, m.
    local: [Vector3<f64>; 5],
    chassis: [Vector3<f64>; 5],
    lengths: [f64; 5],
}

/// Symmetric bilinear form with `rotate(e, e, s)` the vector `s` turned by the quaternion `e`.
fn rotate(e: &Vector4<f64>, f: &Vector4<f64>, s: &Vector3<f64>) -> Vector3<f64> {
    let (v, w) = (Vector3::new(e.y, e.z, e.w), Vector3::new(f.y, f.z, f.w));
    s * (e.x * f.x - v.dot(&w)) + v * w.dot(s) + w * v.dot(s) + w.cross(s) * e.x + v.cross(s) * f.x
}

fn parts(x: &State) -> (Vector3<f64>, Vector4<f64>) {
    (
        x.fixed_rows::<3>(0).into_owned(),
        x.fixed_rows::<4>(3).into_owned(),
    )
}

impl Knuckle {
    fn new() -> Self {
        let reference = Reference::load();
        let origin = reference.vector(0, "p6_");
        Self {
            local: [6, 7, 8, 9, 10].map(|p| reference.vector(0, &format!("p{p}_")) - origin),
            chassis: ["p1", "p2", "p3", "p4", "p5"].map(support::chassis_point),
            lengths: ["d6_1", "d7_2", "d8_3", "d9_4", "d10_5"].map(support::length),
        }
    }

    fn point(&self, x: &State, index: usize) -> Vector3<f64> {
        let (r, e) = parts(x);
        r + rotate(&e, &e, &self.local[index])
    }

    /// Rate of a point for rates `dx` of the coordinates.
    fn rate(&self, x: &State, dx: &State, index: usize) -> Vector3<f64> {
        let ((_, e), (dr, de)) = (parts(x), parts(dx));
        dr + rotate(&e, &de, &self.local[index]) * 2.0
    }

    fn residual(&self, x: &State, drive: f64) -> State {
        let (_, e) = parts(x);
        State::from_fn(|row, _| match row {
            5 => self.point(x, 0).z - self.chassis[0].z - drive,
            6 => e.norm_squared() - 1.0,
            i => (self.point(x, i) - self.chassis[i]).norm_squared() - self.lengths[i].powi(2),
        })
    }

    fn jacobian(&self, x: &State) -> SMatrix<f64, 7, 7> {
        let (_, e) = parts(x);
        SMatrix::from_fn(|row, column| {
            let dx = State::ith(column, 1.0);
            match row {
                5 => self.rate(x, &dx, 0).z,
                6 => 2.0 * e.dot(&parts(&dx).1),
                i => 2.0 * (self.point(x, i) - self.chassis[i]).dot(&self.rate(x, &dx, i)),
            }
        })
    }

    /// Second rate of the residual at constant rates.
    fn quadratic(&self, x: &State, dx: &State) -> State {
        let (_, de) = parts(dx);
        let second = |i: usize| rotate(&de, &de, &self.local[i]) * 2.0;
        State::from_fn(|row, _| match row {
            5 => second(0).z,
            6 => 2.0 * de.norm_squared(),
            i => {
                let d = self.point(x, i) - self.chassis[i];
                2.0 * self.rate(x, dx, i).norm_squared() + 2.0 * d.dot(&second(i))
            }
        })
    }

    /// Position, velocity and acceleration of the coordinates at time `t`, from a start near by.
    fn solve(&self, start: &State, t: f64) -> [State; 3] {
        let theta = support::theta(t);
        let length = self.lengths[0];
        let (sine, cosine) = theta.value.sin_cos();
        let mut x = *start;
        for _ in 0..20 {
            let lu = self.jacobian(&x).lu();
            x -= lu
                .solve(&self.residual(&x, length * cosine))
                .expect("regular");
        }
        assert!(self.residual(&x, length * cosine).amax() < 1e-14);
        let lu = self.jacobian(&x).lu();
        let velocity = lu
            .solve(&State::ith(5, -length * sine * theta.rate))
            .expect("regular");
        let second = -length * (cosine * theta.rate.powi(2) + sine * theta.second_rate);
        let right = State::ith(5, second) - self.quadratic(&x, &velocity);
        [x, velocity, lu.solve(&right).expect("regular")]
    }

    /// Returns the coordinates of the five points, as unknowns in point coordinates.
    fn points(&self, [x, dx, ddx]: &[State; 3]) -> [SVector<f64, 15>; 3] {
        let gather = |point: &dyn Fn(usize) -> Vector3<f64>| {
            SVector::from_fn(|row, _| point(row / 3)[row % 3])
        };
        let (_, de) = parts(dx);
        let centripetal = |i: usize| rotate(&de, &de, &self.local[i]) * 2.0;
        [
            gather(&|i| self.point(x, i)),
            gather(&|i| self.rate(x, dx, i)),
            gather(&|i| self.rate(x, ddx, i) + centripetal(i)),
        ]
    }
}

#[test]
fn absolute_coordinates_agree_with_point_coordinates() {
    let motions = support::motions(
        &support::attia_model::<f64>(),
        &support::attia_rough(),
        support::attia_inputs,
    );
    let knuckle = Knuckle::new();
    let (r, e) = (Reference::load().vector(0, "p6_"), Vector4::x());
    let mut state = State::from_iterator(r.iter().chain(e.iter()).copied());
    let mut t = 0.0;
    for (motion, instant) in motions.iter().zip(support::INSTANTS) {
        while t < instant - 1e-9 {
            t += 0.005;
            [state, ..] = knuckle.solve(&state, t);
        }
        let [position, velocity, acceleration] = knuckle.points(&knuckle.solve(&state, instant));
        assert!((motion.position - position).amax() < 2e-14);
        assert!((motion.velocity - velocity).amax() < 1e-12);
        assert!((motion.acceleration - acceleration).amax() < 1e-10);
    }
}

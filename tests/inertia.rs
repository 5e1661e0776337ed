//! Forces of weight and inertia against those of the particles that a body is made of.

use fastrand::Rng;
use nalgebra::{Isometry3, Matrix3, Vector3};
use suspension_core::Signal;
use suspension_core::chassis::RigidMotion;
use suspension_core::inertia::{RigidBody, rod};

fn vector(rng: &mut Rng, size: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| size * (2.0 * rng.f64() - 1.0))
}

/// Particles of a body, and three points that it is held by.
struct Particles {
    masses: Vec<f64>,
    at: Vec<Vector3<f64>>,
    points: [Vector3<f64>; 3],
}

impl Particles {
    fn random(rng: &mut Rng) -> Self {
        let count = 7;
        Self {
            masses: (0..count).map(|_| 1.0 + 0.9 * rng.f64()).collect(),
            at: (0..count).map(|_| vector(rng, 0.3)).collect(),
            points: [0; 3].map(|_| vector(rng, 0.3)),
        }
    }

    fn body(&self) -> RigidBody<f64> {
        let mass: f64 = self.masses.iter().sum();
        let each = || self.masses.iter().zip(&self.at);
        let centre: Vector3<f64> = each().map(|(mass, at)| at * *mass).sum::<Vector3<f64>>() / mass;
        let inertia = each().map(|(mass, at)| {
            let r = at - centre;
            (Matrix3::from_diagonal_element(r.norm_squared()) - r * r.transpose()) * *mass
        });
        RigidBody {
            points: self.points,
            mass,
            centre,
            inertia: inertia.sum(),
        }
    }
}

fn motion(rng: &mut Rng) -> RigidMotion<f64> {
    RigidMotion {
        pose: Isometry3::new(vector(rng, 2.0), vector(rng, 1.5)),
        velocity: vector(rng, 3.0),
        omega: vector(rng, 8.0),
        acceleration: vector(rng, 40.0),
        alpha: vector(rng, 90.0),
    }
}

/// Force and moment about the origin.
fn force_and_moment(
    forces: impl Iterator<Item = (Vector3<f64>, Vector3<f64>)>,
) -> [Vector3<f64>; 2] {
    forces.fold([Vector3::zeros(); 2], |[force, moment], (at, each)| {
        [force + each, moment + at.cross(&each)]
    })
}

#[test]
fn weight_and_inertia_of_a_body_equal_those_of_its_particles() {
    let mut rng = Rng::with_seed(31);
    let gravity = Vector3::new(0.3, -0.2, -9.81);
    for case in 0..100 {
        let particles = Particles::random(&mut rng);
        let motion = motion(&mut rng);
        let carry = |at: Vector3<f64>| motion.carry(Signal::still(at));
        let points = particles.points.map(carry);
        let points = Signal {
            value: points.map(|point| point.value),
            rate: points.map(|point| point.rate),
            second_rate: points.map(|point| point.second_rate),
        };
        let forces = particles
            .body()
            .forces(&points, &gravity)
            .expect("a triangle");
        let found = force_and_moment(points.value.into_iter().zip(forces));
        let each = particles
            .masses
            .iter()
            .zip(&particles.at)
            .map(|(mass, at)| {
                let carried = carry(*at);
                (carried.value, (gravity - carried.second_rate) * *mass)
            });
        let expected = force_and_moment(each);
        for (found, expected) in found.iter().zip(expected) {
            let off = (found - expected).norm();
            assert!(
                off <= 1e-9 * expected.norm(),
                "case {case} of seed 31: {off:e}"
            );
        }
    }
}

/// A rod is a body of many particles in line.
#[test]
fn weight_and_inertia_of_a_rod_equal_those_of_its_particles() {
    let mut rng = Rng::with_seed(32);
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let ends = [vector(&mut rng, 0.4), vector(&mut rng, 0.4)];
    let accelerations = [vector(&mut rng, 30.0), vector(&mut rng, 30.0)];
    let count = 2000;
    let each = (0..count).map(|number| {
        let part = (f64::from(number) + 0.5) / f64::from(count);
        let of = |[a, b]: [Vector3<f64>; 2]| a * (1.0 - part) + b * part;
        (
            of(ends),
            (gravity - of(accelerations)) * (1.5 / f64::from(count)),
        )
    });
    let expected = force_and_moment(each);
    let found = force_and_moment(ends.into_iter().zip(rod(1.5, accelerations, &gravity)));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).norm() < 1e-6 * expected.norm());
    }
}

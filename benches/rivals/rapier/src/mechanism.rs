//! The published mechanism as Rapier's bodies and joints.

use rapier3d_f64::prelude::*;

use crate::files::Start;
use crate::listing::Listing;

pub const STEP: f64 = 1e-3;
const POINTS: usize = 5;
/// The mass of knuckle and rods alike, which suits Rapier's iteration best: with rods of a fortieth of it errors are 25
/// times as large.
const MASS: f64 = 20.0;
const INERTIA: f64 = 0.3;
const GRAVITY: f64 = -9.81;

/// The mechanism, started at a given motion.
pub struct Engine<'a> {
    listing: &'a Listing,
    world: PhysicsWorld,
    knuckle: RigidBodyHandle,
    lift: RigidBodyHandle,
    local: [Vector; POINTS],
}

fn solid() -> MassProperties {
    MassProperties::new(Vector::ZERO, MASS, Vector::splat(INERTIA))
}

impl<'a> Engine<'a> {
    pub fn new(listing: &'a Listing, start: &Start, iterations: usize) -> Self {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, 0.0, GRAVITY);
        world.integration_parameters.dt = STEP;
        world.integration_parameters.num_solver_iterations = iterations;
        let (q, v) = (start.points(), start.speeds());
        let knuckle = RigidBodyBuilder::dynamic()
            .translation(q[0])
            .linvel(v[0])
            .angvel(start.spin())
            .additional_mass_properties(solid())
            .can_sleep(false);
        let knuckle = world.insert_body(knuckle);
        let on_height = Vector::new(0.0, 0.0, q[0].z);
        let lift = RigidBodyBuilder::kinematic_position_based().translation(on_height);
        let lift = world.insert_body(lift);
        let drive = GenericJointBuilder::new(JointAxesMask::LIN_Z);
        world.insert_impulse_joint(lift, knuckle, drive);
        let mut engine = Self {
            listing,
            world,
            knuckle,
            lift,
            local: q.map(|point| point - q[0]),
        };
        let ground = engine.world.insert_body(RigidBodyBuilder::fixed());
        for link in 0..POINTS {
            engine.add_rod(ground, link, q[link], v[link]);
        }
        engine
    }

    fn add_rod(&mut self, ground: RigidBodyHandle, link: usize, outer: Vector, speed: Vector) {
        let inner = self.listing.chassis[link];
        let along = outer - inner;
        let rod = RigidBodyBuilder::dynamic()
            .translation((inner + outer) / 2.0)
            .linvel(speed / 2.0)
            .angvel(along.cross(speed) / along.length_squared())
            .additional_mass_properties(solid())
            .can_sleep(false);
        let rod = self.world.insert_body(rod);
        // Scaled to its length, because the points have rounding errors.
        let half = along.normalize() * (self.listing.lengths[link] / 2.0);
        let ball = |first, second| {
            SphericalJointBuilder::new()
                .local_anchor1(first)
                .local_anchor2(second)
        };
        let world = &mut self.world;
        world.insert_impulse_joint(ground, rod, ball(inner, -half));
        world.insert_impulse_joint(rod, self.knuckle, ball(half, self.local[link]));
    }

    /// Steps to the instant `t`, s.
    pub fn step(&mut self, t: f64) {
        let height = Vector::new(0.0, 0.0, self.listing.height(t));
        self.world.bodies[self.lift].set_next_kinematic_translation(height);
        self.world.step();
    }

    /// Returns positions and velocities of the points; Rapier does not report accelerations.
    pub fn motion(&self) -> [f64; 45] {
        let knuckle = &self.world.bodies[self.knuckle];
        let mut motion = [0.0; 45];
        for (index, local) in self.local.iter().enumerate() {
            let place = *knuckle.position() * *local;
            let speed = knuckle.velocity_at_point(place);
            motion[3 * index..][..3].copy_from_slice(&place.to_array());
            motion[15 + 3 * index..][..3].copy_from_slice(&speed.to_array());
        }
        motion
    }

    /// Returns the largest error of a link's length, m.
    pub fn stretch(&self) -> f64 {
        let knuckle = self.world.bodies[self.knuckle].position();
        let off = (0..POINTS).map(|link| {
            let outer = *knuckle * self.local[link];
            ((outer - self.listing.chassis[link]).length() - self.listing.lengths[link]).abs()
        });
        off.fold(0.0, f64::max)
    }
}

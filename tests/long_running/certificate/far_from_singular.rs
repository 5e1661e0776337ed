//! Where the Jacobian is regular, what the solver finds is proved: over the published motion, on
//! random geometries, and with a chassis that moves.

use std::ops::AddAssign;

use nalgebra::{Isometry3, SVector, Vector3};
use suspension_core::certificate::Certifier;
use suspension_core::chassis::RigidMotion;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{
    Build, Inputs, Linkage, Listing, Motion, Newton, Real, Signal, Still, Tracker, Values, assemble,
};

use super::judge::{distance, proof};
use super::random::{sum_of_cases, uniform};
use super::refine::Refiner;
use crate::support;

/// The largest radius and the least distance of another root over the published motion, in steps of
/// a millisecond.
fn over_the_motion<T: Real, L>(
    model: &L,
    rough: &L::Points,
    inputs: fn(T) -> Inputs<Still, L::Drives>,
) -> [f64; 2]
where
    L: Build<15, Scalar = T, Listing: Default>
        + Linkage<15, Listing: Listing<15, Model<T> = L>>
        + Copy,
{
    let certifier = Certifier::new(model);
    let mut q = model.unknowns(rough);
    assemble(&Newton::from_afar(), model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let dt = 1e-3;
    let mut worst = [0.0, f64::INFINITY];
    for step in 0..=1900 {
        let now = inputs(T::constant(f64::from(step) * dt));
        let tracker = Tracker::default();
        tracker
            .step(model, &now, T::constant(dt), &mut motion)
            .expect("regular");
        let certificate = certifier.certify(&now, &motion.position);
        let [radius, unique_within] =
            proof(&certificate).unwrap_or_else(|| panic!("step {step}: {certificate:?}"));
        worst = [worst[0].max(radius), worst[1].min(unique_within)];
    }
    worst
}

#[test]
fn every_step_of_the_published_motion_is_proved() {
    let (attia, five_link) = (support::attia_rough(), support::five_link_rough());
    let rigid = over_the_motion::<f64, _>(
        &support::five_link_model(),
        &five_link,
        support::five_link_inputs,
    );
    let listed = over_the_motion::<f64, _>(&support::attia_model(), &attia, support::attia_inputs);
    println!("f64, radius and distance of another root: {rigid:?} {listed:?}");
    assert!(rigid[0] < 2e-14 && rigid[1] > 1e-3);
    assert!(listed[0] < 5e-14 && listed[1] > 1e-4);
    let (attia, five_link) = (support::attia_rough(), support::five_link_rough());
    let rigid = over_the_motion::<f32, _>(
        &support::five_link_model(),
        &five_link,
        support::five_link_inputs,
    );
    let listed = over_the_motion::<f32, _>(&support::attia_model(), &attia, support::attia_inputs);
    println!("f32: {rigid:?} {listed:?}");
    assert!(rigid[0] < 1e-5 && listed[0] < 5e-5);
}

/// Roots of random geometries, and how many of them are proved.
#[derive(Clone, Copy, Debug, Default)]
struct Shares {
    geometries: usize,
    roots: usize,
    proved: usize,
}

impl AddAssign for Shares {
    fn add_assign(&mut self, other: Self) {
        self.geometries += other.geometries;
        self.roots += other.roots;
        self.proved += other.proved;
    }
}

/// Twenty steps away from a displaced design, or until it locks: each root proved and judged.
fn random_geometry<L>(rough: &L::Points, rng: &mut fastrand::Rng) -> Shares
where
    L: Build<15, Scalar = f64, Listing: Default>
        + Linkage<15, Listing: Listing<15, Model<f64> = L>>
        + Copy,
{
    let mut shares = Shares::default();
    let points = rough.values();
    let design = L::Points::from_values(points.map(|each| {
        let by = Vector3::from_fn(|_, _| uniform(rng, -0.03..0.03));
        each + by
    }));
    let Ok(model) = L::of(L::Listing::default(), &design) else {
        return shares;
    };
    shares.geometries = 1;
    let (certifier, refiner) = (Certifier::new(&model), Refiner::new(&model));
    let start = model.drives_at(&design);
    let speed = uniform(rng, -0.05..0.05);
    let mut motion = Motion::at_rest(model.unknowns(&design));
    for step in 0..20 {
        let drives = start.map(|start| start + speed * f64::from(step));
        let inputs = Inputs::still(Signal {
            value: drives,
            rate: start.map(|_| speed),
            second_rate: L::Drives::default(),
        });
        let dt = if step == 0 { 0.0 } else { 1.0 };
        if Tracker::default()
            .step(&model, &inputs, dt, &mut motion)
            .is_err()
        {
            break;
        }
        let q = motion.position;
        shares.roots += 1;
        let Some([radius, _]) = proof(&certifier.certify(&inputs, &q)) else {
            continue;
        };
        let root = refiner
            .root(model.fixed(), &drives, &q)
            .expect("a root that is proved");
        assert!(distance(&root, &q) <= radius);
        shares.proved += 1;
    }
    shares
}

#[test]
fn roots_of_random_geometries_are_proved() {
    let cases = 500;
    let listed = sum_of_cases(cases, |_, rng| {
        random_geometry::<attia2003::Model<f64>>(&support::attia_rough(), rng)
    });
    let rigid = sum_of_cases(cases, |_, rng| {
        random_geometry::<five_link::Model<f64>>(&support::five_link_rough(), rng)
    });
    println!("seeds 0..{cases}: attia2003 {listed:?}, five_link {rigid:?}");
    for shares in [listed, rigid] {
        assert!(shares.roots > 4000 && shares.proved * 1000 >= shares.roots * 999);
    }
}

/// A chassis that has moved and turned: the same linkage, with other numbers.
#[test]
fn roots_on_a_moving_chassis_are_proved() {
    let model: five_link::Model<f64> = support::five_link_model();
    let (certifier, refiner) = (Certifier::new(&model), Refiner::new(&model));
    let motions = support::motions(
        &model,
        &support::five_link_rough(),
        support::five_link_inputs,
    );
    for (motion, t) in motions.iter().zip(support::INSTANTS).skip(1) {
        let chassis = RigidMotion {
            // A turn about z leaves the driving angle as it is.
            pose: Isometry3::new(Vector3::new(20.0 * t, -3.0, 0.5), Vector3::z() * t),
            velocity: Vector3::x(),
            omega: Vector3::z(),
            acceleration: Vector3::zeros(),
            alpha: Vector3::zeros(),
        };
        let points: Vec<f64> = motion
            .position
            .as_slice()
            .chunks_exact(3)
            .flat_map(|point| {
                let at = chassis.pose * nalgebra::Point3::from_slice(point);
                <[f64; 3]>::from(at.coords)
            })
            .collect();
        let anchors = chassis.anchors(model.fixed());
        let Inputs { drives, .. } = support::five_link_inputs(t);
        let inputs = Inputs {
            chassis: anchors,
            drives,
        };
        let q = SVector::from_row_slice(&points);
        let certificate = certifier.certify(&inputs, &q);
        let [radius, unique_within] =
            proof(&certificate).unwrap_or_else(|| panic!("{t} s: {certificate:?}"));
        let root = refiner
            .root(&anchors.value, &drives.value, &q)
            .expect("a root that is proved");
        assert!(
            distance(&root, &q) <= radius && radius < 1e-12 && unique_within > 1e-3,
            "{t} s: {certificate:?}"
        );
        // Where the chassis points are is part of what is proved.
        assert!(!certifier.certify(&Inputs::still(drives), &q).is_proved());
    }
}

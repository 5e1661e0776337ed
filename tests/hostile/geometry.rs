//! Points that coincide, lie in line or in a plane.

use nalgebra::Vector3;
use suspension_core::linkages::five_link::{Drives, Model, Points};
use suspension_core::{
    Build, GeometryError, Inputs, Linkage, Motion, Newton, Real, Signal, Tracker, assemble,
};

use super::verdict::{demand_root, rounding};
use crate::support::five_link_rough;

fn refused(change: fn(&mut Points<f64>)) -> GeometryError {
    let mut design = five_link_rough();
    change(&mut design);
    Model::new(&design).expect_err("no linkage")
}

#[test]
fn points_that_coincide() {
    let error = refused(|points| points.track_rod_outer = points.track_rod_inner);
    assert_eq!(
        error,
        GeometryError::BadLength {
            length: "track_rod"
        }
    );
    let error = refused(|points| points.upper_front_outer = points.lower_front_outer);
    let point = "upper_rear_outer";
    assert_eq!(error, GeometryError::Collinear { point });
}

#[test]
fn points_in_line() {
    let point = "upper_rear_outer";
    for part in [-1e3, -0.5, 0.5, 2.0, 1e3] {
        let mut design = five_link_rough::<f64>();
        let along = design.upper_front_outer - design.lower_front_outer;
        design.upper_rear_outer = design.lower_front_outer + along * part;
        let error = Model::new(&design).expect_err("no linkage");
        assert_eq!(error, GeometryError::Collinear { point });
    }
}

/// Two links that meet in one ball joint of the knuckle.
#[test]
fn a_ball_joint_that_two_links_share() {
    drives::<f64>(|points| points.track_rod_outer = points.lower_front_outer);
}

/// All points of the knuckle in the plane of the first three.
#[test]
fn a_flat_knuckle() {
    fn flatten<T: Real>(points: &mut Points<T>) {
        let origin = points.lower_front_outer;
        let (u, v) = (
            points.upper_front_outer - origin,
            points.upper_rear_outer - origin,
        );
        let normal: Vector3<T> = u.cross(&v).normalize();
        for point in [&mut points.lower_rear_outer, &mut points.track_rod_outer] {
            *point -= normal * normal.dot(&(*point - origin));
        }
    }
    drives::<f64>(flatten);
    drives::<f32>(flatten);
}

/// Builds, assembles from the rough guess and drives a changed suspension.
fn drives<T: Real>(change: fn(&mut Points<T>)) {
    let mut design = five_link_rough();
    change(&mut design);
    let model = Model::new(&design).expect("a linkage");
    let at_design = model.drives_at(&design);
    let inputs = |t: T| {
        Inputs::still(Signal {
            value: Drives {
                theta: at_design.theta + T::constant(0.5) * t,
            },
            rate: Drives {
                theta: T::constant(0.5),
            },
            second_rate: Default::default(),
        })
    };
    let mut q = Model::unknowns(&design).map(|x| x + T::constant(1e-3));
    assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let end = T::constant(0.1);
    Tracker::default()
        .advance(&model, inputs, T::zero(), end, &mut motion)
        .expect("moves");
    let allowed = rounding(&model, &motion.position);
    demand_root(&model, &inputs(end), &motion, allowed);
}

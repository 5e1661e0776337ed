//! Points that coincide, lie in line or in a plane.

use nalgebra::Vector3;
use suspension_core::linkages::attia2003;
use suspension_core::linkages::five_link::{Drives, Model, Points};
use suspension_core::{
    Build, GeometryError, Inputs, Linkage, Motion, Newton, Real, Signal, Tracker, assemble,
};

use super::verdict::{demand_root, rounding};
use crate::support::{attia_rough, five_link_rough};

fn refused(change: fn(&mut Points<f64>)) -> GeometryError {
    let mut design = five_link_rough();
    change(&mut design);
    Model::new(&design).expect_err("no linkage")
}

/// Its index among all points.
const UPPER_REAR_OUTER: usize = 7;

#[test]
fn coinciding_points_are_refused() {
    let error = refused(|points| points.track_rod_outer = points.track_rod_inner);
    assert_eq!(error, GeometryError::BadLength { length: 4 });
    let error = refused(|points| points.upper_front_outer = points.lower_front_outer);
    let point = UPPER_REAR_OUTER;
    assert_eq!(error, GeometryError::Collinear { point });
}

#[test]
fn collinear_points_of_a_body_are_refused() {
    let point = UPPER_REAR_OUTER;
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
fn two_links_may_share_a_ball_joint() {
    drives::<f64>(|points| points.track_rod_outer = points.lower_front_outer);
}

/// The foot of the perpendicular from a point to the plane of three.
fn flattened<T: Real>(point: Vector3<T>, [a, b, c]: [Vector3<T>; 3]) -> Vector3<T> {
    let normal = (b - a).cross(&(c - a)).normalize();
    point - normal * normal.dot(&(point - a))
}

/// All points of the knuckle in the plane of the first three: nine distances are singular there.
#[test]
fn a_flat_knuckle_of_distances_is_refused() {
    let rough = attia_rough::<f64>();
    let plane = [rough.p6, rough.p7, rough.p8];
    for (name, index) in [("p9", 8), ("p10", 9)] {
        let mut design = rough;
        let point = if name == "p9" {
            &mut design.p9
        } else {
            &mut design.p10
        };
        *point = flattened(*point, plane);
        let error = attia2003::Model::new(&design).expect_err("no linkage");
        assert_eq!(error, GeometryError::Flat { point: index });
        assert!(error.to_string().contains("state these points as a `body`"));
    }
}

/// The same as a body: nothing is special there.
#[test]
fn a_flat_knuckle_stated_as_a_body_moves() {
    fn flatten<T: Real>(points: &mut Points<T>) {
        let plane = [
            points.lower_front_outer,
            points.upper_front_outer,
            points.upper_rear_outer,
        ];
        points.lower_rear_outer = flattened(points.lower_rear_outer, plane);
        points.track_rod_outer = flattened(points.track_rod_outer, plane);
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
    let mut q = model.unknowns(&design).map(|x| x + T::constant(1e-3));
    assemble(&Newton::from_afar(), &model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let end = T::constant(0.1);
    Tracker::default()
        .advance(&model, inputs, T::zero(), end, &mut motion)
        .expect("moves");
    let allowed = rounding(&model, &motion.position);
    demand_root(&model, &inputs(end), &motion, allowed);
}

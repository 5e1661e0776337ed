//! Points that stay in planes: of the chassis, and of an arm that turns.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::{Build, GeometryError, Linkage};

use super::checks;

suspension_core::linkage! {
    /// A rod whose end stays in a plane of the chassis.
    mod guided {
        fixed: anchor, low, high, side;
        free:  tip;
        link rod:    anchor -> tip;
        plane guide: tip on low, high, side;
        drive lift:  tip.z;
    }
}

suspension_core::linkage! {
    /// A point on two rods that stays in a plane of an arm.
    mod carried {
        fixed: front, rear, post, stand;
        free:  knee, elbow, hand, ring;
        hinge arm:   front, rear -> knee, elbow, hand;
        link stay:   post -> ring;
        link prop:   stand -> ring;
        plane table: ring on knee, elbow, hand;
        drive lift:  knee.z;
    }
}

/// Where the spheres about two centres meet in the plane of points at a height along its normal, beside a guess.
fn met(
    [(a, from_a), (b, from_b)]: [(Vector3<f64>, f64); 2],
    (normal, height): (Vector3<f64>, f64),
    guess: Vector3<f64>,
) -> Vector3<f64> {
    let apart = (b - a).norm();
    let axis = (b - a) / apart;
    let along = (from_a * from_a - from_b * from_b + apart * apart) / (2.0 * apart);
    let (centre, radius) = (a + axis * along, (from_a * from_a - along * along).sqrt());
    let across = (guess - centre).cross(&axis).normalize();
    let out = axis.cross(&across);
    // The point is centre + radius (cos out + sin across).
    let (cosine, sine) = (radius * normal.dot(&out), radius * normal.dot(&across));
    let level = (height - normal.dot(&centre)) / cosine.hypot(sine);
    let places = [level.acos(), -level.acos()].map(|turn| {
        let turn = sine.atan2(cosine) + turn;
        centre + (out * turn.cos() + across * turn.sin()) * radius
    });
    let [first, second] = places;
    if (first - guess).norm() < (second - guess).norm() {
        first
    } else {
        second
    }
}

mod of_the_chassis {
    use super::guided::{Drives, Model, Points, unknown};
    use super::*;

    /// The end is 0.4 of the first line and 0.25 of the second from the start of both.
    fn design() -> Points<f64> {
        let low = Vector3::new(0.3, 0.7, -0.1);
        let [to_high, to_side] = [Vector3::new(0.05, -0.1, 0.5), Vector3::new(-0.6, 0.1, 0.04)];
        Points {
            anchor: Vector3::new(-0.3, 0.3, 0.2),
            low,
            high: low + to_high,
            side: low + to_side,
            tip: low + to_high * 0.4 + to_side * 0.25,
        }
    }

    /// The plane and a level meet in a line, and that meets the sphere about the anchor beside the design.
    fn lifted(lift: f64) -> Points<f64> {
        let design = design();
        let normal = (design.high - design.low).cross(&(design.side - design.low));
        let (line, level) = (
            normal.cross(&Vector3::z()).normalize(),
            Vector3::new(normal.x, normal.y, 0.0),
        );
        let start =
            design.tip + Vector3::z() * lift - level * (normal.z * lift / level.norm_squared());
        let (d, rod) = (start - design.anchor, design.tip - design.anchor);
        let half = d.dot(&line);
        let root = (half * half - d.norm_squared() + rod.norm_squared()).sqrt();
        Points {
            tip: start + line * (root.copysign(half) - half),
            ..design
        }
    }

    #[test]
    fn the_end_of_a_rod_stays_in_the_plane_of_the_chassis() {
        let model = Model::new(&design()).expect("a guide");
        for lift in [-0.05, 0.0, 0.08] {
            let expected = lifted(lift);
            let drives = Drives {
                lift: expected.tip.z,
            };
            checks::meets(&model, &design(), drives, &expected, 1e-14);
        }
    }

    /// The unknowns are the distances along the lines, with lengths that are given too.
    #[test]
    fn unknowns_of_a_point_in_a_plane_are_distances_along_lines() {
        let model = Model::new(&design()).expect("a guide");
        let again = model.with_lengths(&model.lengths()).expect("the same");
        for model in [model, again] {
            let q = model.unknowns(&design());
            let [high, side] =
                [design().high, design().side].map(|end| (end - design().low).norm());
            assert!((q[unknown::GUIDE_HIGH] - 0.4 * high).abs() < 1e-15);
            assert!((q[unknown::GUIDE_SIDE] - 0.25 * side).abs() < 1e-15);
            let residual = model.residual(&q, model.fixed(), &model.drives_at(&design()));
            assert!(residual.amax() < 1e-15, "{residual}");
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("a guide");
        checks::derivatives_and_motion(&model, &design(), 0.03);
    }

    #[test]
    fn a_plane_through_three_collinear_points_is_refused() {
        let mut points = design();
        points.side = points.low + (points.high - points.low) * 2.0;
        let refused = Model::new(&points).expect_err("no plane");
        assert_eq!(refused, GeometryError::Collinear { point: 3 });
        assert_eq!(
            refused.named(&super::guided::Listing).to_string(),
            "the three points that carry a point, or that a plane goes through, lie in line: point `side`; \
             move one of them off the line, or name three that form a triangle"
        );
    }
}

mod of_a_body {
    use super::carried::{Drives, Model, Points};
    use super::*;

    fn design() -> Points<f64> {
        let knee = Vector3::new(0.0, 0.6, 0.2);
        let [elbow, hand] = [Vector3::new(0.2, 0.5, 0.2), Vector3::new(-0.1, 0.55, 0.4)];
        Points {
            front: Vector3::new(0.2, 0.1, 0.0),
            rear: Vector3::new(-0.3, 0.15, 0.05),
            post: Vector3::new(0.1, 0.2, 0.7),
            stand: Vector3::new(-0.4, 0.5, 0.5),
            knee,
            elbow,
            hand,
            ring: knee + (elbow - knee) * 0.3 + (hand - knee) * 0.5,
        }
    }

    /// The arm turned by an angle, and the ring where its rods meet the arm's plane.
    fn turned(angle: f64) -> Points<f64> {
        let design = design();
        let axis = Unit::new_normalize(design.rear - design.front);
        let turn = Rotation3::from_axis_angle(&axis, angle);
        let about = |point: Vector3<f64>| design.front + turn * (point - design.front);
        let [knee, elbow, hand] = [design.knee, design.elbow, design.hand].map(about);
        let normal = (elbow - knee).cross(&(hand - knee)).normalize();
        let rods = [design.post, design.stand].map(|end| (end, (design.ring - end).norm()));
        Points {
            knee,
            elbow,
            hand,
            ring: met(rods, (normal, normal.dot(&knee)), design.ring),
            ..design
        }
    }

    #[test]
    fn a_point_on_two_rods_stays_in_the_plane_of_a_turning_arm() {
        let model = Model::new(&design()).expect("an arm");
        for angle in [-0.2, -0.05, 0.0, 0.1, 0.15] {
            let expected = turned(angle);
            let drives = Drives {
                lift: expected.knee.z,
            };
            checks::meets(&model, &design(), drives, &expected, 1e-12);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("an arm");
        checks::derivatives_and_motion(&model, &design(), 0.03);
    }
}

//! Points that slide: a strut whose line the knuckle carries, its top on the chassis, and a pillar on the
//! chassis that a knuckle's points slide on.

use nalgebra::{Rotation3, SMatrix, SVector, Unit, Vector3};
use suspension_core::{Build, GeometryError, Linkage};

use super::checks;

suspension_core::linkage! {
    /// MacPherson strut with rack steering.
    mod macpherson {
        fixed: lower_front, lower_rear, rack, top;
        free:  lower_ball, tie_ball, strut_low, strut_high, wheel_centre;
        hinge lower_arm: lower_front, lower_rear -> lower_ball;
        link tie_rod:    rack -> tie_ball;
        body knuckle:    lower_ball, tie_ball, wheel_centre, strut_low, strut_high;
        slide strut:     top on strut_low -> strut_high;
        drive bump:  wheel_centre.z;
        drive steer: rack.y;
        measure damper: length(top -> strut_low);
    }
}

suspension_core::linkage! {
    /// Sliding pillar: two points of the knuckle on a line of the chassis, and a link that steers.
    mod pillar {
        fixed: low, high, arm;
        free:  lower, upper, tie;
        body knuckle: lower, upper, tie;
        slide below: lower on low -> high;
        slide above: upper on low -> high;
        link steering: arm -> tie;
        drive bump: lower.z;
    }
}

mod strut {
    use super::macpherson::{Drives, Model, Points};
    use super::*;

    /// The strut's line points at its top.
    fn design() -> Points<f64> {
        let (strut_low, top) = (
            Vector3::new(0.0, 0.63, 0.30),
            Vector3::new(-0.03, 0.56, 0.82),
        );
        Points {
            lower_front: Vector3::new(0.18, 0.36, 0.17),
            lower_rear: Vector3::new(-0.22, 0.37, 0.18),
            rack: Vector3::new(-0.13, 0.34, 0.24),
            top,
            lower_ball: Vector3::new(0.01, 0.71, 0.16),
            tie_ball: Vector3::new(-0.12, 0.69, 0.23),
            strut_low,
            strut_high: strut_low + (top - strut_low).normalize() * 0.17,
            wheel_centre: Vector3::new(0.0, 0.76, 0.31),
        }
    }

    /// The knuckle turned by a rotation vector about its strut's foot, and moved.
    fn posed(pose: &SVector<f64, 6>) -> Points<f64> {
        let design = design();
        let turn = Rotation3::from_scaled_axis(pose.fixed_rows::<3>(0).into_owned());
        let shift: Vector3<f64> = pose.fixed_rows::<3>(3).into_owned();
        let at = |point: Vector3<f64>| design.strut_low + turn * (point - design.strut_low) + shift;
        Points {
            lower_ball: at(design.lower_ball),
            tie_ball: at(design.tie_ball),
            strut_low: at(design.strut_low),
            strut_high: at(design.strut_high),
            wheel_centre: at(design.wheel_centre),
            ..design
        }
    }

    /// The excess lengths of the links to the chassis, how far the top is off the strut's line, and the wheel too high.
    fn misfit(points: &Points<f64>, bump: f64) -> SVector<f64, 6> {
        let lengths = |points: &Points<f64>| {
            [
                points.lower_ball - points.lower_front,
                points.lower_ball - points.lower_rear,
                points.tie_ball - points.rack,
            ]
            .map(|link| link.norm())
        };
        let ([fore, aft, tie], kept) = (lengths(points), lengths(&design()));
        let e = (points.strut_high - points.strut_low).normalize();
        let across = e.cross(&Vector3::x()).normalize();
        let top = points.top - points.strut_low;
        SVector::from([
            fore - kept[0],
            aft - kept[1],
            tie - kept[2],
            top.dot(&across),
            top.dot(&e.cross(&across)),
            points.wheel_centre.z - bump,
        ])
    }

    /// By Newton's method on the knuckle's pose, with a Jacobian of differences.
    fn solved(drives: &Drives<f64>) -> Points<f64> {
        let at = |pose: &SVector<f64, 6>| {
            let mut points = posed(pose);
            points.rack.y = drives.steer;
            points
        };
        let misfit = |pose: SVector<f64, 6>| misfit(&at(&pose), drives.bump);
        let mut pose = SVector::<f64, 6>::zeros();
        for _ in 0..30 {
            let by = |k| {
                let mut step = SVector::<f64, 6>::zeros();
                step[k] = 1e-6;
                (misfit(pose + step) - misfit(pose - step)) / 2e-6
            };
            let jacobian = SMatrix::<f64, 6, 6>::from_columns(&std::array::from_fn::<_, 6, _>(by));
            pose -= jacobian.lu().solve(&misfit(pose)).expect("a regular pose");
        }
        at(&pose)
    }

    #[test]
    fn points_of_a_strut_match_the_pose_of_the_knuckle() {
        let model = Model::new(&design()).expect("a strut");
        let start = model.drives_at(&design());
        for (bump, steer) in [(0.0, 0.0), (0.05, 0.0), (-0.06, 0.02), (0.03, -0.03)] {
            let drives = Drives {
                bump: start.bump + bump,
                steer: start.steer + steer,
            };
            let expected = solved(&drives);
            checks::meets(&model, &design(), drives, &expected, 1e-12);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("a strut");
        checks::derivatives_and_motion(&model, &design(), 0.03);
    }

    /// The unknown is the strut's length, with lengths that are given too.
    #[test]
    fn the_unknown_of_a_slide_is_the_length_of_the_strut() {
        let model = Model::new(&design()).expect("a strut");
        let again = model.with_lengths(&model.lengths()).expect("the same");
        for model in [model, again] {
            let q = model.unknowns(&design());
            let length = (design().top - design().strut_low).norm();
            assert!((q[macpherson::unknown::STRUT] - length).abs() < 1e-15);
            let residual = model.residual(&q, model.fixed(), &model.drives_at(&design()));
            assert!(residual.amax() < 1e-15, "{residual}");
        }
    }

    #[test]
    fn a_slide_on_a_line_of_zero_length_is_refused() {
        let mut points = design();
        points.strut_high = points.strut_low;
        let refused = Model::new(&points).expect_err("no line");
        assert_eq!(refused, GeometryError::NoLine { point: 7 });
        assert_eq!(
            refused.named(&macpherson::Listing).to_string(),
            "a line has no length, or lies along the axis of its angle: point `strut_high`; put its ends apart, or off the axis"
        );
    }
}

mod chassis_line {
    use super::pillar::{Drives, Model, Points};
    use super::*;

    fn design() -> Points<f64> {
        let (low, high) = (Vector3::new(0.02, 0.6, 0.1), Vector3::new(-0.03, 0.58, 0.5));
        Points {
            low,
            high,
            arm: Vector3::new(-0.1, 0.3, 0.3),
            lower: low + (high - low) * 0.3,
            upper: low + (high - low) * 0.7,
            tie: Vector3::new(-0.12, 0.62, 0.28),
        }
    }

    /// The knuckle moved along the pillar and turned about it until the link has its length: the
    /// angle by bisection.
    fn moved(shift: f64) -> Points<f64> {
        let design = design();
        let axis = Unit::new_normalize(design.high - design.low);
        let at = |angle: f64| {
            let turn = Rotation3::from_axis_angle(&axis, angle);
            let along = axis.into_inner() * shift;
            let moved = |point: Vector3<f64>| design.low + turn * (point - design.low) + along;
            Points {
                lower: moved(design.lower),
                upper: moved(design.upper),
                tie: moved(design.tie),
                ..design
            }
        };
        let length = (design.tie - design.arm).norm();
        let excess = |angle: f64| (at(angle).tie - design.arm).norm() - length;
        let (mut low, mut high) = (-0.3, 0.3);
        let rises = excess(high) > excess(low);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (excess(middle) > 0.0) == rises {
                high = middle;
            } else {
                low = middle;
            }
        }
        at(0.5 * (low + high))
    }

    #[test]
    fn a_knuckle_on_a_pillar_slides_and_turns() {
        let model = Model::new(&design()).expect("a pillar");
        for shift in [-0.06, 0.0, 0.05] {
            let expected = moved(shift);
            let drives = Drives {
                bump: expected.lower.z,
            };
            checks::meets(&model, &design(), drives, &expected, 1e-12);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("a pillar");
        checks::derivatives_and_motion(&model, &design(), 0.03);
    }
}

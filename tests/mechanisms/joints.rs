//! Joints between bodies that move: revolute, universal and prismatic, against rotations and shifts.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::Build;

use super::checks;

suspension_core::linkage! {
    /// Two shafts whose forks stand square to each other: a universal joint where their axes meet.
    mod universal {
        fixed: rear, centre, front;
        free:  left, right, upper, lower;
        hinge input:  rear, centre -> left, right;
        hinge output: centre, front -> upper, lower;
        angle cross:  left -> right, lower -> upper;
        drive turn:   left.z;
    }
}

suspension_core::linkage! {
    /// A block that an arm guides, and a flap on two points of it.
    mod telescope {
        fixed: front, rear, anchor;
        free:  low, high, side, foot, head, wing, tip;
        hinge arm:    front, rear -> low, high, side;
        body block:   foot, head, wing;
        slide first:  foot on low -> high;
        slide second: head on low -> high;
        plane key:    wing on low, high, side;
        body flap:    head, wing, tip;
        link stay:    anchor -> tip;
        drive lift:   low.z;
        drive reach:  length(low -> foot);
    }
}

mod cross {
    use super::universal::{Drives, Model, Points};
    use super::*;

    /// The input shaft turned by an angle; the output's fork is square to the input's and to its own shaft.
    fn turned(angle: f64) -> Points<f64> {
        let (centre, axis) = (Vector3::new(0.1, 0.2, 0.3), Vector3::x());
        let front = Vector3::new(0.9, 0.1, 0.4).normalize();
        let fork =
            Rotation3::from_axis_angle(&Unit::new_unchecked(axis), angle) * Vector3::y() * 0.05;
        let other = front.cross(&fork).normalize() * -0.04;
        Points {
            rear: centre - axis * 0.4,
            centre,
            front: centre + front * 0.3,
            left: centre + fork,
            right: centre - fork,
            upper: centre + other,
            lower: centre - other,
        }
    }

    #[test]
    fn the_output_shaft_turns_like_that_of_a_universal_joint() {
        let design = turned(0.3);
        let model = Model::new(&design).expect("two shafts");
        for angle in [-0.5, 0.0, 0.3, 1.0] {
            let expected = turned(angle);
            let drives = Drives {
                turn: expected.left.z,
            };
            checks::meets(&model, &turned(angle - 0.05), drives, &expected, 1e-13);
        }
    }
}

mod guided {
    use super::telescope::{Drives, Model, Points};
    use super::*;

    fn design() -> Points<f64> {
        let low = Vector3::new(0.0, 0.6, 0.2);
        let [rail, out] = [Vector3::new(0.05, 0.2, 0.3), Vector3::new(0.3, -0.05, 0.1)];
        Points {
            front: Vector3::new(0.2, 0.1, 0.0),
            rear: Vector3::new(-0.3, 0.15, 0.05),
            anchor: Vector3::new(0.2, 1.2, 0.1),
            low,
            high: low + rail,
            side: low + out,
            foot: low + rail * 0.2,
            head: low + rail * 0.7,
            wing: low + rail * 0.5 + out * 0.6,
            tip: Vector3::new(0.3, 0.9, 0.5),
        }
    }

    /// The arm turned by an angle, the block shifted along its line, and the flap turned until the stay has its length:
    /// by bisection.
    fn moved(angle: f64, shift: f64) -> Points<f64> {
        let design = design();
        let rail = (design.high - design.low).normalize() * shift;
        let axis = Unit::new_normalize(design.rear - design.front);
        let turn = Rotation3::from_axis_angle(&axis, angle);
        let about = |point: Vector3<f64>| design.front + turn * (point - design.front);
        let [head, wing, tip] =
            [design.head, design.wing, design.tip].map(|point| about(point + rail));
        let hinge = Unit::new_normalize(wing - head);
        let folded = |by: f64| head + Rotation3::from_axis_angle(&hinge, by) * (tip - head);
        let stay = (design.tip - design.anchor).norm();
        let excess = |by: f64| (folded(by) - design.anchor).norm() - stay;
        let (mut low, mut high) = (-0.8, 0.8);
        let rises = excess(high) > excess(low);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if (excess(middle) > 0.0) == rises {
                high = middle;
            } else {
                low = middle;
            }
        }
        Points {
            low: about(design.low),
            high: about(design.high),
            side: about(design.side),
            foot: about(design.foot + rail),
            head,
            wing,
            tip: folded(0.5 * (low + high)),
            ..design
        }
    }

    #[test]
    fn a_block_slides_in_an_arm_without_turning() {
        let model = Model::new(&design()).expect("an arm");
        for (angle, shift) in [(0.0, 0.0), (0.1, 0.03), (-0.1, 0.06), (0.05, -0.02)] {
            let expected = moved(angle, shift);
            let drives = Drives {
                lift: expected.low.z,
                reach: (expected.foot - expected.low).norm(),
            };
            checks::meets(&model, &design(), drives, &expected, 1e-12);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("an arm");
        checks::derivatives_and_motion(&model, &design(), 0.02);
    }
}

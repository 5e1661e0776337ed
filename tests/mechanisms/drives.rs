//! Drives along a direction, of chassis points and of free points, and of lengths.

use nalgebra::{Rotation3, SVector, Unit, Vector3};
use suspension_core::{Build, Inputs, Linkage, Motion, Newton, Signal, Tracker, Values, assemble};

use super::checks;

suspension_core::linkage! {
    /// Double wishbone with a rack that is not square to the vehicle.
    mod skewed {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, wheel_centre;
        hinge lower_arm: lower_front, lower_rear -> lower_ball;
        hinge upper_arm: upper_front, upper_rear -> upper_ball;
        link tie_rod:    rack -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, wheel_centre;
        drive bump:  wheel_centre along [0.02, 0.1, 1.0];
        drive steer: rack along [-1, 20, 0.0];
        measure travel: rack along [-1, 20, 0.0];
    }
}

suspension_core::linkage! {
    /// The same with coordinates.
    mod square {
        fixed: lower_front, lower_rear, upper_front, upper_rear, rack;
        free:  lower_ball, upper_ball, tie_ball, wheel_centre;
        hinge lower_arm: lower_front, lower_rear -> lower_ball;
        hinge upper_arm: upper_front, upper_rear -> upper_ball;
        link tie_rod:    rack -> tie_ball;
        body upright:    lower_ball, upper_ball, tie_ball, wheel_centre;
        drive bump:  wheel_centre.z;
    }
}

suspension_core::linkage! {
    /// A rocker that an actuator turns.
    mod actuated {
        fixed: front, rear, anchor;
        free:  push, pull;
        hinge bell_crank: front, rear -> pull, push;
        drive actuator: length(anchor -> push);
        measure stroke: length(push -> anchor);
    }
}

mod along {
    use super::*;

    fn design() -> skewed::Points<f64> {
        let at = Vector3::new;
        skewed::Points {
            lower_front: at(0.15, 0.40, 0.18),
            lower_rear: at(-0.20, 0.42, 0.19),
            upper_front: at(0.10, 0.45, 0.55),
            upper_rear: at(-0.15, 0.48, 0.56),
            rack: at(-0.16, 0.38, 0.30),
            lower_ball: at(0.01, 0.75, 0.15),
            upper_ball: at(-0.02, 0.68, 0.56),
            tie_ball: at(-0.14, 0.74, 0.31),
            wheel_centre: at(0.0, 0.76, 0.33),
        }
    }

    fn started(
        model: &skewed::Model<f64>,
        design: &skewed::Points<f64>,
        drives: Signal<skewed::Drives<f64>>,
    ) -> SVector<f64, 12> {
        let mut q = model.unknowns(design);
        assemble(&Newton::from_afar(), model, &Inputs::still(drives), &mut q).expect("beside it");
        q
    }

    fn direction() -> Vector3<f64> {
        Vector3::new(-1.0, 20.0, 0.0).normalize()
    }

    /// The rack moved by hand in the one, by its drive in the other: the same motion.
    #[test]
    fn a_drive_along_an_oblique_direction_moves_the_rack_on_its_line() {
        let skew = skewed::Model::new(&design()).expect("a wishbone");
        let by_hand = square::Points::from_values(design().values());
        let by_hand = square::Model::new(&by_hand).expect("a wishbone");
        let start = skew.drives_at(&design());
        assert!((start.steer - design().rack.dot(&direction())).abs() < 1e-15);
        // The swing starts beside the design.
        let mut motion = Motion::at_rest(started(
            &skew,
            &design(),
            checks::swinging(start, 0.03, 0.0),
        ));
        let mut other = motion;
        for step in 0..400 {
            let t = f64::from(step) * 1e-3;
            let drives = checks::swinging(start, 0.03, t);
            let inputs = Inputs::still(drives);
            Tracker::default()
                .step(&skew, &inputs, 1e-3, &mut motion)
                .expect("a step");
            let points = motion.points(&skew, &inputs);
            let off = direction() * (drives.value.steer - start.steer);
            let chassis = |rack: Vector3<f64>, at: square::Fixed<f64>| square::Fixed { rack, ..at };
            let rest = square::Fixed::default();
            let inputs = Inputs {
                chassis: Signal {
                    value: chassis(design().rack + off, *by_hand.fixed()),
                    rate: chassis(direction() * drives.rate.steer, rest),
                    second_rate: chassis(direction() * drives.second_rate.steer, rest),
                },
                drives: Signal {
                    value: square::Drives {
                        bump: points.value.wheel_centre.z,
                    },
                    rate: square::Drives {
                        bump: points.rate.wheel_centre.z,
                    },
                    second_rate: square::Drives {
                        bump: points.second_rate.wheel_centre.z,
                    },
                },
            };
            Tracker::default()
                .step(&by_hand, &inputs, 1e-3, &mut other)
                .expect("a step");
            let expected = other.points(&by_hand, &inputs);
            let off = |a: skewed::Points<f64>, b: square::Points<f64>| {
                let pairs = a.values().zip(b.values());
                pairs.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
            };
            assert!(off(points.value, expected.value) < 1e-14, "{step}");
            assert!(off(points.rate, expected.rate) < 1e-12, "{step}");
            assert!(
                off(points.second_rate, expected.second_rate) < 1e-10,
                "{step}"
            );
            let read = skew.measures(&points);
            assert!((read.value.travel - drives.value.steer).abs() < 1e-15);
            assert!((read.second_rate.travel - drives.second_rate.steer).abs() < 1e-14);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = skewed::Model::new(&design()).expect("a wishbone");
        checks::derivatives_and_motion(&model, &design(), 0.02);
    }
}

mod length {
    use super::actuated::{Drives, Model, Points, unknown};
    use super::*;

    fn design() -> Points<f64> {
        Points {
            front: Vector3::new(0.10, 0.02, 0.50),
            rear: Vector3::new(-0.08, 0.05, 0.53),
            anchor: Vector3::new(0.05, 0.30, 0.30),
            push: Vector3::new(0.03, 0.15, 0.55),
            pull: Vector3::new(-0.01, 0.08, 0.63),
        }
    }

    /// The rocker turned by an angle.
    fn turned(angle: f64) -> Points<f64> {
        let design = design();
        let axis = Unit::new_normalize(design.rear - design.front);
        let turn = Rotation3::from_axis_angle(&axis, angle);
        let about = |point: Vector3<f64>| design.front + turn * (point - design.front);
        Points {
            push: about(design.push),
            pull: about(design.pull),
            ..design
        }
    }

    #[test]
    fn an_actuator_turns_a_rocker_as_in_closed_form() {
        let model = Model::new(&design()).expect("a rocker");
        let again = model.with_lengths(&model.lengths()).expect("the same");
        for model in [model, again] {
            for angle in [-0.4, -0.1, 0.0, 0.2, 0.5] {
                let expected = turned(angle);
                let actuator = (expected.push - expected.anchor).norm();
                assert!((model.drives_at(&expected).actuator - actuator).abs() < 1e-15);
                let q = model.unknowns(&expected);
                assert!((q[unknown::ACTUATOR] - actuator).abs() < 1e-15);
                checks::meets(
                    &model,
                    &turned(0.8 * angle),
                    Drives { actuator },
                    &expected,
                    1e-14,
                );
            }
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("a rocker");
        checks::derivatives_and_motion(&model, &design(), 0.03);
        let inputs = Inputs {
            chassis: checks::heaving(model.fixed(), 0.01, 0.2),
            drives: checks::swinging(model.drives_at(&design()), 0.03, 0.2),
        };
        let mut motion = Motion::at_rest(model.unknowns(&design()));
        let q = &mut motion.position;
        assemble(&Newton::from_afar(), &model, &inputs, q).expect("a configuration");
        Tracker::default()
            .step(&model, &inputs, 0.0, &mut motion)
            .expect("a step");
        let stroke = model.measures(&motion.points(&model, &inputs));
        let driven = inputs.drives;
        assert!((stroke.value.stroke - driven.value.actuator).abs() < 1e-15);
        assert!((stroke.rate.stroke - driven.rate.actuator).abs() < 1e-13);
        assert!((stroke.second_rate.stroke - driven.second_rate.actuator).abs() < 1e-12);
    }
}

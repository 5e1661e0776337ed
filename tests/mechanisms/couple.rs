//! Coordinates that move as one, and drives of sums.

use nalgebra::Vector3;
use suspension_core::{Build, Linkage, Signal, Values};

use super::checks;

suspension_core::linkage! {
    /// Two blocks on lines of the chassis, geared to each other.
    mod geared {
        fixed: low, high, near, far;
        free:  block, slider;
        slide pillar: block on low -> high;
        slide rail:   slider on near -> far;
        couple gear:  slider.y - 0.5 * slider.x = 2 block.z;
        drive lift:   block.z;
        measure sum:  0.25 block.z - 3 slider.y;
    }
}

suspension_core::linkage! {
    /// Two trailing arms, by the mean and the difference of their heights.
    mod sums {
        fixed: left_inner, left_outer, right_inner, right_outer;
        free:  left, right;
        hinge left_arm:  left_inner, left_outer -> left;
        hinge right_arm: right_inner, right_outer -> right;
        drive heave: 0.5 left.z + 0.5 right.z;
        drive roll:  left.z - right.z;
    }
}

suspension_core::linkage! {
    /// The same by their heights.
    mod heights {
        fixed: left_inner, left_outer, right_inner, right_outer;
        free:  left, right;
        hinge left_arm:  left_inner, left_outer -> left;
        hinge right_arm: right_inner, right_outer -> right;
        drive bump_left:  left.z;
        drive bump_right: right.z;
    }
}

mod held {
    use super::geared::{Drives, Model, Points};
    use super::*;

    /// The blocks moved along their lines.
    fn at(block: f64, slider: f64) -> Points<f64> {
        let (low, high) = (Vector3::new(0.02, 0.6, 0.1), Vector3::new(-0.03, 0.58, 0.5));
        let (near, far) = (Vector3::new(0.3, 0.2, 0.3), Vector3::new(0.2, 0.8, 0.35));
        Points {
            low,
            high,
            near,
            far,
            block: low + (high - low) * block,
            slider: near + (far - near) * slider,
        }
    }

    #[test]
    fn coupled_coordinates_move_as_one() {
        let design = at(0.4, 0.5);
        let model = Model::new(&design).expect("two blocks");
        let again = model.with_lengths(&model.lengths()).expect("the same");
        for block in [0.2, 0.4, 0.55] {
            // Slider.y - 0.5 slider.x rises by 0.65 along the rail, 2 block.z by 0.8 along the pillar.
            let expected = at(block, 0.5 + (block - 0.4) * 0.8 / 0.65);
            let drives = Drives {
                lift: expected.block.z,
            };
            for model in [model, again] {
                checks::meets(&model, &design, drives, &expected, 1e-14);
            }
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let design = at(0.4, 0.5);
        let model = Model::new(&design).expect("two blocks");
        checks::derivatives_and_motion(&model, &design, 0.03);
    }

    #[test]
    fn a_measured_sum_matches_its_coordinates() {
        let design = at(0.3, 0.6);
        let model = Model::new(&at(0.4, 0.5)).expect("two blocks");
        let signal = Signal::still(design);
        let found = model.measures(&signal).value.sum;
        assert!((found - (0.25 * design.block.z - 3.0 * design.slider.y)).abs() < 1e-15);
    }
}

mod driven {
    use super::sums::{Drives, Model, Points};
    use super::*;

    fn design() -> Points<f64> {
        Points {
            left_inner: Vector3::new(0.5, 0.3, 0.3),
            left_outer: Vector3::new(0.45, 0.6, 0.32),
            right_inner: Vector3::new(0.5, -0.3, 0.3),
            right_outer: Vector3::new(0.45, -0.6, 0.32),
            left: Vector3::new(0.0, 0.7, 0.3),
            right: Vector3::new(0.0, -0.7, 0.3),
        }
    }

    #[test]
    fn drives_in_heave_and_roll_equal_drives_of_both_heights() {
        let (design, other) = (design(), heights::Points::from_values(design().values()));
        let model = Model::new(&design).expect("two arms");
        let by_height = heights::Model::new(&other).expect("two arms");
        for (heave, roll) in [(0.30, 0.0), (0.35, 0.06), (0.27, -0.10)] {
            let found = checks::solve(&model, &design, Drives { heave, roll });
            let drives = heights::Drives {
                bump_left: heave + 0.5 * roll,
                bump_right: heave - 0.5 * roll,
            };
            let expected = checks::solve(&by_height, &other, drives);
            let apart = checks::largest_distance(&found, &Points::from_values(expected.values()));
            assert!(apart < 1e-14, "{heave}, {roll}: {apart:e}");
            let read = model.drives_at(&found);
            assert!((read.heave - heave).abs() < 1e-15 && (read.roll - roll).abs() < 1e-15);
        }
    }

    #[test]
    fn derivatives_and_motion_agree_with_differences() {
        let model = Model::new(&design()).expect("two arms");
        checks::derivatives_and_motion(&model, &design(), 0.03);
    }
}

//! Each side moves like the double wishbone alone, and like the mirror image of the other; the rack slides and does not
//! turn.

use super::layout::{CLOSE, Layout, TRAVEL};

const RACK: [f64; 3] = [-0.03, 0.0, 0.03];

#[test]
fn the_left_side_moves_like_the_double_wishbone() {
    let (axle, corner) = (
        Layout::read("steered_axle"),
        Layout::read("double_wishbone"),
    );
    for bump in TRAVEL {
        for steer in RACK {
            let both = axle.moved(&[("bump_left", bump), ("bump_right", -bump), ("steer", steer)]);
            let one = corner.moved(&[("bump", bump), ("steer", steer)]);
            for point in [
                "lower_ball",
                "upper_ball",
                "tie_ball",
                "wheel_centre",
                "axle",
            ] {
                let off = both.at(&format!("left_{point}")) - one.at(point);
                assert!(off.norm() < CLOSE, "{point}");
            }
        }
    }
}

#[test]
fn mirrored_drives_give_the_mirrored_motion() {
    let layout = Layout::read("steered_axle");
    for bump in TRAVEL {
        for steer in RACK {
            let one = [("bump_left", bump), ("bump_right", 0.01), ("steer", steer)];
            let other = [("bump_left", 0.01), ("bump_right", bump), ("steer", -steer)];
            assert!(layout.moved(&one).off_mirrored(&layout.moved(&other)) < CLOSE);
        }
    }
}

#[test]
fn the_rack_slides_without_turning() {
    let layout = Layout::read("steered_axle");
    for steer in RACK {
        let pose = layout.moved(&[("steer", steer), ("bump_left", 0.06)]);
        for end in ["rack_left", "rack_right"] {
            let by = pose.at(end) - layout.at(end);
            assert!(by.x.abs() < CLOSE && by.z.abs() < CLOSE && (by.y - steer).abs() < CLOSE);
        }
    }
}

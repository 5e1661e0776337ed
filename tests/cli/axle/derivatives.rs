//! Derivatives of the quantities of an axle against differences.

use super::{DESIGN, assert_near, steered, table};

/// First and second derivatives by each drive, at a place of no symmetry.
fn check_derivatives(names: &[&str], step: f64) {
    let centre = [("bump_left", 0.02), ("bump_right", -0.01), ("steer", 0.028)];
    for moved in ["bump_left", "bump_right", "steer"] {
        let drives = centre.map(|(drive, at)| {
            if drive == moved {
                format!("--drive={drive}={}:{}:3", at - step, at + step)
            } else {
                format!("--drive={drive}={at}")
            }
        });
        let [a, b, c] = drives.each_ref().map(String::as_str);
        let rows = table(&steered(DESIGN), &["sweep", "--derivatives", "2", a, b, c]);
        let [before, middle, after] = rows.as_slice() else {
            panic!("three places");
        };
        for name in names {
            let (none, first) = ((*name).to_owned(), format!("{name}_per_{moved}"));
            let second = format!("{first}2");
            for (of, derivative) in [(&none, &first), (&first, &second)] {
                let slope = (after[of] - before[of]) / (2.0 * step);
                let size = slope.abs().max(middle[of].abs()).max(1.0);
                assert_near(middle[derivative], slope, 2e-6 * size, derivative);
            }
        }
    }
}

#[test]
fn derivatives_of_axle_quantities_agree_with_differences() {
    let smooth = [
        "total_toe_rad",
        "track_m",
        "left_steer_angle_rad",
        "right_steer_angle_rad",
        "ackermann_error_rad",
        "left_roll_camber_rad_rad",
        "right_roll_camber_rad_rad",
        "left_roll_steer_rad_rad",
        "right_roll_steer_rad_rad",
    ];
    check_derivatives(&smooth, 2e-5);
    // These have poles nearby: where the axle is straight ahead, where both normals are parallel.
    let bent = [
        "ackermann_percent",
        "turning_radius_m",
        "axle_roll_centre_y",
        "axle_roll_centre_z",
    ];
    check_derivatives(&bent, 2e-6);
}

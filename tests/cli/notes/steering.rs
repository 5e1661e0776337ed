//! Notes on wheels that a drive of steering does not turn.

use super::notes;

/// Returns an axle whose rack ends are on the chassis: the drive moves the left one.
fn axle(rack: &str, vehicle: &str) -> String {
    format!(
        "unit = 'm'\nvehicle = {vehicle}\ntime = {{ instants = [0.0] }}\ndrives = {{ steer = 0.3 }}\nstatements = '''\nmirror: left -> right;\n\
         fixed: left_low at [0.0, 0.7, 0.2], left_high at [0.0, 0.68, 0.45], {rack}\n\
         free: left_ball at [-0.1, 0.65, 0.3], left_wheel_centre at [0.0, 0.78, 0.3];\n\
         hinge left_knuckle: left_low, left_high -> left_ball, left_wheel_centre;\npoint left_hub: left_knuckle at [0.0, 0.74, 0.3];\n\
         link left_tie_rod: left_rack -> left_ball;\ndrive steer: left_rack.y;\nwheel left: left_hub -> left_wheel_centre;\n'''\n"
    )
}

#[test]
fn a_wheel_that_steering_does_not_turn_is_noted() {
    let ends = "left_rack at [-0.1, 0.3, 0.3];";
    let message = notes(&axle(ends, "{}"));
    let expected = "note: a.toml: the drive `steer` turns the left wheel and not the right wheel: to steer both it moves one end of a rack";
    assert!(message.starts_with(expected), "{message}");
    let stated = notes(&axle(ends, "{ steer = { left = 'steer' } }"));
    assert_eq!(stated, "");
    let joined = "left_house at [-0.1, 0.1, 0.3];\nfree: left_rack at [-0.1, 0.3, 0.3];\n\
                  slide left_guide: left_rack on right_house -> left_house;\nlink rack: left_rack -> right_rack;";
    assert_eq!(notes(&axle(joined, "{}")), "");
}

//! What a listing expands to where a program depends on the core under another name.
#![deny(warnings)]

use kinematics::Build;
use kinematics::nalgebra::Vector3;

kinematics::linkage! {
    /// A crank whose pin slides.
    pub mod crank {
        fixed: pin;
        free:  end;
        link arm: pin -> end;
        drive turn:  angle(pin -> end, z);
        drive slide: end.x;
    }
}

#[test]
fn a_listing_names_the_core_as_the_program_does() {
    let design = crank::Points {
        pin: Vector3::zeros(),
        end: Vector3::new(0.0, 0.3, 0.4),
    };
    let model = crank::Model::new(&design).expect("a model");
    assert_eq!(model.lengths().arm, 0.5);
}

//! The expansion of a listing in a program that depends on the core under another name.
#![deny(warnings)]

/// Macros of a program do not get in the way of those that a listing expands to.
#[allow(unused_macros)]
macro_rules! vector {
    ($($_:tt)*) => {
        compile_error!("not the program's")
    };
}

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

kinematics::linkage! {
    pub mod r#type;
}

#[test]
fn the_file_of_a_raw_module_name_has_no_mark() {
    assert_eq!(r#type::Listing::PARTS.drives, ["turn", "slide"]);
}

#[test]
fn linkage_finds_the_core_under_another_name() {
    let design = crank::Points {
        pin: Vector3::zeros(),
        end: Vector3::new(0.0, 0.3, 0.4),
    };
    let model = crank::Model::new(&design).expect("a model");
    assert_eq!(model.lengths().arm, 0.5);
}

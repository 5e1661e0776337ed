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
fn a_module_that_is_a_word_of_rust_has_a_file_without_the_mark() {
    assert_eq!(r#type::Listing::PARTS.drives, ["turn", "slide"]);
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

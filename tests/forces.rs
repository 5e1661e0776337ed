//! Forces that cannot be borne.

use suspension_core::SolveError;
use suspension_core::linkages::double_wishbone::{Corner, Points};
use suspension_core::listing::{Part, Parts};
use suspension_core::nalgebra::Vector3;
use suspension_core::statics::Loads;

/// Both ways to load the design; either the drive that bears a force, or the part whose force is refused.
fn steer_under(forces: &Points) -> [Result<f64, Part>; 2] {
    let corner: Corner = Corner::design().expect("a regular design");
    let (model, position) = (corner.model(), &corner.motion().position);
    let statics = corner.statics().expect("no lock at the design");
    let loaded = [
        statics.under(forces),
        Loads::new(model, corner.drives(), position, forces),
    ];
    loaded.map(|loads| match loads {
        Ok(loads) => Ok(loads.on_drives().steer),
        Err(SolveError::Overflow { part }) => Err(part),
        Err(other) => panic!("{other}"),
    })
}

/// A force on a free point is borne by the equations; the first that has no finite number is the first link here.
#[test]
fn what_is_not_finite_at_a_free_point_is_refused_at_an_equation() {
    let corner: Corner = Corner::design().expect("a regular design");
    let lower_ball = Vector3::new(0.0, 0.0, f64::NAN);
    for refused in steer_under(&Points {
        lower_ball,
        ..Points::default()
    }) {
        let part = refused.expect_err("no force");
        assert_eq!(part, Part::Equation(0));
        let message = SolveError::<f64>::Overflow { part }
            .named(corner.model())
            .to_string();
        assert_eq!(
            message,
            "a correction, velocity, acceleration or force is not a finite number: equation `lower_fore`; \
             look at the inputs and their rates, or at the forces"
        );
    }
}

/// The force on the rack is in no equation: its drive alone bears it.
#[test]
fn what_is_not_finite_at_a_driven_chassis_point_is_refused_at_its_drive() {
    let corner: Corner = Corner::design().expect("a regular design");
    for force in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let rack = Vector3::new(0.0, force, 0.0);
        for refused in steer_under(&Points {
            rack,
            ..Points::default()
        }) {
            let part = refused.expect_err("no force");
            assert_eq!(corner.model().name(part), "steer", "{part:?}");
        }
    }
    let rack = Vector3::new(0.0, 300.0, 0.0);
    assert_eq!(
        steer_under(&Points {
            rack,
            ..Points::default()
        }),
        [Ok(300.0); 2]
    );
}

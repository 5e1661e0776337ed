//! The work of forces at points on the drives, and forces that cannot be borne.

use suspension_core::linkages::double_wishbone::{Corner, Points};
use suspension_core::linkages::{double_wishbone_pushrod, five_link};
use suspension_core::listing::{Part, Parts};
use suspension_core::nalgebra::Vector3;
use suspension_core::statics::Loads;
use suspension_core::{Linkage, SolveError, Values};

use crate::support::five_link_rough;

/// Both ways to load the design; either the drive that bears a force, or the part whose force is refused.
fn steer_under(forces: &Points) -> [Result<f64, Part>; 2] {
    let corner: Corner = Corner::design().expect("a regular design");
    let (model, position) = (corner.model(), &corner.motion().position);
    let statics = corner.statics().expect("no lock at the design");
    let loaded = [
        statics.under(forces).map_err(|failure| failure.error),
        Loads::new(model, corner.drives(), position, forces),
    ];
    loaded.map(|loads| match loads {
        Ok(loads) => Ok(loads.on_drives().steer),
        Err(SolveError::Overflow { part }) => Err(part),
        Err(other) => panic!("{other}"),
    })
}

/// What bears such a force, an equation, a drive or the body of a marker, says less than the point at which it acts.
#[test]
fn a_force_that_is_not_finite_is_refused_at_its_point() {
    let corner: Corner = Corner::design().expect("a regular design");
    for force in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let force = Vector3::new(0.0, force, 0.0);
        let (none, at) = (Points::default(), corner.model());
        for (forces, point) in [
            (
                Points {
                    lower_ball: force,
                    ..none
                },
                "lower_ball",
            ),
            (
                Points {
                    rack: force,
                    ..none
                },
                "rack",
            ),
            (
                Points {
                    axle: force,
                    ..none
                },
                "axle",
            ),
        ] {
            let [by_statics, by_loads] = steer_under(&forces);
            assert_eq!(at.name(by_statics.expect_err("no force")), point);
            assert!(
                matches!(by_loads, Err(Part::Equation(_) | Part::Drive(_))),
                "{point}"
            );
        }
    }
}

/// The lever of the rocker multiplies the force on the damper.
#[test]
fn a_force_that_is_too_large_is_refused_by_the_name_of_what_bears_it() {
    let corner: double_wishbone_pushrod::Corner =
        double_wishbone_pushrod::Corner::design().expect("a regular design");
    let forces = double_wishbone_pushrod::Points {
        damper_outer: Vector3::new(f64::MAX, f64::MAX, f64::MAX),
        ..Default::default()
    };
    let refused = corner.statics().expect("no lock").under(&forces);
    let message = refused.err().expect("too large").to_string();
    let expected = "force is not a finite number: equation `";
    assert!(message.contains(expected), "{message}");
}

/// The force on the rack is in no equation: its drive alone bears it.
#[test]
fn the_drive_of_a_chassis_point_bears_a_force_there() {
    let rack = Vector3::new(0.0, 300.0, 0.0);
    assert_eq!(
        steer_under(&Points {
            rack,
            ..Points::default()
        }),
        [Ok(300.0); 2]
    );
}

suspension_core::linkage! {
    /// A body on a chassis point that a drive moves, so that this point carries a marker too.
    mod raised {
        fixed: anchor at [0.0, 0.3, 0.5], fore at [0.3, 0.4, 0.2], aft at [-0.3, 0.35, 0.25];
        free:  foot at [0.0, 0.6, 0.2], knee at [0.1, 0.5, 0.4];
        body leg: anchor, foot, knee;
        point mark: leg at [0.05, 0.5, 0.32];
        link lower: fore -> foot;
        link upper: aft -> knee;
        drive bump:  foot.z;
        drive level: anchor.y;
    }
}

/// Each drive bears the work of the forces at all points, markers included, per unit of the drive.
fn check_work<L, const N: usize>(corner: &suspension_core::Corner<L, N>)
where
    L: Linkage<N, Scalar = f64>,
{
    let (model, position) = (corner.model(), &corner.motion().position);
    let force = |x: usize| Vector3::new(1.0, -2.0, 3.0) * (x as f64 * 1.7).sin();
    let forces = L::Points::from_values((1..=64).map(force));
    let by_statics = corner
        .statics()
        .map_err(drop)
        .expect("no lock")
        .under(&forces)
        .map_err(|failure| failure.error);
    let loads = Loads::new(model, corner.drives(), position, &forces);
    for loads in [by_statics, loads] {
        let on_drives = loads.expect("finite forces").on_drives();
        for (drive, borne) in on_drives.values().enumerate() {
            let change = L::Drives::default().with(drive, 1.0);
            let moved = corner
                .per(change)
                .map_err(drop)
                .expect("no lock")
                .points
                .rate;
            let works = moved.values().zip(forces.values());
            let work: f64 = works.map(|(moved, force)| moved.dot(&force)).sum();
            assert!(
                (borne - work).abs() < 1e-10,
                "drive {drive}: {borne}, {work}"
            );
        }
    }
}

#[test]
fn drives_bear_the_work_of_forces_at_markers() {
    check_work(&five_link::Corner::<f64>::new(&five_link_rough()).expect("a geometry"));
    check_work(&double_wishbone_pushrod::Corner::<f64>::design().expect("a geometry"));
    check_work(&raised::Corner::<f64>::design().expect("a geometry"));
}

/// The forces of statements are sums of those of their equations, chassis points first.
#[test]
fn forces_of_each_equation_sum_to_those_of_statements() {
    use double_wishbone_pushrod::{Corner, Points};
    let corner: Corner = Corner::design().expect("a regular design");
    let forces = Points {
        wheel_centre: Vector3::new(-3000.0, 500.0, 4000.0),
        ..Points::default()
    };
    let statics = corner.statics().expect("no lock at the design");
    let loads = statics.under(&forces).expect("finite forces");
    let each: Vec<_> = loads.by_equation().collect();
    let equations = corner.motion().position.len();
    assert_eq!(each.len(), 10 + 9, "chassis points and free points");
    for rows in [0..1, 3..7, 0..equations] {
        let by = loads.by(rows.clone());
        for (by, each) in by.values().zip(&each) {
            let sum = each
                .each_ref()
                .map(|along| along.as_slice()[rows.clone()].iter().sum());
            assert!((by - Vector3::from(sum)).norm() <= 1e-9, "{rows:?}");
        }
    }
}

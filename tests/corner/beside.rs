//! Corners whose points do not satisfy the listing.

use nalgebra::Vector3;
use suspension_core::linkage::Designed;
use suspension_core::{Signal, SolveError, linkage};

linkage! {
    /// A slider beside its line, and a point on a link from it.
    mod slider {
        fixed: top at [0.0, 0.0, 1.0], bottom at [0.0, 0.0, 0.0], post at [0.0, 0.6, 0.0];
        free:  shoe at [0.005, 0.0, 0.4], tip at [0.0, 0.6, 0.5];
        slide rail: shoe on bottom -> top;
        link rod:  shoe -> tip;
        link prop: post -> tip;
        drive height: shoe.z;
        drive along:  tip.x;
    }
}

use slider::{Corner, Drives, Model, Points};

/// Before the first step they are those of the configuration to which it moves the points.
#[test]
fn ratios_and_loads_of_a_point_beside_its_slide_are_those_on_it() {
    let corner = Corner::<f64>::design().expect("regular");
    let mut stepped = corner;
    let still = Signal::still(corner.drives());
    stepped.step(0.0, still).expect("near by");
    let one = Drives {
        height: 1.0,
        along: 0.0,
    };
    let [before, after] = [&corner, &stepped].map(|corner| {
        let points = corner.per(one).expect("regular").points;
        let forces = Points {
            tip: Vector3::new(0.0, 10.0, 20.0),
            ..Points::default()
        };
        let loads = corner.statics().expect("regular").under(&forces);
        (
            points.value.shoe,
            points.rate,
            loads.expect("finite").on_drives(),
        )
    });
    assert_eq!(before, after);
    assert!(before.0.x.abs() < 1e-15 && corner.points().value.shoe.x == 0.005);
}

#[test]
fn ratios_and_loads_far_from_any_configuration_are_refused() {
    let mut far: Points<f64> = Model::design();
    far.shoe.x = 0.2;
    let corner = Corner::new(&far).expect("regular");
    let one = Drives {
        height: 1.0,
        along: 0.0,
    };
    let derived = corner.per(one).expect_err("far away").error;
    let loaded = corner.statics().err().map(|failure| failure.error);
    assert!(matches!(derived, SolveError::Diverging { .. }), "{derived}");
    assert_eq!(loaded, Some(derived));
}

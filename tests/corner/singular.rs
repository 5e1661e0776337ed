//! Designs at which the equations do not determine the motion.

use nalgebra::Vector3;
use suspension_core::linkage::Designed;
use suspension_core::{Build, GeometryError, Signal, linkage};
use suspension_runtime::{Listing, ModelError};

linkage! {
    /// An arm at the end of its reach along y, which drives it.
    mod stretched {
        fixed: hinge at [0.0, 0.0, 0.0];
        free:  tip at [0.0, 0.5, 0.0];
        link arm: hinge -> tip;
        drive along: tip.x;
        drive across: tip.y;
    }
}

/// The same listing for the back end at run time.
const STRETCHED: &str = "
    fixed: hinge at [0.0, 0.0, 0.0];
    free:  tip at [0.0, 0.5, 0.0];
    link arm: hinge -> tip;
    drive along: tip.x;
    drive across: tip.y;
";

#[test]
fn a_design_at_a_lock_is_refused_by_name_when_it_is_built() {
    let refused = stretched::Corner::<f64>::design().expect_err("at a lock");
    assert_eq!(refused.error, GeometryError::Singular { unknown: 2 });
    let message = refused.to_string();
    assert!(
        message.contains("unknown `tip.z`; state hardpoints away"),
        "{message}"
    );
    let listing = Listing::parse(STRETCHED).expect("valid");
    let mut design = listing.design().expect("a design");
    let refused = listing.corner::<15>(&design).expect_err("at a lock");
    assert!(matches!(&refused, ModelError::Geometry { message: same, .. } if *same == message));
    // At the lock there is a model, which may be assembled elsewhere.
    listing.model::<15>(&design).expect("a geometry");
    design[1] = Vector3::new(0.0, 0.5, 1e-6);
    listing.corner::<15>(&design).expect("near the lock");
}

#[test]
fn a_corner_is_made_where_it_can_stand() {
    let listing = Listing::parse(STRETCHED).expect("valid");
    let mut design = stretched::Model::<f64>::design();
    let made = (-50..-20).map(|quarter| {
        design.tip.z = 10_f64.powf(f64::from(quarter) / 4.0);
        let model = stretched::Model::new(&design).expect("a geometry");
        let mut unchecked = stretched::Corner::of(model, &design);
        let still = Signal::still(unchecked.drives());
        let stands = unchecked.step(1e-3, still).is_ok();
        let at_run_time = listing.corner::<15>(&[design.hinge, design.tip]);
        let made = [stretched::Corner::new(&design).is_ok(), at_run_time.is_ok()];
        assert_eq!(made, [stands; 2], "{:e}", design.tip.z);
        stands
    });
    let made: Vec<bool> = made.collect();
    assert!(made.is_sorted() && made.contains(&false) && made.contains(&true));
}

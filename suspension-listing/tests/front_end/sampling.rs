//! The Jacobian's numbers in the design position against the compiled linkages of the catalogue.

use nalgebra::Vector3;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::{Build, Values};
use suspension_listing::sample;
use suspension_listing::system::Positions;

use super::{catalogue_system, lower, positions};

/// Compares every entry of the sampled Jacobian with the one that the model computes.
fn compare<L: Build<15, Scalar = f64, Listing: Default>>(name: &str) {
    let system = catalogue_system(name);
    let stated = system.fixed.iter().chain(&system.free);
    let stated: Vec<_> = stated.filter_map(|point| point.at).collect();
    // Markers need no design position.
    let design = L::Points::from_values(stated.into_iter().map(Vector3::from));
    let model = L::new(&design).expect("a geometry");
    let mut jacobian = model.jacobian(&model.unknowns(&design), model.fixed());
    for entry in sample::entries(&system, &positions(&system)) {
        let value = entry.values[0];
        let exact = std::mem::take(&mut jacobian[(entry.row, entry.column)]);
        assert!((value - exact).abs() < 1e-13, "{entry:?}, but {exact}");
        assert!(!entry.unit || exact == 1.0, "{entry:?}, but {exact}");
    }
    assert_eq!(jacobian.amax(), 0.0, "the pattern names every entry");
}

#[test]
fn jacobian_entries_of_attia2003_match_the_compiled_linkage() {
    compare::<attia2003::Model<f64>>("attia2003");
}

#[test]
fn jacobian_entries_of_five_link_match_the_compiled_linkage() {
    compare::<five_link::Model<f64>>("five_link");
}

/// Positions along the motion keep every length, to a few parts in a hundred.
#[test]
fn sampled_positions_along_the_drive_keep_the_lengths() {
    let system = catalogue_system("five_link");
    let positions = positions(&system);
    assert!(positions.len() > 5, "{} positions", positions.len());
    // From the upper front to the upper rear outer point.
    let length = |position: &Positions| {
        let [a, b] = [1, 2].map(|index| Vector3::from(position.free[index]));
        (a - b).norm()
    };
    for position in &positions {
        let drift = length(position) / length(&positions[0]) - 1.0;
        assert!(drift.abs() < 5e-2, "{drift}");
    }
}

#[test]
fn a_listing_with_a_point_without_position_has_no_design() {
    let listing = quote::quote! {
        mod bar {
            fixed: a at [0.0, 0.0, 0.0];
            free: p;
            link bar: a -> p;
            drive y: p.y;
            drive z: p.z - a.z;
        }
    };
    assert!(lower(listing).0.design().is_none());
}

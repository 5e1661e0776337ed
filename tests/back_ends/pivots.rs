//! Hardpoints at which a pivot of the fixed elimination order is zero: both back ends report the pivot when the model is built.

use nalgebra::Vector3;
use suspension_core::linkages::{LISTINGS, attia2003};
use suspension_core::step::bounded::Outputs;
use suspension_core::{Bounded, Build, Corner, Inputs, Motion, Signal, Still, Values};
use suspension_runtime::Listing;

type Model = attia2003::Model<f64>;
type Points = attia2003::Points<f64>;

fn listing() -> Listing {
    let text = LISTINGS.iter().find(|(name, _)| *name == "attia2003");
    Listing::parse(text.expect("in the catalogue").1).expect("a listing")
}

/// Link 6-1 square to x or y, along which its derivative is the pivot that the design chose.
fn square(listing: &Listing, link: Vector3<f64>) -> Points {
    let design = Points::from_values(listing.stated().map(|(_, at)| at));
    Points {
        p6: design.p1 + link,
        ..design
    }
}

/// A step of no length at the design.
fn attempt<L: Build<N, Scalar = f64>, const N: usize>(model: &L, design: &L::Points) -> bool {
    let inputs: Inputs<Still, _> = Inputs::still(Signal::still(model.drives_at(design)));
    let mut motion = Motion::at_rest(model.unknowns(design));
    let bounded = Bounded::<f64>::default();
    let attempted = bounded.attempt(Outputs::Acceleration, model, &inputs, 0.0, &mut motion);
    attempted.is_ok()
}

const MESSAGE: &str = "the fixed order of elimination has too small a pivot at these hardpoints: \
    equation `d6_1`; state hardpoints near these in the listing, or step with partial pivoting";

#[test]
fn building_a_model_names_a_zero_pivot_at_the_design() {
    let listing = listing();
    let links = [Vector3::new(0.0, 0.43, 0.11), Vector3::new(0.43, 0.0, 0.11)];
    let messages = links.map(|link| {
        let design = square(&listing, link);
        let points: Vec<Vector3<f64>> = design.values().collect();
        let written = Corner::<Model, 15>::new(&design).map_err(|error| error.to_string());
        let walked = listing
            .model::<15>(&points)
            .map_err(|error| error.to_string());
        let model = Model::of(attia2003::Listing, &design).expect("a geometry");
        let attempted = attempt(&model, &design);
        let ordered = listing.clone().ordered_at(&points);
        let reordered = ordered.model::<15>(&points).expect("an order for them");
        let design = Values::from_values(points.iter().copied());
        assert!(attempt(&reordered, &design));
        let messages = written.err();
        assert_eq!(messages, walked.err());
        assert_eq!(messages.is_none(), attempted);
        messages
    });
    assert_eq!(messages.iter().flatten().collect::<Vec<_>>(), [MESSAGE]);
}

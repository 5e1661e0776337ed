//! A failure says what happened, where by name, by how much, and what to do.

use suspension_core::linkages::double_wishbone::{self, Corner};
use suspension_core::linkages::five_link;
use suspension_core::listing::Part;
use suspension_core::step::bounded::Refusal;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Build, GeometryError, Inputs, Signal, SolveError, Tracker};

use super::support;

#[test]
fn a_refused_step_names_the_unknown_and_the_inequality() {
    let error = SolveError::<f64>::Diverging {
        part: Part::Unknown(2),
        step: 1.0,
        bound: 0.25,
    };
    assert_eq!(
        error.named(five_link::Listing).to_string(),
        "there is no configuration near by: the correction is too large: unknown \
         `lower_front_outer.z`, correction 1.000000, allowed 0.250000; take shorter steps, or assemble"
    );
    assert!(error.to_string().contains("unknown 2, correction"));
}

#[test]
fn a_geometry_names_the_point_and_the_remedy() {
    let error = GeometryError::Flat { point: 9 };
    let told = error.named(five_link::Listing).to_string();
    assert!(told.contains("point `track_rod_outer`"), "{told}");
    assert!(told.contains("state these points as a `body`"), "{told}");
}

#[test]
fn parts_that_do_not_fit_together_are_told_so() {
    let corner: Corner = Corner::design().expect("a design");
    let lengths = double_wishbone::Lengths {
        tie_rod: 5.0,
        ..corner.model().lengths()
    };
    let model = corner.model().with_lengths(&lengths).expect("a model");
    let failed = Corner::assembled(model, &corner.points().value);
    let told = failed.map(|_| ()).expect_err("no assembly").to_string();
    assert!(
        told.ends_with("; in assembling, see that lengths and drives fit together"),
        "{told}"
    );
}

#[test]
fn an_advance_says_how_far_it_came_and_a_model_gives_names_too() {
    let model = support::five_link_model::<f64>();
    let mut motion = support::five_link_start(&model);
    let beyond = |t: f64| {
        Inputs::still(Signal {
            value: five_link::Drives { theta: 0.7 + t },
            rate: five_link::Drives { theta: 1.0 },
            second_rate: five_link::Drives::default(),
        })
    };
    let stopped: Stopped<f64> = Tracker::default()
        .advance(&model, beyond, 0.0, 2.0, &mut motion)
        .expect_err("a lock at 2.178 rad");
    let told = stopped.named(&model).to_string();
    assert!(told.starts_with("stopped at time 1.478"), "{told}");
    assert!(told.contains(": unknown `"), "{told}");
}

#[test]
fn an_advance_whose_steps_were_shortened_in_vain_does_not_ask_for_shorter_ones() {
    let refused = SolveError::<f64>::Diverging {
        part: Part::Unknown(2),
        step: 1.0,
        bound: 0.25,
    };
    let stopped = Stopped {
        reached: 0.75,
        refused: Some((1e-16, refused)),
    };
    assert_eq!(
        stopped.named(five_link::Listing).to_string(),
        "stopped at time 0.75: there is no configuration near by: the correction is too large: unknown \
         `lower_front_outer.z`, correction 1.000000, allowed 0.250000; shorter steps lead no further: the mechanism locks \
         here, or the drives jump"
    );
}

#[test]
fn a_refusal_is_a_sentence() {
    let told = Refusal::Unhealthy.to_string();
    assert!(told.contains("pivots") && told.contains("; "), "{told}");
}

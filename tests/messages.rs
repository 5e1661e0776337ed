//! A failure says what happened, where by name, by how much, and what to do.

use suspension_core::linkages::double_wishbone::{self, Corner};
use suspension_core::linkages::five_link;
use suspension_core::listing::Part;
use suspension_core::step::bounded::Refusal;
use suspension_core::step::stepper::Stopped;
use suspension_core::{Bounded, Build, GeometryError, Inputs, Signal, SolveError, Tracker};

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
fn a_geometry_error_names_the_point_and_the_remedy() {
    let error = GeometryError::Flat { point: 9 };
    let message = error.named(five_link::Listing).to_string();
    assert!(message.contains("point `track_rod_outer`"), "{message}");
    assert!(
        message.contains("state these points as a `body`"),
        "{message}"
    );
}

#[test]
fn lengths_that_do_not_fit_together_are_reported() {
    let corner: Corner = Corner::design().expect("a design");
    let lengths = double_wishbone::Lengths {
        tie_rod: 5.0,
        ..corner.model().lengths()
    };
    let model = corner.model().with_lengths(&lengths).expect("a model");
    let failed = Corner::assembled(model, &corner.points().value);
    let message = failed.map(|_| ()).expect_err("no assembly").to_string();
    assert!(
        message.ends_with("; in assembling, see that lengths and drives fit together"),
        "{message}"
    );
}

#[test]
fn a_first_bounded_step_from_points_that_are_no_configuration_says_to_assemble() {
    let corner: Corner = Corner::design().expect("a design");
    let inputs = Inputs::still(corner.drive_signal());
    let mut motion = *corner.motion();
    motion.position[double_wishbone::unknown::TIE_BALL_Y] += 1e-3;
    let refused = Bounded::<f64>::default().step(corner.model(), &inputs, 0.0, &mut motion);
    let message = refused.expect_err("no configuration").to_string();
    assert!(
        message.contains("or assemble a start that is no configuration"),
        "{message}"
    );
}

#[test]
fn a_stopped_advance_reports_its_progress_and_names_of_parts() {
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
    let message = stopped.named(&model).to_string();
    assert!(message.starts_with("stopped at time 1.478"), "{message}");
    assert!(message.contains(": unknown `"), "{message}");
}

#[test]
fn a_stopped_advance_does_not_ask_for_shorter_steps() {
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
        "stopped at time 0.750000 s: there is no configuration near by: the correction is too large: unknown \
         `lower_front_outer.z`, correction 1.000000, allowed 0.250000; shorter steps lead no further: the mechanism locks \
         here, the drives jump, or the start is no configuration: assemble it"
    );
}

suspension_core::linkage! {
    mod off_the_line {
        fixed: low at [0.0, 0.0, 0.0], high at [0.0, 0.0, 1.0];
        free:  slider at [0.03, 0.0, 0.4];
        slide guide: slider on low -> high;
        drive lift: slider.z;
    }
}

/// A point 30 mm beside the line on which it slides: neither a lock nor a jump of the drives.
#[test]
fn a_first_step_from_points_off_a_slide_asks_to_assemble_them() {
    use off_the_line::{Corner, Model};
    use suspension_core::linkage::Designed;
    let mut corner: Corner = Corner::design().expect("a model");
    let drives = Signal::still(corner.drives());
    let message = corner
        .step(1e-3, drives)
        .map(|_| ())
        .expect_err("points off the line")
        .to_string();
    assert!(
        message.ends_with("or the start is no configuration: assemble it"),
        "{message}"
    );

    let mut assembled = Corner::assembled(*corner.model(), &Model::design()).expect("an assembly");
    assert!(assembled.step(1e-3, drives).is_ok());
}

#[test]
fn a_refusal_has_a_message_with_a_remedy() {
    let message = Refusal::Unhealthy.to_string();
    assert!(
        message.contains("pivots") && message.contains("; "),
        "{message}"
    );
}

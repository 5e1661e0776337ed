//! A four-bar in the y-z plane, held there by drives: its coupler is where two circles meet.

use nalgebra::Vector3;
use suspension_core::Build;

use super::checks;

suspension_core::linkage! {
    /// Crank, coupler and rocker; the crank is turned, and all of it slid along x.
    pub(crate) mod four_bar {
        fixed: crank_pin, rocker_pin;
        free:  crank_end, rocker_end;
        link crank:   crank_pin -> crank_end;
        link coupler: crank_end -> rocker_end;
        link rocker:  rocker_pin -> rocker_end;
        drive turn:   angle(crank_pin -> crank_end, z);
        drive slide:  crank_end.x;
        drive align:  rocker_end.x - crank_end.x;
    }
}

use four_bar::{Drives, Lengths, Model, Points};

const LENGTHS: Lengths<f64> = Lengths {
    crank: 0.2,
    coupler: 0.5,
    rocker: 0.4,
};

/// The upper of the two assemblies.
fn closed_form(turn: f64) -> Points<f64> {
    let (crank_pin, rocker_pin) = (Vector3::zeros(), Vector3::new(0.0, 0.6, 0.1));
    let crank_end = LENGTHS.crank * Vector3::new(0.0, turn.sin(), turn.cos());
    let base = rocker_pin - crank_end;
    let Lengths {
        coupler, rocker, ..
    } = LENGTHS;
    let along = (base.norm_squared() + coupler * coupler - rocker * rocker) / (2.0 * base.norm());
    let across = (coupler * coupler - along * along).sqrt();
    let unit = base.normalize();
    let rocker_end = crank_end + unit * along + Vector3::x().cross(&unit) * across;
    Points {
        crank_pin,
        rocker_pin,
        crank_end,
        rocker_end,
    }
}

#[test]
fn a_four_bar_closes_where_two_circles_intersect() {
    let model = Model::new(&closed_form(1.0)).and_then(|model| model.with_lengths(&LENGTHS));
    let model = model.expect("a four-bar");
    for turn in [0.4, 0.8, 1.3, 1.9, 2.6] {
        let expected = closed_form(turn);
        let drives = Drives {
            turn,
            slide: 0.0,
            align: 0.0,
        };
        let solved = checks::solve(&model, &closed_form(turn - 0.05), drives);
        assert!(
            checks::largest_distance(&solved, &expected) < 1e-14,
            "at {turn} rad"
        );
        assert!((model.drives_at(&solved).turn - turn).abs() < 1e-14);
    }
}

#[test]
fn lengths_of_a_four_bar_are_those_of_its_design() {
    let model = Model::new(&closed_form(1.0)).expect("a four-bar");
    let Lengths {
        crank,
        coupler,
        rocker,
    } = model.lengths();
    assert!((crank - LENGTHS.crank).abs() < 1e-15);
    assert!((coupler - LENGTHS.coupler).abs() < 1e-15);
    assert!((rocker - LENGTHS.rocker).abs() < 1e-15);
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    let design = closed_form(1.0);
    let model = Model::new(&design).expect("a four-bar");
    checks::derivatives_and_motion(&model, &design, 0.05);
}

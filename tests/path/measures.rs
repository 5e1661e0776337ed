//! The leading quantity is chosen at run time among the measures of a listing.

use nalgebra::Vector3;
use suspension_core::linkage::Named;
use suspension_core::path::{Curve, Leader, Led, measured};
use suspension_core::{Build, Inputs, Linkage, Newton, Real, Signal, Still, Values};

suspension_core::linkage! {
    /// A four-bar whose crank cannot turn fully.
    mod rocking {
        fixed: crank_pin, rocker_pin;
        free:  crank_end, rocker_end;
        link crank:   crank_pin -> crank_end;
        link coupler: crank_end -> rocker_end;
        link rocker:  rocker_pin -> rocker_end;
        drive turn:   angle(crank_pin -> crank_end, z);
        drive slide:  crank_end.x;
        drive align:  rocker_end.x - crank_end.x;
        measure reach:  rocker_end.y;
        measure spring: length(crank_pin -> rocker_end);
        measure swing:  angle(rocker_pin -> rocker_end, z);
    }
}

use rocking::{Drives, Measures, Model, Points};

/// Coupler and rocker nearly in line: beyond, the crank locks.
fn design() -> Points<f64> {
    Points {
        crank_pin: Vector3::zeros(),
        rocker_pin: Vector3::new(0.0, 0.7, 0.0),
        crank_end: Vector3::new(0.0, 0.1, 0.5),
        rocker_end: Vector3::new(0.0, 0.4, 0.28),
    }
}

fn inputs<T: Real>(drives: Drives<T>) -> Inputs<Still, Drives<T>> {
    let none = Drives::default();
    Inputs::still(Signal {
        value: drives,
        rate: none,
        second_rate: none,
    })
}

#[test]
fn every_measure_leads_through_the_turning_point_of_the_crank() {
    let model = Model::new(&design()).expect("a four-bar");
    let inputs_at_start = inputs(model.drives_at(&design()));
    let start = model.unknowns(&design());
    let curve = Curve::new(&model, &inputs_at_start, 0).expect("a drive");
    let names = <Measures<f64> as Named<f64>>::NAMES;
    for (index, name) in names.iter().enumerate() {
        let quantity = measured(&model, index).expect("a measure");
        let mut led = Led::at_rest(&curve, &start).expect("regular");
        let from = quantity(&led.points(&model, &inputs_at_start)).value;
        // The rocker passes the line of the coupler.
        let rate = [-0.1, -0.1, 0.15][index];
        let target = |t: f64| Signal {
            value: from + rate * t,
            rate,
            second_rate: 0.0,
        };
        let mut turns = Vec::new();
        for step in 1..=40 {
            let [before, t] = [f64::from(step - 1), f64::from(step)].map(|t| t / 40.0);
            Leader::default()
                .advance(
                    &model,
                    |_| inputs_at_start,
                    quantity,
                    target,
                    [before, t],
                    &mut led,
                )
                .unwrap_or_else(|stopped| panic!("{name}: {stopped}"));
            let drive = led.drive(&model, &inputs_at_start);
            turns.push(drive.rate);
            // Driven there by the crank, the mechanism is the same.
            let mut drives = inputs_at_start.drives.value;
            drives.turn = drive.value;
            let mut q = led.configuration.value.unknowns;
            let led_there = q;
            if drive.rate.abs() > 1e-2 {
                Newton::near_by()
                    .solve(&model, &inputs(drives), &mut q)
                    .expect("the same configuration");
                assert!((q - led_there).amax() <= 1e-13, "{name} at {t}");
            }
        }
        let turned = turns
            .windows(2)
            .filter(|pair| pair[0] * pair[1] < 0.0)
            .count();
        assert_eq!(turned, 1, "{name}: {turns:?}");
    }
    assert!(measured(&model, names.len()).is_none());
}

/// The same mechanism in metres and in millimetres: whatever the unit and the precision, an angle
/// leads as well as a length, and comes as near to its target.
fn angle_leads<T: Real>(unit: f64, allowed: f64) {
    let metres = design();
    let points = metres.values().map(|p| (p * unit).map(T::constant));
    let design = Points::from_values(points);
    let model = Model::new(&design).expect("a four-bar");
    let inputs = inputs(model.drives_at(&design));
    let curve = Curve::new(&model, &inputs, 0).expect("a drive");
    let swing = measured(&model, 2).expect("a measure");
    let mut led = Led::at_rest(&curve, &model.unknowns(&design)).expect("regular");
    let from = swing(&led.points(&model, &inputs)).value;
    let rate = T::constant(0.15);
    let target = |t: T| Signal {
        value: from + rate * t,
        rate,
        second_rate: T::zero(),
    };
    for step in 1..=20 {
        let [before, t] = [step - 1, step].map(|t| T::constant(f64::from(t) / 20.0));
        Leader::default()
            .advance(&model, |_| inputs, swing, target, [before, t], &mut led)
            .unwrap_or_else(|stopped| panic!("in {unit}: {stopped:?}"));
        let found = swing(&led.points(&model, &inputs)).value;
        let off: f64 = (found - target(t).value).to_subset().expect("f64");
        assert!(off.abs() <= allowed, "in {unit}: off by {off} rad");
    }
}

#[test]
fn a_measured_angle_leads_in_any_unit_and_precision() {
    angle_leads::<f64>(1.0, 1e-14);
    angle_leads::<f64>(1e3, 1e-14);
    angle_leads::<f32>(1.0, 4e-6);
    angle_leads::<f32>(1e3, 4e-6);
}

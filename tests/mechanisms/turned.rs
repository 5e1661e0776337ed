//! Driven angles about axes: two arms on one axis, and a lever on a pin that an arm moves, against rotations in closed
//! form.

use nalgebra::{Rotation3, Unit, Vector3};
use suspension_core::certificate::Certifier;
use suspension_core::statics::Statics;
use suspension_core::step::series::{InputSeries, Jet, Series};
use suspension_core::{Build, Inputs, Linkage, Newton, Signal, Tangent, Values, assemble};

use super::checks;

suspension_core::linkage! {
    mod bar {
        fixed: rear, front;
        free:  left, right;
        hinge left_arm:  rear, front -> left;
        hinge right_arm: rear, front -> right;
        drive lift:  left.z;
        drive twist: angle(rear -> left, front -> right about rear -> front);
        measure seen: angle(rear -> left, front -> right about rear -> front);
    }
}

suspension_core::linkage! {
    mod lever {
        fixed: rear, front, post;
        free:  knee, pin, elbow, tip;
        hinge arm:   rear, front -> knee, pin, elbow;
        body lever:  knee, pin, tip;
        drive swing: angle(rear -> post, rear -> knee about rear -> front);
        drive steer: angle(knee -> elbow, pin -> tip about knee -> pin);
    }
}

fn bar() -> bar::Points<f64> {
    bar::Points {
        rear: Vector3::new(-0.2, 0.1, 0.3),
        front: Vector3::new(0.3, 0.15, 0.35),
        left: Vector3::new(-0.1, 0.4, 0.35),
        right: Vector3::new(0.25, 0.45, 0.3),
    }
}

/// The right arm turned about the axis by an angle from where it is in the design.
fn twisted(angle: f64) -> bar::Points<f64> {
    let design = bar();
    let axis = Unit::new_normalize(design.front - design.rear);
    let turn = Rotation3::from_axis_angle(&axis, angle);
    bar::Points {
        right: design.front + turn * (design.right - design.front),
        ..design
    }
}

/// Changes of an angle from the design, over more than half a turn either way, zero and half a turn among them.
fn changes(start: f64) -> impl Iterator<Item = f64> {
    let steps = (-22..=22).map(|step| 0.2 * f64::from(step));
    steps.chain([0.0, std::f64::consts::PI, -std::f64::consts::PI].map(move |at| at - start))
}

#[test]
fn a_bar_twists_by_more_than_half_a_turn_either_way() {
    let model = bar::Model::new(&bar()).expect("a bar");
    let again = model.with_lengths(&model.lengths()).expect("the same");
    let start = model.drives_at(&bar());
    for model in [model, again] {
        for change in changes(start.twist) {
            let drives = bar::Drives {
                twist: start.twist + change,
                ..start
            };
            let expected = twisted(change);
            checks::meets(&model, &twisted(0.97 * change), drives, &expected, 2e-14);
            let seen = model.measures(&Signal::still(expected)).value.seen;
            let turns = (seen - drives.twist) / std::f64::consts::TAU;
            assert!((turns - turns.round()).abs() < 1e-14, "{turns} turns");
        }
    }
}

#[test]
fn derivatives_and_motion_agree_with_differences() {
    for angle in [0.0, 0.5, 2.0, 3.0, -3.0] {
        let at = twisted(angle);
        let model = bar::Model::new(&at).expect("a bar");
        checks::derivatives_and_motion(&model, &at, 0.03);
    }
    let model = lever::Model::new(&lever()).expect("a lever");
    checks::derivatives_and_motion(&model, &lever(), 0.1);
}

fn lever() -> lever::Points<f64> {
    lever::Points {
        rear: Vector3::new(-0.2, 0.1, 0.3),
        front: Vector3::new(0.3, 0.15, 0.35),
        post: Vector3::new(0.0, 0.5, 0.4),
        knee: Vector3::new(-0.05, 0.5, 0.2),
        pin: Vector3::new(0.0, 0.45, 0.45),
        elbow: Vector3::new(0.2, 0.55, 0.25),
        tip: Vector3::new(0.1, 0.7, 0.4),
    }
}

#[test]
fn a_line_along_the_axis_of_its_angle_is_refused_with_the_end_of_the_axis() {
    let mut points = lever();
    points.post = (points.rear + points.front) / 2.0;
    let refused = lever::Model::new(&points).expect_err("no angle");
    assert_eq!(
        refused.named(&lever::Listing).to_string(),
        "a line has no length, or lies along the axis of its angle: point `front`; put its ends apart, or off the axis"
    );
}

/// The arm turned about the chassis' axis and the lever about the arm's, by angles from the design that change.
fn turned(swing: Signal<f64>, steer: Signal<f64>) -> Signal<lever::Points<f64>> {
    let design = lever();
    let axis = Unit::new_normalize(design.front - design.rear);
    let pin = Unit::new_normalize(design.pin - design.knee);
    let of_arm = Rotation3::from_axis_angle(&axis, swing.value);
    let of_lever = of_arm * Rotation3::from_axis_angle(&pin, steer.value);
    let pin = of_arm * pin.into_inner();
    let omega = axis.into_inner() * swing.rate;
    let alpha = axis.into_inner() * swing.second_rate;
    let lever_omega = omega + pin * steer.rate;
    let lever_alpha = alpha + omega.cross(&pin) * steer.rate + pin * steer.second_rate;
    let moved = |[at, rate, second]: [Vector3<f64>; 3],
                 arm: Vector3<f64>,
                 [omega, alpha]: [Vector3<f64>; 2]| {
        let turning = omega.cross(&arm);
        [
            at + arm,
            rate + turning,
            second + alpha.cross(&arm) + omega.cross(&turning),
        ]
    };
    let zero = Vector3::zeros();
    let hinge = [design.rear, zero, zero];
    let on_arm = |point| moved(hinge, of_arm * (point - design.rear), [omega, alpha]);
    let [knee, pin, elbow] = [design.knee, design.pin, design.elbow].map(on_arm);
    let arm = of_lever * (design.tip - design.knee);
    let tip = moved(knee, arm, [lever_omega, lever_alpha]);
    let part = |order: usize| lever::Points {
        knee: knee[order],
        pin: pin[order],
        elbow: elbow[order],
        tip: tip[order],
        ..lever::Points::from_values([])
    };
    let value = lever::Points {
        rear: design.rear,
        front: design.front,
        post: design.post,
        ..part(0)
    };
    Signal {
        value,
        rate: part(1),
        second_rate: part(2),
    }
}

fn starting_at(start: f64, change: Signal<f64>) -> Signal<f64> {
    Signal {
        value: start + change.value,
        ..change
    }
}

fn drives(swing: Signal<f64>, steer: Signal<f64>) -> Signal<lever::Drives<f64>> {
    let model = lever::Model::new(&lever()).expect("a lever");
    let start = model.drives_at(&lever());
    let (swing, steer) = (
        starting_at(start.swing, swing),
        starting_at(start.steer, steer),
    );
    Signal {
        value: lever::Drives {
            swing: swing.value,
            steer: steer.value,
        },
        rate: lever::Drives {
            swing: swing.rate,
            steer: steer.rate,
        },
        second_rate: lever::Drives {
            swing: swing.second_rate,
            steer: steer.second_rate,
        },
    }
}

fn differences<P: Values<Vector3<f64>>>(found: &Signal<P>, expected: &Signal<P>) -> [f64; 3] {
    [
        checks::largest_distance(&found.value, &expected.value),
        checks::largest_distance(&found.rate, &expected.rate),
        checks::largest_distance(&found.second_rate, &expected.second_rate),
    ]
}

/// Motion, forces and proof, over more than half a turn of both.
#[test]
fn a_lever_on_a_moving_pin_matches_rotations_in_closed_form() {
    let model = lever::Model::new(&lever()).expect("a lever");
    let start = model.drives_at(&lever());
    let certifier = Certifier::new(&model);
    let force = Vector3::new(300.0, -200.0, 900.0);
    let (mut worst, mut worst_moment) = ([0.0_f64; 3], 0.0_f64);
    for (swing, steer) in changes(start.swing).zip(changes(start.steer).skip(3)) {
        let line = |value, rate, second_rate| Signal {
            value,
            rate,
            second_rate,
        };
        let (swing, steer) = (line(swing, 0.7, -0.4), line(steer, -1.1, 0.6));
        let (inputs, expected) = (Inputs::still(drives(swing, steer)), turned(swing, steer));
        let mut q = model.unknowns(&expected.value);
        assemble(&Newton::from_afar(), &model, &inputs, &mut q).expect("a lever");
        let tangent = Tangent::new(&model, &inputs, &q).expect("regular");
        let motion = tangent.motion().expect("finite");
        let off = differences(&motion.points(&model, &inputs), &expected);
        worst = [0, 1, 2].map(|order| worst[order].max(off[order]));
        assert!(
            certifier.certify(&inputs, &q).is_proved(),
            "{swing:?} {steer:?}"
        );

        let statics = Statics::new(&model, inputs.drives.value, &q).expect("regular");
        let forces = lever::Points {
            tip: force,
            ..lever::Points::from_values([])
        };
        let borne = statics.under(&forces).expect("finite").on_drives();
        let points = &expected.value;
        let moment = |[from, to]: [Vector3<f64>; 2]| {
            (points.tip - from)
                .cross(&force)
                .dot(&(to - from).normalize())
        };
        let moments = [
            borne.swing - moment([points.rear, points.front]),
            borne.steer - moment([points.knee, points.pin]),
        ];
        let of = moments
            .into_iter()
            .map(|moment| moment.abs() / force.norm());
        worst_moment = of.fold(worst_moment, f64::max);
    }
    let [position, velocity, acceleration] = worst;
    assert!(
        position < 1e-14 && velocity < 1e-13 && acceleration < 1e-12,
        "{worst:?}"
    );
    assert!(worst_moment < 1e-12, "{worst_moment:e}");
}

/// The Taylor series through an angle of zero.
#[test]
fn the_series_of_a_driven_angle_agrees_with_the_motion() {
    let model = lever::Model::new(&lever()).expect("a lever");
    let start = model.drives_at(&lever());
    let at = |dt: f64| {
        let moved = |start: f64, rate: f64| Signal {
            value: rate * dt - start,
            rate,
            second_rate: 0.0,
        };
        (moved(start.swing, 2.0), moved(start.steer, -3.0))
    };
    let (swing, steer) = at(0.0);
    let inputs = drives(swing, steer);
    let mut q = model.unknowns(&turned(swing, steer).value);
    assemble(&Newton::from_afar(), &model, &Inputs::still(inputs), &mut q).expect("a lever");
    let ahead = InputSeries::still(Jet::of_signal(&inputs));
    let series: Series<_, 38, 12> = Series::at(&model, &ahead, &q).expect("regular");
    let (swing, steer) = at(0.05);
    let motion = series.motion(0.05);
    let inputs = Inputs::still(drives(swing, steer));
    let off = differences(&motion.points(&model, &inputs), &turned(swing, steer));
    assert!(
        off[0] < 1e-14 && off[1] < 1e-13 && off[2] < 1e-12,
        "{off:?}"
    );
}

//! NaN and infinity: the error names the point, the length, the equation or the unknown.

use nalgebra::Vector3;
use suspension_core::certificate::Certifier;
use suspension_core::linkage::{Named, Values};
use suspension_core::linkages::five_link::{Lengths, Model, Points, equation};
use suspension_core::listing::Part;
use suspension_core::signal::ChassisMotion;
use suspension_core::step::series::{InputSeries, Jet, SeriesTracker};
use suspension_core::{
    Bounded, Build, GeometryError, Inputs, Linkage, Motion, Newton, Real, Signal, SolveError,
    Tangent, Tracker, assemble,
};

use super::verdict::{demand_same, demand_untouched};
use crate::support::{five_link_inputs, five_link_model, five_link_rough, motions};

const NONE: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// The name that a point of the knuckle shares with its link and with its chassis point.
const LINKS: [(&str, usize); 5] = [
    ("lower_front", equation::LOWER_FRONT),
    ("upper_front", equation::UPPER_FRONT),
    ("upper_rear", equation::UPPER_REAR),
    ("lower_rear", equation::LOWER_REAR),
    ("track_rod", equation::TRACK_ROD),
];

#[test]
fn a_non_finite_point_is_named() {
    let rough = five_link_rough::<f64>();
    for index in 0..Points::<f64>::NAMES.len() {
        for (axis, bad) in (0..3).flat_map(|axis| NONE.map(|bad| (axis, bad))) {
            let mut point = rough.values().nth(index).expect("as many as names");
            point[axis] = bad;
            let design = rough.with(index, point);
            let error = Model::new(&design).expect_err("no linkage");
            assert_eq!(error, GeometryError::NotFinite { point: index });
        }
    }
}

#[test]
fn an_invalid_length_is_named() {
    fn check<T: Real>(bad: &[f64]) {
        let model = five_link_model::<T>();
        let lengths = model.lengths();
        for (length, bad) in (0..Lengths::<T>::NAMES.len())
            .flat_map(|length| bad.iter().map(move |bad| (length, *bad)))
        {
            let lengths = lengths.with(length, T::constant(bad));
            let error = model.with_lengths(&lengths).expect_err("no linkage");
            assert_eq!(error, GeometryError::BadLength { length });
        }
    }
    check::<f64>(&[
        f64::NAN,
        f64::INFINITY,
        0.0,
        -0.0,
        -0.3,
        1e300,
        1e-300,
        5e-324,
    ]);
    check::<f32>(&[f64::NAN, f64::INFINITY, 0.0, -0.0, -0.3, 1e30, 1e-30, 1e-45]);
}

#[test]
fn a_non_finite_guess_is_named_by_its_equation() {
    let model = five_link_model::<f64>();
    let inputs = five_link_inputs(0.0);
    let start = model.unknowns(&five_link_rough());
    for (unknown, bad) in (0..15).flat_map(|unknown| NONE.map(|bad| (unknown, bad))) {
        let mut guess = start;
        guess[unknown] = bad;
        let (mut assembled, mut solved) = (guess, guess);
        for error in [
            assemble(&Newton::from_afar(), &model, &inputs, &mut assembled).err(),
            Newton::near_by().solve(&model, &inputs, &mut solved).err(),
        ] {
            // The first equation of the point's is that of its link.
            let (_, equation) = LINKS[unknown / 3];
            let error = error.expect("no start");
            assert!(
                matches!(error, SolveError::NotFinite { part: Part::Equation(named) } if named <= equation),
                "{error}"
            );
        }
        demand_same(&guess, &assembled);
        demand_same(&guess, &solved);
    }
}

/// Steps of every kind from the middle of the published motion, with spoiled inputs.
fn refusals<C: ChassisMotion<<Model<f64> as Linkage<15>>::Fixed>>(
    inputs: &Inputs<C, <Model<f64> as Linkage<15>>::Drives>,
    dt: f64,
) -> [SolveError<f64>; 3] {
    let model = five_link_model::<f64>();
    let start = motions(&model, &five_link_rough(), five_link_inputs)[4];
    let demand = |step: &dyn Fn(&mut Motion<f64, 15>) -> Option<SolveError<f64>>| {
        let mut motion = start;
        let error = step(&mut motion).expect("a refusal");
        demand_untouched(&start, &motion);
        error
    };
    [
        demand(&|motion| Tracker::default().step(&model, inputs, dt, motion).err()),
        demand(&|motion| {
            Bounded::<f64>::default()
                .step(&model, inputs, dt, motion)
                .err()
        }),
        demand(&|motion| {
            Bounded::<f64, 3>::new()
                .step(&model, inputs, dt, motion)
                .err()
        }),
    ]
}

#[test]
fn a_non_finite_drive_or_time_step_is_refused() {
    for bad in NONE {
        let mut inputs = five_link_inputs(1.001);
        inputs.drives.value.theta = bad;
        for error in refusals(&inputs, 1e-3) {
            let equation = equation::THETA;
            assert_eq!(
                error,
                SolveError::NotFinite {
                    part: Part::Equation(equation)
                }
            );
        }
        let mut inputs = five_link_inputs(1.001);
        inputs.drives.rate.theta = bad;
        for error in refusals(&inputs, 1e-3) {
            assert!(matches!(error, SolveError::Overflow { .. }), "{error}");
        }
        for error in refusals(&five_link_inputs(1.001), bad) {
            assert_eq!(error, SolveError::StepNotFinite);
        }
    }
}

#[test]
fn a_non_finite_chassis_point_is_named_by_its_link() {
    let model = five_link_model::<f64>();
    let still = five_link_inputs(1.001);
    for ((link, equation), bad) in LINKS
        .into_iter()
        .flat_map(|link| NONE.map(|bad| (link, bad)))
    {
        let mut values = model.fixed().values();
        let value = Named::from_fn(|name| {
            let point = values.next().expect("as many as names");
            if name == format!("{link}_inner") {
                Vector3::new(point.x, bad, point.z)
            } else {
                point
            }
        });
        let chassis = Signal {
            value,
            ..Signal::default()
        };
        let inputs = Inputs {
            chassis,
            drives: still.drives,
        };
        for error in refusals(&inputs, 1e-3) {
            assert_eq!(
                error,
                SolveError::NotFinite {
                    part: Part::Equation(equation)
                }
            );
        }
    }
}

#[test]
fn a_non_finite_position_has_neither_rates_nor_series() {
    let model = five_link_model::<f64>();
    let inputs = five_link_inputs(0.0);
    let mut position = model.unknowns(&five_link_rough());
    position[4] = f64::NAN;
    let error = Tangent::new(&model, &inputs, &position).expect_err("no tangent");
    assert!(matches!(error, SolveError::NotFinite { .. }), "{error}");
    let course = InputSeries::still(Jet {
        value: inputs.drives.value,
        terms: [inputs.drives.rate; 3],
    });
    let start = Motion::at_rest(position);
    let mut motion = start;
    let error = SeriesTracker::within(1e-9)
        .step(&model, &course, 1e-3, &mut motion)
        .expect_err("no step");
    assert!(matches!(error, SolveError::NotFinite { .. }), "{error}");
    demand_untouched(&start, &motion);
}

#[test]
fn non_finite_numbers_are_not_proved() {
    let model = five_link_model::<f64>();
    let certifier = Certifier::new(&model);
    let start = motions(&model, &five_link_rough(), five_link_inputs)[4];
    let inputs = five_link_inputs(1.0);
    assert!(certifier.certify(&inputs, &start.position).is_proved());
    for bad in NONE.into_iter().chain([1e300, 1e160]) {
        for unknown in 0..15 {
            let mut q = start.position;
            q[unknown] = bad;
            assert!(!certifier.certify(&inputs, &q).is_proved(), "{bad}");
        }
        let mut inputs = inputs;
        inputs.drives.value.theta = bad;
        assert!(
            !certifier.certify(&inputs, &start.position).is_proved(),
            "{bad}"
        );
    }
}

//! The chart's reference has its digits, and every method and formulation finds the same motion.

use nalgebra::{Const, DimMin};
use suspension::mechanism::{DriveLaws, Polynomial};
use suspension_core::bounded::Outputs;
use suspension_core::linkage::Listing;
use suspension_core::linkages::attia2003;
use suspension_core::{Build, Linkage, Motion, Newton, Signal, assemble};
use suspension_double_double::DoubleDouble;
use suspension_laboratory::chart::course::Course;
use suspension_laboratory::chart::methods::Methods;
use suspension_laboratory::chart::reference::{Reference, refine};

use crate::support;

/// A decimal number to 32 digits.
fn decimal(text: &str) -> DoubleDouble {
    let (sign, digits) = match text.strip_prefix('-') {
        Some(digits) => (-1.0, digits),
        None => (1.0, text),
    };
    let (mantissa, exponent) = digits.split_once(['e', 'E']).unwrap_or((digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let ten = DoubleDouble::from(10.0);
    let number =
        whole
            .chars()
            .chain(fraction.chars())
            .fold(DoubleDouble::from(0.0), |number, digit| {
                number * ten + DoubleDouble::from(f64::from(digit.to_digit(10).expect("a digit")))
            });
    let power = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
    let factor = (0..power.abs()).fold(DoubleDouble::from(sign), |factor, _| factor * ten);
    if power < 0 {
        number / factor
    } else {
        number * factor
    }
}

/// The decimal number that a literal was written as.
fn as_written(number: f64) -> DoubleDouble {
    decimal(&number.to_string())
}

#[test]
fn the_reference_has_the_digits_of_the_40_digit_solution() {
    let model: attia2003::Model<f64> = support::attia_model();
    let exact = attia2003::Listing::converted(&model, as_written);
    let near = support::motions(&model, &support::attia_rough(), support::attia_inputs);
    let mut reader = csv::Reader::from_reader(support::REFERENCE.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let mut worst = [0.0_f64; 3];
    for (record, near) in reader.records().zip(&near) {
        let record = record.expect("a row");
        let number = |name: &str| {
            let column = header.iter().position(|column| column == name);
            decimal(&record[column.expect("a column")])
        };
        let theta = |value| attia2003::Drives { theta: value };
        let quarter = DoubleDouble::from(0.25);
        let drives = Signal {
            value: theta(number("theta_rad")),
            rate: theta(DoubleDouble::from(0.5) + quarter * number("t_s")),
            second_rate: theta(quarter),
        };
        let motion = refine(&model, &exact, near, &drives).expect("a regular motion");
        for (worst, (found, kind)) in worst.iter_mut().zip(motion.iter().zip(["", "v", "a"])) {
            for (row, found) in found.iter().enumerate() {
                let name = format!("p{}_{kind}{}", 6 + row / 3, ["x", "y", "z"][row % 3]);
                *worst = worst.max((*found - number(&name)).nearest().abs());
            }
        }
    }
    println!("worst: {worst:?}");
    // The solution is printed to 25 digits, the last at 1e-24 of most positions.
    for (worst, limit) in worst.into_iter().zip([1e-24, 1e-22, 1e-20]) {
        assert!(worst < limit, "{worst:e} is not below {limit:e}");
    }
}

/// Worst errors of all methods over the published motion in steps of 5 ms.
fn errors<L, const N: usize>(model: &L, rough: &L::Points) -> Vec<(String, &'static str, [f64; 3])>
where
    L: Build<N, Scalar = f64> + Linkage<N, Listing: Listing<N, Model<f64> = L>>,
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    let laws = DriveLaws::new([Polynomial::new(vec![0.7, 0.5, 0.125])]);
    let course = Course::<L::Drives>::new(&laws, [0.0, 1.9], 5e-3);
    let mut q = model.unknowns(rough);
    let first = laws.inputs(0.0);
    assemble(&Newton::from_afar(), model, &first, &mut q).expect("assembles");
    let start = Motion::at_rest(q);
    let exact = L::Listing::converted(model, |x: f64| DoubleDouble::from(x));
    let reference = Reference::new(model, &exact, &start, &course).expect("a regular motion");
    let single = L::Listing::converted(model, |x: f64| x as f32);
    let mut methods = Methods { rows: Vec::new() };
    methods.add_scalar(model, model, &reference.instants()[0][0]);
    methods.add_scalar(model, &single, &reference.instants()[0][0]);
    let tried = methods.rows.iter().map(|row| {
        let label = row.label();
        let mut trials = row.try_at(&course, 1, &reference).into_iter().flatten();
        let trial = trials.find(|trial| trial.outputs == Outputs::Acceleration);
        let errors = trial.expect("a regular motion").errors;
        (label.method.clone(), label.scalar, errors)
    });
    tried.collect()
}

/// Methods that leave nothing but rounding.
const TO_ROUNDING: [&str; 6] = [
    "nalgebra_lu",
    "dense_lu",
    "generated",
    "absolute",
    "relative",
    "bounded_3",
];

#[test]
fn all_formulations_and_factorisations_find_the_same_motion() {
    let attia = errors(&support::attia_model(), &support::attia_rough());
    let five_link = errors(&support::five_link_model(), &support::five_link_rough());
    for (method, scalar, errors) in attia.into_iter().chain(five_link) {
        println!("{method} {scalar}: {errors:?}");
        if !TO_ROUNDING.contains(&method.as_str()) {
            continue;
        }
        let limits = match scalar {
            "f64" => [1e-14, 1e-12, 1e-10],
            _ => [2e-6, 2e-4, 5e-3],
        };
        for (error, limit) in errors.into_iter().zip(limits) {
            assert!(
                error < limit,
                "{method} {scalar}: {error:e} is not below {limit:e}"
            );
        }
    }
}

#[test]
fn each_order_of_the_series_and_each_correction_gains_digits() {
    let all = errors(&support::attia_model(), &support::attia_rough());
    let of = |wanted: &str| {
        let found = all
            .iter()
            .find(|(name, scalar, _)| name == wanted && *scalar == "f64");
        found.expect("a method of the table").2
    };
    for order in 2..8 {
        let [less, more] = [order, order + 1].map(|order| of(&format!("series_{order}")));
        assert!(
            more[2] < 0.1 * less[2],
            "acceleration, order {order}: {less:?} {more:?}"
        );
    }
    assert!(of("bounded_2")[2] < 1e-3 * of("bounded_1")[2]);
}

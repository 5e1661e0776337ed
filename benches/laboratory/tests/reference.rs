//! The accuracy of the chart's reference.

use suspension_core::Signal;
use suspension_core::linkage::Listing;
use suspension_core::linkages::attia2003;
use suspension_double_double::DoubleDouble;
use suspension_laboratory::chart::reference::refine;

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

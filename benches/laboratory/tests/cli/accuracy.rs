//! The accuracy of the chart's methods.

use suspension_laboratory::chart::rows::Row;

use super::chart::table;
use super::program::{example, folder, run};

/// Returns the rows of a quick chart with these arguments, with `five_link.toml` in the folder.
fn rows(five_link: &str, arguments: &[&str]) -> Vec<Row> {
    let folder = folder();
    std::fs::write(folder.path().join("five_link.toml"), five_link).expect("written");
    let output = run(
        folder.path(),
        &[&["chart", "--quick", "--rounds", "1"], arguments].concat(),
    );
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    table(&folder.path().join("out/chart.csv"))
}

/// About an origin among the points, though the file has its own more than a metre away.
#[test]
fn f32_errors_are_within_the_guaranteed_bounds() {
    let rows = rows(&example("published_five_link.toml"), &["five_link.toml"]);
    for method in ["generated", "bounded_1", "bounded_2", "baked_1e-8"] {
        // In longer steps bounded steps have larger errors.
        let of_method = rows
            .iter()
            .filter(|row| row.scalar == "f32" && row.method == method && row.step_s < 0.01);
        let errors: Vec<_> = of_method.flat_map(|row| row.error_position_m).collect();
        assert!(!errors.is_empty(), "{method}");
        assert!(
            errors.iter().all(|error| *error <= 3e-7),
            "{method}: {errors:?}"
        );
    }
}

/// Steps of 5 ms to accelerations through the published motion, not quite to its end: method, number type, worst errors of
/// position, velocity and acceleration.
fn errors(arguments: &[&str]) -> Vec<(String, String, [f64; 3])> {
    let five_link = example("published_five_link.toml");
    assert!(five_link.contains("stop = 1.95"), "{five_link}");
    let rows = rows(&five_link.replace("stop = 1.95", "stop = 1.9"), arguments).into_iter();
    let of_one = rows.filter(|row| row.step_s == 5e-3 && row.lanes == 1);
    let errors = of_one.filter_map(|row| {
        let errors = [
            row.error_position_m?,
            row.error_velocity_m_s?,
            row.error_acceleration_m_s2?,
        ];
        Some((row.method, row.scalar, errors))
    });
    errors.collect()
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
    let mut held = 0;
    for (method, scalar, errors) in errors(&[]).into_iter().chain(errors(&["five_link.toml"])) {
        println!("{method} {scalar}: {errors:?}");
        if !TO_ROUNDING.contains(&method.as_str()) {
            continue;
        }
        held += 1;
        let limits = match scalar.as_str() {
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
    assert_eq!(held, 2 * 2 * TO_ROUNDING.len());
}

#[test]
fn each_order_of_the_series_and_each_correction_reduces_errors() {
    let all = errors(&[]);
    let of = |wanted: &str| {
        let mut of_f64 = all.iter().filter(|(_, scalar, _)| scalar == "f64");
        let found = of_f64.find(|(name, ..)| name == wanted);
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

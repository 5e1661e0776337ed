//! The published mechanism and its references, for all tests.
#![allow(dead_code)]

use std::collections::BTreeMap;
use std::sync::LazyLock;

use nalgebra::{SVector, Vector3};
use suspension_core::linkage::Named;
use suspension_core::linkages::{attia2003, five_link};
use suspension_core::listing::Part;
use suspension_core::{
    Build, Inputs, Linkage, Motion, Newton, Real, Signal, Still, Tracker, assemble,
};

/// The instants of Table 2, s.
pub(crate) const INSTANTS: [f64; 9] = [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 1.95];

/// The 40-digit solution, to 25 digits.
pub(crate) const REFERENCE: &str = include_str!("../data/attia2003_reference.csv");

/// Reference values by instant and column name.
pub(crate) struct Reference {
    pub(crate) rows: Vec<BTreeMap<String, f64>>,
}

impl Reference {
    /// The 40-digit solution, rounded to f64.
    pub(crate) fn load() -> Self {
        let mut reader = csv::Reader::from_reader(REFERENCE.as_bytes());
        let rows: Vec<BTreeMap<String, f64>> = reader
            .deserialize()
            .collect::<Result<_, _>>()
            .expect("numbers under a header");
        assert_eq!(rows.len(), INSTANTS.len());
        Self { rows }
    }

    /// `p6_`, `p6_v` or `p6_a` as prefix.
    pub(crate) fn vector(&self, instant: usize, prefix: &str) -> Vector3<f64> {
        let row = &self.rows[instant];
        Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{prefix}{axis}")]))
    }

    /// Points 6 to 10 in a row: `""` for positions, `"v"`, `"a"`.
    pub(crate) fn unknowns(&self, instant: usize, kind: &str) -> SVector<f64, 15> {
        let points: Vec<f64> = (6..=10)
            .flat_map(|p| {
                self.vector(instant, &format!("p{p}_{kind}"))
                    .as_slice()
                    .to_vec()
            })
            .collect();
        SVector::from_row_slice(&points)
    }
}

/// The data file of the paper.
static PAPER: LazyLock<toml::Table> = LazyLock::new(|| {
    let text = include_str!("../../src/commands/published/attia2003.toml");
    text.parse().expect("valid TOML")
});

fn number(value: &toml::Value) -> f64 {
    value.as_float().expect("a number")
}

fn point(value: &toml::Value) -> Vector3<f64> {
    let entries = value.as_array().expect("three numbers");
    Vector3::from_iterator(entries.iter().map(number))
}

/// A chassis point of Table 1, the printed sign of point 4's x corrected.
pub(crate) fn chassis_point(name: &str) -> Vector3<f64> {
    let mut p = point(&PAPER["table1"][name]);
    if name == "p4" {
        p.x = -p.x;
    }
    p
}

/// A knuckle point of the paper's printed initial guess.
pub(crate) fn printed_guess(name: &str) -> Vector3<f64> {
    point(&PAPER["table2"]["initial_guess"][name])
}

/// A column of Table 2 or 3, misprints corrected.
pub(crate) fn table(table: &str, column: &str) -> Vec<f64> {
    let paper = &*PAPER;
    let mut values: Vec<f64> = paper[table][column]
        .as_array()
        .expect("a column")
        .iter()
        .map(number)
        .collect();
    for correction in paper["correction"].as_array().expect("corrections") {
        let place = correction["where"].as_str().expect("a place");
        if let Some((head, instant)) = place.split_once(", t = ")
            && head == format!("{table}.{column}")
        {
            let instant: f64 = instant.parse().expect("a time");
            let index = INSTANTS
                .iter()
                .position(|t| *t == instant)
                .expect("an instant");
            assert_eq!(values[index], number(&correction["printed"]));
            values[index] = number(&correction["corrected"]);
        }
    }
    values
}

/// Table 2 at an instant, misprints corrected: a configuration to a millimetre.
pub(crate) fn table2_point(name: &str, instant: usize) -> Vector3<f64> {
    Vector3::from(["x", "y", "z"].map(|axis| table("table2", &format!("{name}_{axis}"))[instant]))
}

/// The recovered length of the paper's link `name`.
pub(crate) fn length(name: &str) -> f64 {
    number(&PAPER["lengths"][name])
}

/// The drive of the paper at time `t`: value, rate, second rate.
pub(crate) fn theta(t: f64) -> Signal<f64> {
    Signal {
        value: 0.7 + 0.5 * t + 0.125 * t * t,
        rate: 0.5 + 0.25 * t,
        second_rate: 0.25,
    }
}

/// Lists the paper's knuckle points, `p6` to `p10`, under the names of `five_link`.
pub(crate) const FIVE_LINK_NAMES: [(&str, &str); 11] = [
    ("lower_front_inner", "p1"),
    ("upper_front_inner", "p2"),
    ("upper_rear_inner", "p3"),
    ("lower_rear_inner", "p4"),
    ("track_rod_inner", "p5"),
    ("lower_front_outer", "p6"),
    ("upper_front_outer", "p7"),
    ("upper_rear_outer", "p8"),
    ("lower_rear_outer", "p9"),
    ("track_rod_outer", "p10"),
    ("wheel_centre", "p11"),
];

fn rough_point(name: &str) -> Vector3<f64> {
    match name {
        "p1" | "p2" | "p3" | "p4" | "p5" => chassis_point(name),
        "p11" => table2_point("p8", 0) + Vector3::new(0.0, 0.1, 0.0),
        _ => table2_point(name, 0),
    }
}

fn paper_name(five_link_name: &str) -> &'static str {
    FIVE_LINK_NAMES
        .iter()
        .find(|(name, _)| *name == five_link_name)
        .expect("a known point")
        .1
}

fn cast<T: Real>(v: Vector3<f64>) -> Vector3<T> {
    v.map(T::constant)
}

/// Table 2 at t = 0 as points of `attia2003`.
pub(crate) fn attia_rough<T: Real>() -> attia2003::Points<T> {
    attia2003::Points::from_fn(|name| cast(rough_point(name)))
}

/// Table 2 at t = 0 as points of `five_link`.
pub(crate) fn five_link_rough<T: Real>() -> five_link::Points<T> {
    five_link::Points::from_fn(|name| cast(rough_point(paper_name(name))))
}

/// The paper's list of equations with the recovered lengths.
pub(crate) fn attia_model<T: Real>() -> attia2003::Model<T> {
    let lengths = attia2003::Lengths::from_fn(|name| T::constant(length(name)));
    attia2003::Model::new(&attia_rough())
        .and_then(|m| m.with_lengths(&lengths))
        .expect("lengths")
}

/// The same mechanism with a rigid knuckle.
pub(crate) fn five_link_model<T: Real>() -> five_link::Model<T> {
    let lengths = five_link::Lengths::from_fn(|name| T::constant(length(&paper_length(name))));
    let model = five_link::Model::new(&five_link_rough());
    model
        .and_then(|model| model.with_lengths(&lengths))
        .expect("lengths of a rigid knuckle")
}

/// The paper's name of a length of `five_link`.
fn paper_length(name: &str) -> String {
    let numbers: Vec<&str> = match name.strip_prefix("knuckle_") {
        Some(pair) => FIVE_LINK_NAMES
            .iter()
            .filter(|(point, _)| {
                pair.strip_prefix(point)
                    .is_some_and(|rest| rest.starts_with('_'))
                    || pair
                        .strip_suffix(point)
                        .is_some_and(|rest| rest.ends_with('_'))
            })
            .map(|(_, number)| *number)
            .collect(),
        None => vec![
            paper_name(&format!("{name}_inner")),
            paper_name(&format!("{name}_outer")),
        ],
    };
    let mut numbers: Vec<u32> = numbers
        .iter()
        .map(|n| n[1..].parse().expect("p and a number"))
        .collect();
    numbers.sort_unstable();
    let [small, large] = numbers[..] else {
        panic!("{name} is not the length of a pair")
    };
    format!("d{large}_{small}")
}

pub(crate) fn attia_inputs<T: Real>(t: T) -> Inputs<Still, attia2003::Drives<T>> {
    let s = cast_signal(theta(t.to_subset().expect("f64")));
    Inputs::still(Signal {
        value: attia2003::Drives { theta: s.value },
        rate: attia2003::Drives { theta: s.rate },
        second_rate: attia2003::Drives {
            theta: s.second_rate,
        },
    })
}

pub(crate) fn five_link_inputs<T: Real>(t: T) -> Inputs<Still, five_link::Drives<T>> {
    let s = cast_signal(theta(t.to_subset().expect("f64")));
    Inputs::still(Signal {
        value: five_link::Drives { theta: s.value },
        rate: five_link::Drives { theta: s.rate },
        second_rate: five_link::Drives {
            theta: s.second_rate,
        },
    })
}

fn cast_signal<T: Real>(s: Signal<f64>) -> Signal<T> {
    Signal {
        value: T::constant(s.value),
        rate: T::constant(s.rate),
        second_rate: T::constant(s.second_rate),
    }
}

/// The motion at each instant of Table 2, followed from the rough configuration at t = 0.
pub(crate) fn motions<T, L>(
    model: &L,
    rough: &L::Points,
    inputs: impl Fn(T) -> Inputs<Still, L::Drives>,
) -> Vec<Motion<T, 15>>
where
    T: Real,
    L: Build<15, Scalar = T>,
{
    let mut q = model.unknowns(rough);
    assemble(&Newton::from_afar(), model, &inputs(T::zero()), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let mut last = T::zero();
    let at = |t: f64| T::constant(t);
    INSTANTS
        .map(|t| {
            let tracker = Tracker::default();
            tracker
                .advance(model, &inputs, last, at(t), &mut motion)
                .expect("a regular motion");
            last = at(t);
            motion
        })
        .to_vec()
}

/// Point `p9` of `attia2003`.
pub(crate) const P9: Part = Part::Point(8);

/// `five_link` at rest where the published motion starts.
pub(crate) fn five_link_start<T: Real>(model: &five_link::Model<T>) -> Motion<T, 15> {
    let mut q = model.unknowns(&five_link_rough());
    let inputs = five_link_inputs(T::zero());
    assemble(&Newton::from_afar(), model, &inputs, &mut q).expect("assembles");
    Motion::at_rest(q)
}

/// The largest differences in position, velocity and acceleration.
pub(crate) fn differences<T: Real>(a: &Motion<T, 15>, b: &Motion<T, 15>) -> [T; 3] {
    [
        (a.position - b.position).amax(),
        (a.velocity - b.velocity).amax(),
        (a.acceleration - b.acceleration).amax(),
    ]
}

//! The published five-point suspension and its motion, 1 ms a step.

use suspension_core::linkage::Named;
use suspension_core::linkages::attia2003::{Drives, Lengths, Model, Points};
use suspension_core::nalgebra::{SMatrix, SVector, Vector3};
use suspension_core::solve::motion::Prescribed;
use suspension_core::{
    Build, Linkage, Motion as MotionOf, Newton, Signal, Still, Tracker, assemble,
};

pub type Vector = SVector<f64, 15>;
pub(crate) type Matrix = SMatrix<f64, 15, 15>;
pub type Motion = MotionOf<f64, 15>;
pub type Inputs = suspension_core::Inputs<Still, Drives<f64>>;

/// Length of a step, s.
pub const STEP: f64 = 1e-3;
/// The number of steps to t = 1.9 s.
const STEPS: usize = 1900;

const DATA: &str = include_str!("../../../src/commands/published/attia2003.toml");
const REFERENCE: &str = include_str!("../../../tests/data/attia2003_reference.csv");

/// The motion at an instant and the inputs one step later.
pub struct Start {
    pub motion: Motion,
    pub inputs: Inputs,
}

/// The suspension and its motion.
pub struct Mechanism {
    pub model: Model<f64>,
    /// One for each step.
    pub starts: Vec<Start>,
}

impl Mechanism {
    /// The model with the recovered lengths, followed from t = 0 in steps of 1 ms.
    pub fn published() -> Self {
        let data: toml::Table = DATA.parse().expect("valid TOML");
        let reference = reference_at_start();
        let design = Points::from_fn(|name| match reference.get(name) {
            Some(point) => *point,
            None => chassis_point(&data, name),
        });
        let lengths = Lengths::from_fn(|name| number(&data["lengths"][name]));
        let model = Model::new(&design)
            .and_then(|model| model.with_lengths(&lengths))
            .expect("lengths of the paper");
        let starts = follow(&model, &design);
        Self { model, starts }
    }

    pub(crate) fn residual(&self, q: &Vector, inputs: &Inputs) -> Vector {
        let Prescribed { fixed, drives } = Prescribed::new(&self.model, inputs);
        self.model.residual(q, &fixed.value, &drives.value)
    }

    pub(crate) fn jacobian(&self, q: &Vector) -> Matrix {
        self.model.jacobian(q, self.model.fixed())
    }

    /// Right-hand side of the velocities.
    pub(crate) fn speed(&self, q: &Vector, inputs: &Inputs) -> Vector {
        let Prescribed { fixed, drives } = Prescribed::new(&self.model, inputs);
        self.model
            .drive_rate(q, &fixed.value, &fixed.rate, &drives.rate)
    }

    /// Right-hand side of the accelerations.
    pub(crate) fn change(&self, q: &Vector, velocity: &Vector, inputs: &Inputs) -> Vector {
        let Prescribed { fixed, drives } = Prescribed::new(&self.model, inputs);
        let rate = &fixed.rate;
        self.model
            .drive_rate(q, &fixed.value, &fixed.second_rate, &drives.second_rate)
            - self.model.curvature(velocity, rate, velocity, rate)
    }
}

fn follow(model: &Model<f64>, design: &Points<f64>) -> Vec<Start> {
    let mut q = model.unknowns(design);
    assemble(&Newton::from_afar(), model, &inputs(0.0), &mut q).expect("assembles");
    let mut motion = Motion::at_rest(q);
    let tracker = Tracker::default();
    tracker
        .step(model, &inputs(0.0), 0.0, &mut motion)
        .expect("a regular motion");
    let steps = (1..=STEPS).map(|k| {
        let start = Start {
            motion,
            inputs: inputs(k as f64 * STEP),
        };
        tracker
            .step(model, &start.inputs, STEP, &mut motion)
            .expect("a regular motion");
        start
    });
    steps.collect()
}

/// The paper's drive at time `t`.
pub(crate) fn inputs(t: f64) -> Inputs {
    Inputs::still(Signal {
        value: Drives {
            theta: 0.7 + 0.5 * t + 0.125 * t * t,
        },
        rate: Drives {
            theta: 0.5 + 0.25 * t,
        },
        second_rate: Drives { theta: 0.25 },
    })
}

fn number(value: &toml::Value) -> f64 {
    value.as_float().expect("a number")
}

/// A chassis point of Table 1, the printed sign of point 4's x corrected. Point 11 takes no part.
fn chassis_point(data: &toml::Table, name: &str) -> Vector3<f64> {
    let printed = data["table1"].get(name).and_then(toml::Value::as_array);
    let Some(printed) = printed else {
        return Vector3::zeros();
    };
    let point = Vector3::from_iterator(printed.iter().map(number));
    if name == "p4" {
        point.component_mul(&Vector3::new(-1.0, 1.0, 1.0))
    } else {
        point
    }
}

/// Points 6 to 10 of the 40-digit solution at t = 0.
fn reference_at_start() -> std::collections::BTreeMap<String, Vector3<f64>> {
    let mut reader = csv::Reader::from_reader(REFERENCE.as_bytes());
    let row: std::collections::BTreeMap<String, f64> = reader
        .deserialize()
        .next()
        .expect("a row")
        .expect("numbers under a header");
    let point =
        |name: &String| Vector3::from(["x", "y", "z"].map(|axis| row[&format!("{name}_{axis}")]));
    (6..=10)
        .map(|p| format!("p{p}"))
        .map(|name| (name.clone(), point(&name)))
        .collect()
}

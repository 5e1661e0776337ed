//! A catalogue listing read as text, against rigid bodies: hinge angles and the pose of the upright in place of points,
//! with equations and derivatives of their own, in numbers of 32 digits.

mod jet;
mod mechanism;
mod newton;

use std::ops::Range;

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::{Inputs, Linkage, Motion, Signal, Still, Tracker, Values, linkages};
use suspension_double_double::DoubleDouble;
use suspension_runtime::{Listing, Model};

use jet::Vector;
use mechanism::{Drives, Mechanism};
use newton::Coordinates;

/// The largest differences: m, m/s, m/s^2.
const GATES: [f64; 3] = [1e-12, 1e-10, 1e-8];

/// Amplitudes of the wheel's travel and the rack's, m, and their angular frequencies, rad/s.
const WHEEL: [f64; 2] = [0.08, 6.0];
const RACK: [f64; 2] = [0.025, 10.0];

/// The time between instants, s, and their number: more than a full swing of either.
const STEP: f64 = 5e-3;
const STEPS: u32 = 250;

type Driven<'a> = <Model<'a, f64, 30> as Linkage<30>>::Drives;

fn listing() -> Listing {
    let mut listings = linkages::LISTINGS.iter();
    let found = listings.find(|(name, _)| *name == "double_wishbone_pushrod");
    Listing::parse(found.expect("a text").1).expect("a listing")
}

/// A swing about a value.
fn swing(middle: f64, [amplitude, frequency]: [f64; 2], t: f64) -> Signal<f64> {
    let (sine, cosine) = (frequency * t).sin_cos();
    Signal {
        value: middle + amplitude * sine,
        rate: amplitude * frequency * cosine,
        second_rate: -amplitude * frequency * frequency * sine,
    }
}

/// The listing at hardpoints.
struct Case<'a> {
    listing: &'a Listing,
    hardpoints: Vec<Vector3<f64>>,
}

impl<'a> Case<'a> {
    fn as_listed(listing: &'a Listing) -> Self {
        let hardpoints = listing.design().expect("a design");
        Self {
            listing,
            hardpoints,
        }
    }

    /// Every hardpoint up to a centimetre away along each axis.
    fn moved(mut self) -> Self {
        let mut random = fastrand::Rng::with_seed(7);
        for point in &mut self.hardpoints {
            *point = point.map(|x| x + 0.01 * (2.0 * random.f64() - 1.0));
        }
        self
    }

    fn at(&self, name: &str) -> Vector3<f64> {
        self.hardpoints[self.listing.point(name).expect("a point")]
    }

    fn drives(&self, t: f64) -> Drives<Signal<f64>> {
        Drives {
            bump: swing(self.at("wheel_centre").z, WHEEL, t),
            steer: swing(self.at("rack").y, RACK, t),
        }
    }

    /// Returns the drives in the order of the listing.
    fn inputs<'m>(&self, drives: &Drives<Signal<f64>>) -> Inputs<Still, Driven<'m>> {
        let [bump, steer] = ["bump", "steer"].map(|name| self.listing.drive(name));
        let ordered = |part: fn(&Signal<f64>) -> f64| {
            let mut values = [0.0; 2];
            values[bump.expect("a drive")] = part(&drives.bump);
            values[steer.expect("a drive")] = part(&drives.steer);
            Values::from_values(values)
        };
        Inputs::still(Signal {
            value: ordered(|signal| signal.value),
            rate: ordered(|signal| signal.rate),
            second_rate: ordered(|signal| signal.second_rate),
        })
    }

    /// The places of free points and markers.
    fn moving(&self) -> Range<usize> {
        let moving = self.listing.count(Kind::ChassisPoint)..self.hardpoints.len();
        assert_eq!(moving.len(), 10, "nine free points and the axle");
        moving
    }

    fn mechanism(&self) -> Mechanism {
        let names = (0..).map(|place| self.listing.name(Part::Point(place)).to_owned());
        let points = self.hardpoints.iter().copied().map(Vector::from);
        Mechanism(names.zip(points).collect())
    }

    /// The largest difference of any moving point from the mechanism at any instant: positions, velocities,
    /// accelerations.
    fn compare(&self, mechanism: &Mechanism, steps: u32) -> [f64; 3] {
        let model = self.listing.model::<30>(&self.hardpoints).expect("room");
        let design = Values::from_values(self.hardpoints.iter().copied());
        let mut motion = Motion::at_rest(model.unknowns(&design));
        let mut x = mechanism.start();
        let mut worst = [0.0; 3];
        for index in 0..=steps {
            let drives = self.drives(STEP * f64::from(index));
            let inputs = self.inputs(&drives);
            let dt = if index == 0 { 0.0 } else { STEP };
            let step = Tracker::default().step(&model, &inputs, dt, &mut motion);
            step.unwrap_or_else(|error| panic!("step {index}: {error}"));
            x = mechanism.solve(&x, &drives);
            let off = self.furthest(&motion.points(&model, &inputs), mechanism, &x);
            worst = larger(worst, off);
        }
        worst
    }

    /// The largest difference of any moving point at an instant.
    fn furthest(
        &self,
        found: &Signal<impl Values<Vector3<f64>>>,
        mechanism: &Mechanism,
        x: &Coordinates,
    ) -> [f64; 3] {
        let off = self.moving().map(|place| {
            let name = self.listing.name(Part::Point(place));
            let found = [&found.value, &found.rate, &found.second_rate]
                .map(|points| points.values().nth(place).expect("a point"));
            distances(&found, &mechanism.point(name, x))
        });
        off.fold([0.0; 3], larger)
    }
}

/// The larger of each, both of which are numbers.
fn larger(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    assert!(b.iter().all(|x| x.is_finite()), "{b:?}");
    [0, 1, 2].map(|order| a[order].max(b[order]))
}

/// Returns the errors of a point, its velocity and its acceleration from the reference, which is not rounded.
fn distances(found: &[Vector3<f64>; 3], reference: &Vector) -> [f64; 3] {
    [0, 1, 2].map(|order| {
        let off = Vector3::from_fn(|axis, _| {
            let exact = reference.0[axis].0[order];
            (DoubleDouble::from(found[order][axis]) - exact).nearest()
        });
        off.norm()
    })
}

#[track_caller]
fn assert_within_the_gates(what: &str, case: &Case<'_>) {
    let worst = case.compare(&case.mechanism(), STEPS);
    let [position, velocity, acceleration] = worst;
    println!("{what}: {position:.1e} m, {velocity:.1e} m/s, {acceleration:.1e} m/s^2");
    let within = worst.iter().zip(GATES).all(|(worst, gate)| *worst < gate);
    assert!(within, "{what}: {worst:?}, gates {GATES:?}");
}

#[test]
fn a_listing_from_text_agrees_with_rigid_bodies_in_32_digits() {
    assert_within_the_gates("as listed", &Case::as_listed(&listing()));
}

#[test]
fn a_listing_with_oblique_hinges_agrees_with_rigid_bodies() {
    assert_within_the_gates("moved", &Case::as_listed(&listing()).moved());
}

#[test]
fn the_comparison_detects_a_nanometre_in_any_hardpoint() {
    let listing = listing();
    let case = Case::as_listed(&listing);
    let damper_inner = listing.point("damper_inner");
    for place in (0..case.hardpoints.len()).filter(|place| Some(*place) != damper_inner) {
        let mut other = Case::as_listed(&listing);
        other.hardpoints[place].z += 1e-9;
        let [off, ..] = case.compare(&other.mechanism(), 30);
        let name = listing.name(Part::Point(place));
        assert!(off > 100.0 * GATES[0], "{name}: {off:e} m");
    }
}

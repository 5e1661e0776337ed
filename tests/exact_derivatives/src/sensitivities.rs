//! Sensitivities that `suspension sensitivities` writes, of every quantity and its derivatives with respect to the drives,
//! against differences of suspensions that are solved in numbers of 32 digits.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector3;
use suspension_core::listing::{Kind, Part, Parts};
use suspension_core::{Build, Inputs, Linkage, Newton, Signal, Still, Values};
use suspension_double_double::DoubleDouble;
use suspension_runtime::Listing;

use super::lattice::{Lattice, Model, first_difference};
use super::quantities::{Car, Reference};
use super::{Layout, Program, Row, Worst, design, is_of_roll, missing};

/// The differences of a hardpoint or a length between suspensions, m. The model's constants are rounded to 16 digits, which
/// affects differences with the smaller step, and differences with the larger step have truncation errors close to a pole: a
/// sensitivity is compared with the nearer one.
const STEPS: [f64; 2] = [2e-4, 2e-6];

/// The tolerance of smaller sensitivities of a number: a part of its largest one, and at least this, per metre.
const SMALL: f64 = 1e-2;
const NONE: f64 = 1e-3;

/// The changed coordinate or length.
#[derive(Clone, Copy, Debug)]
enum Changed {
    Point(usize, usize),
    Length(usize),
}

/// Numbers of a suspension under their names in the table: values, then derivatives with respect to drives.
type Numbers = BTreeMap<String, DoubleDouble>;

/// The number of random changes of a layout.
const DRAWN: usize = 16;

/// A layout whose sensitivities are compared, and the random changes.
pub(super) struct Sensitive<'a> {
    pub(super) layout: &'a Layout,
    pub(super) random: &'a mut fastrand::Rng,
    pub(super) program: Program<'a>,
}

/// All that a suspension is made of, by its name in the table.
fn all(listing: &Listing) -> impl Iterator<Item = (String, Changed)> {
    let points = 0..listing.stated().count() + missing(listing).count();
    let coordinate = |(place, axis)| {
        let name = listing.name(Part::Point(place));
        let name = format!("{name}.{}", ["x", "y", "z"][axis]);
        (name, Changed::Point(place, axis))
    };
    let lengths = (0..listing.count(Kind::Length)).map(|place| {
        let name = format!("length {}", listing.name(Part::Length(place)));
        (name, Changed::Length(place))
    });
    let coordinates = points.flat_map(|place| [(place, 0), (place, 1), (place, 2)]);
    coordinates.map(coordinate).chain(lengths)
}

impl Sensitive<'_> {
    /// Returns the table's rows, by the change.
    fn table(&self, listing: &Listing, drives: &[f64]) -> BTreeMap<String, Row> {
        let file = self.layout.file(listing, Car::Front, drives);
        let table = (self.program)(&file, &["sensitivities", "a.toml", "--csv", "-"]);
        let mut reader = csv::Reader::from_reader(table.as_slice());
        let records = reader.deserialize::<(String, Vec<f64>)>();
        let rows: Vec<_> = records.map(|record| record.expect("a row")).collect();
        let headings = reader.headers().expect("headings").clone();
        let row = |(changed, numbers): (String, Vec<f64>)| {
            let names = headings.iter().skip(1).map(str::to_owned);
            (changed, names.zip(numbers).collect())
        };
        rows.into_iter().map(row).collect()
    }

    pub(super) fn worst(self, listing: &Listing) -> Worst {
        let hardpoints = design(listing);
        let model: Model<'_, f64> = listing.model(&hardpoints).expect("a model");
        let points = Values::from_values(hardpoints.iter().copied());
        let count = listing.count(Kind::Drive);
        let drives: Vec<f64> = model.drives_at(&points).values().take(count).collect();
        let table = self.table(listing, &drives);
        let system = self.layout.system();
        let reference = Reference {
            system: &system,
            car: Car::Front,
            design: &hardpoints,
        };
        let mut worst = Worst::default();
        let known = all(listing).filter(|(name, _)| table.contains_key(name));
        for (name, changed) in self.random.choose_multiple(known, DRAWN) {
            let row = &table[&name];
            let numbers = |by: f64| numbers(&reference, listing, (&hardpoints, changed), by);
            let beside =
                STEPS.map(|step| [-2.0, -1.0, 1.0, 2.0].map(|steps| numbers(steps * step)));
            let known = &beside[0][0];
            for (key, found) in row {
                if !known.contains_key(key) {
                    assert!(
                        is_of_roll(key) || is_point(key),
                        "the reference has no {key}"
                    );
                    continue;
                }
                let differences = [0, 1].map(|of| difference(&beside[of], key, STEPS[of]));
                let off = |expected: &f64| (found - expected).abs();
                let nearer = differences
                    .into_iter()
                    .min_by(|a, b| off(a).total_cmp(&off(b)));
                let what = format!("{}: {key} by {name}", self.layout.name);
                let small = NONE.max(SMALL * largest(&table, key));
                worst.hold_to(small, &what, *found, nearer.expect("two differences"));
            }
        }
        worst
    }
}

/// Returns whether a number is that of the wheel centre, which is a point under another name.
fn is_point(key: &str) -> bool {
    ["centre_x", "centre_y", "centre_z"]
        .iter()
        .any(|name| key.contains(name))
}

/// The largest sensitivity of a number.
fn largest(table: &BTreeMap<String, Row>, key: &str) -> f64 {
    let all = table.values().map(|row| row[key].abs());
    all.fold(0.0, f64::max)
}

/// The difference of fourth order.
fn difference(beside: &[Numbers; 4], key: &str, step: f64) -> f64 {
    let [a, b, c, d] = beside.each_ref().map(|numbers| numbers[key]);
    let sum = (c - b) * 8.0.into() - (d - a);
    (sum / DoubleDouble::from(12.0 * step)).nearest()
}

/// Moves a point. A point that slides on a line of the chassis, of which a layout has at most one, takes the line and the
/// other points that slide there with it, as far as it moves across the line.
fn move_point(listing: &Listing, points: &mut [Vector3<f64>], place: usize, by: Vector3<f64>) {
    let chassis = listing.count(Kind::ChassisPoint);
    let statements = listing.statements().into_iter();
    let slides = statements.filter(|statement| statement.kind == suspension_listing::Kind::SLIDE);
    let on_chassis = slides.map(|slide| slide.points).filter(|points| {
        let ends = points.iter().filter(|point| **point < chassis);
        ends.count() == 2
    });
    let mut together: BTreeSet<usize> = on_chassis.flatten().collect();
    if place >= chassis && together.remove(&place) {
        let ends: Vec<usize> = together.range(..chassis).copied().collect();
        let [from, to] = ends[..] else {
            panic!("more than one line")
        };
        let along = (points[to] - points[from]).normalize();
        let across = by - along * along.dot(&by);
        together.iter().for_each(|point| points[*point] += across);
    }
    points[place] += by;
}

/// Returns the numbers of a suspension with one change.
fn numbers(
    reference: &Reference<'_>,
    listing: &Listing,
    (hardpoints, changed): (&[Vector3<f64>], Changed),
    by: f64,
) -> Numbers {
    let mut hardpoints = hardpoints.to_vec();
    if let Changed::Point(place, axis) = changed {
        move_point(
            listing,
            &mut hardpoints,
            place,
            by * Vector3::ith(axis, 1.0),
        );
    }
    let mut model: Model<'_, f64> = listing.model(&hardpoints).expect("a model");
    let points = Values::from_values(hardpoints.iter().copied());
    let count = listing.count(Kind::Drive);
    let drives: Vec<f64> = model.drives_at(&points).values().take(count).collect();
    if let Changed::Length(place) = changed {
        let lengths = model.lengths();
        let longer = lengths.values().nth(place).expect("a length") + by;
        model = model
            .with_lengths(&lengths.with(place, longer))
            .expect("a model");
    }
    let inputs: Inputs<Still, _> =
        Inputs::still(Signal::still(Values::from_values(drives.iter().copied())));
    let mut position = model.unknowns(&points);
    Newton::default()
        .solve(&model, &inputs, &mut position)
        .expect("a root");
    let lattice = Lattice::near(&model, position, drives);
    let mut numbers = Numbers::new();
    for (drive, per) in lattice.drive_names().into_iter().enumerate() {
        let along = [-3, -2, -1, 0, 1, 2, 3]
            .map(|steps| reference.all(&lattice, &lattice.beside(drive, steps)));
        for (place, (name, value)) in along[3].iter().enumerate() {
            let rate =
                first_difference(&[0, 1, 2, 3, 4, 5, 6].map(|steps: usize| along[steps][place].1));
            numbers.insert(name.clone(), *value);
            numbers.insert(format!("{name}_per_{per}"), rate);
        }
    }
    numbers
}

//! Derivatives from `suspension sweep`, of every quantity at every layout of the catalogue, against central differences in
//! numbers of 32 digits.
//!
//! The reference uses the equations' residuals of the core and no derivatives: places near that of a row are solved to 30
//! digits, velocities are differences of these, and quantities are computed from points and velocities.

mod lattice;
mod quantities;
mod sensitivities;
mod wheel;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector3;
use suspension_core::linkages::LISTINGS;
use suspension_core::listing::{DriveKind, Kind, Part, Parts};
use suspension_core::{Build, Values};
use suspension_listing::system::System;
use suspension_runtime::{CatalogueAndFiles, Listing};

use lattice::{Lattice, Model};
use quantities::{Car, Reference, travel_and_steering};
use sensitivities::Sensitive;

/// The largest difference of values and derivatives, relative to their magnitude.
pub const GATE: f64 = 1e-8;

/// The magnitude below which the difference is absolute: in metres, radians and percent, per metre or radian of a drive.
const SMALL: f64 = 1e-3;

/// An instant centre farther away does not exist: in the view the carrier rotates only by rounding.
const NOWHERE: f64 = 1e9;

/// Quantities in roll, which `axle::derivatives` holds against differences.
const OF_ROLL: [&str; 3] = ["axle_roll_centre", "roll_camber", "roll_steer"];

fn is_of_roll(name: &str) -> bool {
    OF_ROLL.iter().any(|of_roll| name.contains(of_roll))
}

/// The distance of the second place from the design position, m and rad.
const OFFSETS: [f64; 2] = [0.013, 0.05];

const CARS: [Car; 2] = [Car::Front, Car::Rear];

/// The point that two listings leave to their files, outboard of the upper trailing link.
const WHEEL_CENTRE: [f64; 3] = [-1.270, 0.415, 0.218];

/// A row of a table, by the names of its columns.
type Row = BTreeMap<String, f64>;

/// Runs a command of the program with options, one of which is `--csv -`, on a motion file with this text, and returns its
/// standard output.
pub type Program<'a> = &'a dyn Fn(&str, &[&str]) -> Vec<u8>;

/// A layout of the catalogue.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Its name.
    pub name: &'static str,
    text: &'static str,
}

/// The largest difference between the program's numbers and ours.
#[derive(Clone, Debug, Default)]
pub struct Worst {
    /// The difference, relative.
    pub off: f64,
    /// The name of the number.
    pub what: String,
    /// The number of compared numbers.
    pub count: usize,
}

impl Layout {
    /// Derivatives that `suspension sweep` writes against differences.
    pub fn derivatives(&self, program: Program<'_>) -> Worst {
        let listing = self.listing();
        let hardpoints = design(&listing);
        let model: Model<'_, f64> = listing.model(&hardpoints).expect("a model");
        let design = Values::from_values(hardpoints.iter().copied());
        let count = listing.count(Kind::Drive);
        let drives: Vec<f64> = model.drives_at(&design).values().take(count).collect();
        let system = self.system();
        let mut worst = Worst::default();
        for car in CARS {
            let [first, second] =
                ["1", "2"].map(|order| self.swept((program, order), &listing, car, &drives));
            for (first, row) in first.iter().zip(second) {
                worst.compare_rows(self.name, first, &row);
                let lattice = Lattice::about(&model, &design, &row);
                let reference = Reference {
                    system: &system,
                    car,
                    design: &hardpoints,
                };
                worst.compare(self.name, &lattice, &reference, &row);
            }
        }
        worst
    }

    /// Sensitivities that `suspension sensitivities` writes, some of them drawn at random, against differences.
    pub fn sensitivities(&self, random: &mut fastrand::Rng, program: Program<'_>) -> Worst {
        let sensitive = Sensitive {
            layout: self,
            random,
            program,
        };
        sensitive.worst(&self.listing())
    }

    fn listing(&self) -> Listing {
        Listing::parse(self.text).expect("a listing")
    }

    fn system(&self) -> System {
        suspension_listing::text::parse(self.text, self.name, &CatalogueAndFiles::default())
            .expect("a listing")
    }

    /// A motion file of it.
    fn file(&self, listing: &Listing, car: Car, drives: &[f64]) -> String {
        let names = drive_names(listing);
        let mut file = format!("linkage = \"{}\"\nunit = \"m\"\n", self.name);
        for (place, _) in missing(listing) {
            let name = listing.name(Part::Point(place));
            file += &format!("points.{name} = {WHEEL_CENTRE:?}\n");
        }
        file += "time = { instants = [0.0] }\n";
        for (name, drive) in names.iter().zip(drives) {
            file += &format!("drives.{name} = {drive:?}\n");
        }
        let (travel, steer) = travel_and_steering(&names);
        file + &car.vehicle(names[travel], steer.is_some())
    }

    /// The rows at the design position and at the other place, with derivatives up to an order.
    fn swept(
        &self,
        (program, order): (Program<'_>, &str),
        listing: &Listing,
        car: Car,
        drives: &[f64],
    ) -> [Row; 2] {
        let mut options = ["sweep", "a.toml", "--derivatives", order, "--csv", "-"]
            .map(str::to_owned)
            .to_vec();
        for (drive, name) in drive_names(listing).into_iter().enumerate() {
            let to = offset(listing.drive_kind(drive));
            options.extend(["--drive".to_owned(), format!("{name}=0:{to}:2")]);
        }
        let options: Vec<&str> = options.iter().map(String::as_str).collect();
        let table = program(&self.file(listing, car, drives), &options);
        let rows = csv::Reader::from_reader(table.as_slice()).into_deserialize();
        let rows: Vec<Row> = rows
            .map(|row| row.expect("numbers under a header"))
            .collect();
        [0, rows.len() - 1].map(|place| rows[place].clone())
    }
}

fn drive_names(listing: &Listing) -> Vec<&str> {
    let drives = 0..listing.count(Kind::Drive);
    drives
        .map(|drive| listing.name(Part::Drive(drive)))
        .collect()
}

/// All points of the design.
fn design(listing: &Listing) -> Vec<Vector3<f64>> {
    let mut hardpoints: Vec<_> = listing.stated().chain(missing(listing)).collect();
    hardpoints.sort_by_key(|(place, _)| *place);
    hardpoints.into_iter().map(|(_, at)| at).collect()
}

fn offset(kind: DriveKind) -> f64 {
    match kind {
        DriveKind::Coordinate => OFFSETS[0],
        DriveKind::Angle | DriveKind::Turn => OFFSETS[1],
    }
}

/// The points whose positions the listing does not state.
fn missing(listing: &Listing) -> impl Iterator<Item = (usize, Vector3<f64>)> {
    let stated: BTreeSet<usize> = listing.stated().map(|(place, _)| place).collect();
    let count = Kind::POINTS.map(|kind| listing.count(kind));
    let all = 0..count.iter().sum();
    all.filter(move |place| !stated.contains(place))
        .map(|place| (place, Vector3::from(WHEEL_CENTRE)))
}

impl Worst {
    /// Holds the derivatives of a row against differences.
    fn compare(
        &mut self,
        layout: &str,
        lattice: &Lattice<'_>,
        reference: &Reference<'_>,
        row: &Row,
    ) {
        let drives = lattice.drive_names();
        let mut known = BTreeSet::new();
        for (drive, per) in drives.iter().enumerate() {
            let along: Vec<_> = (-3..=3)
                .map(|steps| reference.all(lattice, &lattice.beside(drive, steps)))
                .collect();
            for (place, (name, value)) in along[3].iter().enumerate() {
                let stencil = [0, 1, 2, 3, 4, 5, 6].map(|steps: usize| along[steps][place].1);
                let [first, second] = lattice::differences(&stencil);
                let key = format!("{name}_per_{per}");
                self.hold(&format!("{layout} {name}"), row[name], value.nearest());
                self.hold(&format!("{layout} {key}"), row[&key], first);
                self.hold(&format!("{layout} {key}2"), row[&format!("{key}2")], second);
                known.insert(key);
            }
        }
        let unknown: Vec<_> = row
            .iter()
            .filter(|(_, value)| !value.is_nan())
            .map(|(name, _)| name)
            .filter(|name| {
                drives
                    .iter()
                    .any(|drive| name.ends_with(&format!("_per_{drive}")))
                    && !known.contains(*name)
                    && !is_of_roll(name)
            })
            .collect();
        assert!(
            unknown.is_empty(),
            "{layout}: the reference has no {unknown:?}"
        );
    }

    /// Compares a row without second derivatives with one that has them: they were computed with other number types.
    fn compare_rows(&mut self, layout: &str, first: &Row, row: &Row) {
        for (name, found) in first {
            let (what, expected) = (format!("{layout} {name} alone"), row[name]);
            assert_eq!(found.is_nan(), expected.is_nan(), "{what}");
            self.hold(&what, *found, expected);
        }
    }

    fn hold(&mut self, what: &str, found: f64, expected: f64) {
        self.hold_to(SMALL, what, found, expected);
    }

    /// Compares a number relative to `small` or to the magnitude of the expected number, whichever is larger.
    fn hold_to(&mut self, small: f64, what: &str, found: f64, expected: f64) {
        if expected.is_nan() || expected.abs() > NOWHERE {
            return;
        }
        let off = (found - expected).abs() / expected.abs().max(small);
        if off > GATE {
            println!("{what}: {found:e} instead of {expected:e}, {off:.1e}");
        }
        self.count += 1;
        if off > self.off {
            (self.off, self.what) = (off, what.to_owned());
        }
    }
}

/// Returns the catalogue without layouts that include others: tests/cli/axle/car.rs compares these.
pub fn layouts() -> impl Iterator<Item = Layout> {
    let layouts = LISTINGS.iter().map(|(name, text)| Layout { name, text });
    layouts.filter(|layout| !layout.text.contains("include "))
}

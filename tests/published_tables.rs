//! The solver against Tables 2 and 3 as the paper prints them.

use suspension::commands::published::paper::{Column, Paper};
use suspension_core::Motion;
use suspension_core::linkage::HasWheel;
use suspension_core::linkages::attia2003;
use suspension_core::wheel::CarrierRotation;

use crate::support::{self, Reference};

fn motions() -> Vec<Motion<f64, 15>> {
    support::motions(
        &support::attia_model(),
        &support::attia_rough(),
        support::attia_inputs,
    )
}

/// Differences from a column in units of the last printed digit.
fn units(column: &Column, ours: impl Iterator<Item = f64>) -> Vec<f64> {
    let pairs = column.entries.iter().zip(ours);
    pairs
        .map(|(entry, ours)| (ours - entry.value).abs() / entry.unit)
        .collect()
}

fn knuckle_rotation(t: f64, motion: &Motion<f64, 15>) -> [f64; 6] {
    let points = motion.points(&support::attia_model::<f64>(), &support::attia_inputs(t));
    let turning = CarrierRotation::of(&points.map(|points| points.carrier()))
        .expect("the knuckle is a triangle");
    let [alpha, omega] = [turning.alpha, turning.omega];
    [alpha.x, alpha.y, alpha.z, omega.x, omega.y, omega.z]
}

#[test]
fn table_2_agrees_within_0_85_mm_and_in_90_percent_within_0_5_mm() {
    let paper = Paper::built_in();
    let motions = motions();
    let mut differences = Vec::new();
    for column in paper.table2.iter().filter(|c| c.name.starts_with('p')) {
        let unknown = attia2003::Listing::PARTS
            .unknowns
            .iter()
            .position(|name| name.replace('.', "_") == column.name)
            .expect("a knuckle point's coordinate");
        let ours = motions.iter().map(|motion| motion.position[unknown]);
        let entries = column.entries.iter().zip(ours);
        differences.extend(entries.map(|(entry, ours)| (ours - entry.value).abs()));
    }
    assert_eq!(differences.len(), 135);
    let worst = differences.iter().fold(0.0_f64, |worst, d| worst.max(*d));
    assert!(worst < 0.85e-3, "{worst}");
    let close = differences.iter().filter(|d| **d < 0.5e-3).count();
    assert!(close * 10 >= differences.len() * 9, "{close}");
}

/// 51 of the 54 entries are met within half a unit of their last digit. The other three are off by
/// 0.51 to 0.54 units in the 40-digit reference too: the lengths were fitted to the tables.
#[test]
fn table_3_agrees_to_its_last_digit_except_for_three_entries() {
    const BEYOND: [(&str, usize); 3] = [("omega_y", 5), ("omega_y", 8), ("alpha_z", 7)];
    let paper = Paper::built_in();
    let reference = Reference::load();
    let motions = support::INSTANTS.into_iter().zip(motions());
    let ours: Vec<[f64; 6]> = motions
        .map(|(t, motion)| knuckle_rotation(t, &motion))
        .collect();
    let names = [
        "alpha_x", "alpha_y", "alpha_z", "omega_x", "omega_y", "omega_z",
    ];
    assert!(
        paper
            .table3
            .iter()
            .map(|column| column.name.as_str())
            .eq(names)
    );
    for (index, column) in paper.table3.iter().enumerate() {
        let found = units(column, ours.iter().map(|row| row[index]));
        let exact = units(column, reference.rows.iter().map(|row| row[&column.name]));
        for (instant, (found, exact)) in found.into_iter().zip(exact).enumerate() {
            let bound = if BEYOND.contains(&(names[index], instant)) {
                0.55
            } else {
                0.5
            };
            let place = format!("{} at {} s", column.name, support::INSTANTS[instant]);
            assert!(found <= bound, "{place}: {found} units");
            assert!(
                (found - exact).abs() < 1e-6,
                "{place}: the reference has {exact}"
            );
        }
    }
}

#[test]
fn every_listed_misprint_is_marked_in_the_tables() {
    let paper = Paper::built_in();
    let columns = paper.table2.iter().chain(&paper.table3);
    let marked = columns
        .flat_map(|column| &column.entries)
        .filter(|entry| entry.misprinted);
    let of_table_1 = paper
        .misprints
        .iter()
        .filter(|misprint| misprint.place.starts_with("table1"));
    assert_eq!(marked.count() + of_table_1.count(), paper.misprints.len());
}

//! Tables with random damage: each is read, or refused with the name of its file.

use fastrand::Rng;

use super::Arguments;
use super::format;
use super::names::Names;
use crate::failure::Failure;
use crate::file::Source;

const TABLES: usize = 400;

const WHOLE: &str = include_str!("../../../examples/hardpoints.csv");

/// Text that damaged tables have in any place.
const PIECES: [&str; 24] = [
    ";", ",", "\t", "|", "\"", "'", "(", "]", "{", "#", "=", "-", "1,5", "1e400", "nan", "in",
    "mm", "left", "hpr_", "\r", "\0", "\u{2013}", "\u{a0}", "°",
];

/// Replaces, removes, doubles or exchanges lines of the table, or puts a piece into one.
fn damaged(rng: &mut Rng) -> String {
    let mut lines: Vec<String> = WHOLE.lines().map(str::to_owned).collect();
    for _ in 0..rng.usize(1..6) {
        let (one, other) = (rng.usize(..lines.len()), rng.usize(..lines.len()));
        match rng.u8(..6) {
            0 => lines.swap(one, other),
            1 => lines[one] = lines[other].clone(),
            2 => lines[one] = String::new(),
            3 => {
                let (from, to) =
                    [(",", ";"), (".", ","), (", ", "\t"), ("hpl_", "")][rng.usize(..4)];
                lines = lines.iter().map(|line| line.replace(from, to)).collect();
            }
            _ => {
                let places: Vec<usize> =
                    lines[one].char_indices().map(|(place, _)| place).collect();
                let place = rng.choice(places).unwrap_or_default();
                lines[one].insert_str(place, PIECES[rng.usize(..PIECES.len())]);
            }
        }
    }
    lines.join("\n")
}

fn import(text: &str, names: &Names) -> Result<(), Failure> {
    let arguments = Arguments {
        file: None,
        names: false,
        linkage: None,
        unit: None,
        axes: None,
        side: None,
        axle: false,
        end: None,
        out: None,
    };
    let source = Source::new("a.csv", text);
    let stated = arguments.of_axle(format::read(&source, names)?, names)?;
    arguments.corner(&stated, names, None)?;
    Ok(())
}

#[test]
fn damaged_tables_are_read_or_refused() {
    let names = Names::read().expect("the names of points");
    let mut read = 0;
    for seed in 0..TABLES {
        println!("seed {seed}");
        match import(&damaged(&mut Rng::with_seed(seed as u64)), &names) {
            Ok(()) => read += 1,
            Err(failure) => {
                let said = failure.to_string();
                assert!(said.lines().all(|line| line.starts_with("a.csv")), "{said}");
                assert!(!said.is_empty());
            }
        }
    }
    assert!(
        (TABLES / 10..TABLES * 9 / 10).contains(&read),
        "{read} were read"
    );
}

//! The figures of the page on controllers are those that the budgets of the firmware allow.

use std::collections::BTreeMap;

/// The part of a mode's name that a row of the page stands for.
const CALLS: [(&str, &str); 9] = [
    ("bounded, no correction", "five_link_{}_bounded_uncorrected"),
    (
        "bounded, one correction",
        "five_link_{}_bounded_acceleration",
    ),
    (
        "position and velocity, two corrections",
        "five_link_{}_bounded_velocity",
    ),
    (
        "position alone, two corrections",
        "five_link_{}_bounded_position",
    ),
    ("to tolerance (`Tracker::step`)", "five_link_{}_exact"),
    ("forces under one load", "five_link_{}_loads"),
    ("look-up of the wheel's pose", "wheel_{}_baked_position"),
    ("the same with velocity", "wheel_{}_baked_velocity"),
    (
        "the same with velocity and acceleration",
        "wheel_{}_baked_acceleration",
    ),
];

const TARGETS: [(&str, &str); 3] = [
    ("Cortex-M4F", "m4f"),
    ("Cortex-M7", "m7"),
    ("RISC-V (rv64gc)", "rv64gc"),
];

/// Instructions, bytes of stack, bytes of code and constants.
type Budgets = BTreeMap<String, BTreeMap<String, BTreeMap<String, u32>>>;

/// Budgets have a fiftieth of room, in round numbers. The page may be a little newer.
#[test]
fn the_costs_on_the_page_of_controllers_are_just_within_their_budgets() {
    let budgets: Budgets = toml::from_str(include_str!("firmware/budgets.toml")).expect("budgets");
    let page = include_str!("../suspension-core/docs/controller.md");
    let mut rows = 0;
    for line in page.lines() {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [processor, call, figures @ ..] = cells.as_slice() else {
            continue;
        };
        let Some((_, mode)) = CALLS.iter().find(|(name, _)| name == call) else {
            continue;
        };
        let (processor, number) = processor
            .split_once(", ")
            .expect("a processor and a number");
        let (_, target) = TARGETS
            .iter()
            .find(|(name, _)| *name == processor)
            .expect("a target");
        let budget = &budgets[*target][&mode.replace("{}", number.trim_matches('`'))];
        for (figure, what) in figures.iter().zip(["instructions", "stack", "size"]) {
            let figure: u32 = figure.replace(',', "").parse().expect("a figure");
            let budget = budget[what];
            let oldest = figure + figure / 20 + 20;
            assert!(
                (figure..oldest).contains(&budget),
                "{line}: {what} has the budget {budget}"
            );
        }
        rows += 1;
    }
    assert_eq!(rows, 43);
}

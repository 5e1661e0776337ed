//! The budgets, and measurements that exceed them.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::compile::workspace;
use crate::figures::{Figures, Measured, Table};

const HEAD: &str = "\
# What a step may cost, by target and mode: the most instructions, the deepest stack and the size of
# what a call reaches, both in bytes. Held by `cargo run -p measure`, written by its `--write`. To
# raise one is a change to be reviewed, with its reason.

";

fn path() -> PathBuf {
    workspace().join("budgets.toml")
}

pub(crate) fn read() -> Result<Table<Figures>> {
    let path = path();
    let text = std::fs::read_to_string(&path);
    parse(&text.with_context(|| path.display().to_string())?, &path)
}

fn parse(text: &str, path: &Path) -> Result<Table<Figures>> {
    toml::from_str(text).with_context(|| path.display().to_string())
}

/// Replaces the budgets by the measurements.
pub(crate) fn write(measured: &Table<Measured>) -> Result<()> {
    let figures: Table<Figures> = measured
        .iter()
        .map(|(target, modes)| {
            let modes = modes.iter();
            let figures = modes.map(|(mode, measured)| (mode.clone(), with_room(measured.figures)));
            (target.clone(), figures.collect())
        })
        .collect();
    let text = toml::to_string(&figures)?;
    Ok(std::fs::write(path(), format!("{HEAD}{text}"))?)
}

/// A fiftieth more, in round numbers: another compiler makes slightly other code.
fn with_room(figures: Figures) -> Figures {
    let room = |figure: u64| (figure + figure / 50).next_multiple_of(10);
    Figures {
        instructions: room(figures.instructions),
        stack: room(figures.stack),
        size: room(figures.size),
    }
}

/// Returns a sentence for each violation, and none if there is none. Only budgets that `is_wanted` count, by target and
/// mode.
pub(crate) fn complaints(
    measured: &Table<Measured>,
    budgets: &Table<Figures>,
    is_wanted: impl Fn(&str, &str) -> bool,
) -> Vec<String> {
    let mut complaints = Vec::new();
    for (target, modes) in measured {
        for (mode, measured) in modes {
            let budget = budgets.get(target).and_then(|modes| modes.get(mode));
            let at = format!("{target}/{mode}");
            match budget {
                Some(budget) => complaints.extend(over(&at, &measured.figures, budget)),
                None => complaints.push(format!("{at} has no budget")),
            }
            complaints.extend(inconsistent(&at, measured));
        }
    }
    for (target, modes) in budgets {
        for mode in modes.keys().filter(|mode| is_wanted(target, mode)) {
            if !measured
                .get(target)
                .is_some_and(|modes| modes.contains_key(mode))
            {
                complaints.push(format!(
                    "{target}/{mode} has a budget, but was not measured"
                ));
            }
        }
    }
    complaints
}

fn over<'a>(
    at: &'a str,
    figures: &Figures,
    budget: &Figures,
) -> impl Iterator<Item = String> + use<'a> {
    let each = figures.named().into_iter().zip(budget.named());
    each.filter(|((_, figure), (_, budget))| figure > budget)
        .map(move |((name, figure), (_, budget))| {
            format!("{at} takes {figure} {name}, and its budget is {budget}")
        })
}

fn inconsistent(at: &str, measured: &Measured) -> Vec<String> {
    let Measured {
        figures,
        least,
        used_stack,
        is_hosts,
        ..
    } = *measured;
    let mut found = Vec::new();
    let most = figures.instructions;
    let must_be_even = ["_bounded_", "_baked_", "_loads"];
    if must_be_even.iter().any(|mode| at.contains(mode)) && least != most {
        found.push(format!(
            "{at} takes {least} to {most} instructions: they depend on the data"
        ));
    }
    if used_stack > figures.stack {
        let deepest = figures.stack;
        found.push(format!(
            "{at} used {used_stack} bytes of stack, more than the deepest {deepest}"
        ));
    }
    if !is_hosts {
        found.push(format!("{at} leads to other states than on the host"));
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{complaints, parse};
    use crate::figures::{Figures, Measured, Table};
    use std::path::Path;

    const FIGURES: Figures = Figures {
        instructions: 1700,
        stack: 2048,
        size: 16384,
    };
    const MEASURED: Measured = Measured {
        figures: FIGURES,
        least: 1700,
        used_stack: 900,
        is_hosts: true,
        residual: 0.0,
    };

    fn table<T>(mode: &str, value: T) -> Table<T> {
        [("m4f".to_owned(), [(mode.to_owned(), value)].into())].into()
    }

    fn complaints_of(measured: Measured, budget: Figures) -> Vec<String> {
        let mode = "attia2003_f32_bounded_acceleration";
        complaints(&table(mode, measured), &table(mode, budget), |_, _| true)
    }

    #[test]
    fn a_measurement_equal_to_its_budget_is_accepted() {
        assert_eq!(complaints_of(MEASURED, FIGURES), [""; 0]);
    }

    #[test]
    fn each_exceeded_budget_is_reported_with_place_and_figures() {
        let budgets = [
            Figures {
                instructions: 1699,
                ..FIGURES
            },
            Figures {
                stack: 2047,
                ..FIGURES
            },
            Figures {
                size: 16383,
                ..FIGURES
            },
        ];
        let reported = budgets.map(|budget| complaints_of(MEASURED, budget));
        let at = "m4f/attia2003_f32_bounded_acceleration";
        assert_eq!(
            reported,
            [
                [format!(
                    "{at} takes 1700 instructions, and its budget is 1699"
                )],
                [format!(
                    "{at} takes 2048 bytes of stack, and its budget is 2047"
                )],
                [format!(
                    "{at} takes 16384 bytes of code and constants, and its budget is 16383"
                )],
            ]
        );
    }

    #[test]
    fn a_mode_without_budget_and_a_budget_without_mode_are_reported() {
        let reported = complaints(&table("new", MEASURED), &table("old", FIGURES), |_, _| true);
        assert_eq!(
            reported,
            [
                "m4f/new has no budget",
                "m4f/old has a budget, but was not measured"
            ]
        );
    }

    #[test]
    fn a_budget_of_an_unselected_mode_is_not_reported() {
        let reported = complaints(&Table::new(), &table("old", FIGURES), |_, mode| {
            mode == "new"
        });
        assert_eq!(reported, [""; 0]);
    }

    #[test]
    fn a_bounded_step_whose_count_depends_on_the_data_is_reported() {
        let reported = complaints_of(
            Measured {
                least: 1699,
                ..MEASURED
            },
            FIGURES,
        );
        assert_eq!(reported.len(), 1, "{reported:?}");
        assert!(reported[0].contains("1699 to 1700"), "{reported:?}");
    }

    #[test]
    fn the_count_of_an_iterated_step_may_depend_on_the_data() {
        let (measured, mode) = (
            Measured {
                least: 1,
                ..MEASURED
            },
            "attia2003_f32_exact",
        );
        assert_eq!(
            complaints(&table(mode, measured), &table(mode, FIGURES), |_, _| true),
            [""; 0]
        );
    }

    #[test]
    fn excess_stack_and_states_unlike_the_host_are_reported() {
        let measured = Measured {
            used_stack: 2056,
            is_hosts: false,
            ..MEASURED
        };
        assert_eq!(complaints_of(measured, FIGURES).len(), 2);
    }

    #[test]
    fn a_budget_that_lacks_a_figure_is_refused() {
        let text = "[m4f.mode]\ninstructions = 1\nstack = 2\n";
        let error = parse(text, Path::new("budgets.toml")).expect_err("no size");
        assert!(format!("{error:#}").contains("size"), "{error:#}");
    }
}

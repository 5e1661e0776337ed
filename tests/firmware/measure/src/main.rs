//! Measures what a step of the solver costs on emulated microcontrollers, compares it with the
//! budgets and with the host, and searches for what firmware must not reach.

mod absence;
mod archive;
mod budgets;
mod compile;
mod figures;
mod print;
mod reach;
mod run;
mod target;

use std::collections::BTreeMap;
use std::panic::resume_unwind;
use std::process::ExitCode;

use anyhow::{Context, Result, ensure};
use clap::Parser;

use archive::Archive;
use figures::{Figures, Measured, Table};
use reach::Reach;
use run::Taken;
use target::{TARGETS, Target};

/// Measures what a step of the solver costs on emulated microcontrollers: instructions, stack and
/// size, by target and mode. Ends with 1 where a budget is exceeded or missing, where a step depends
/// on its data or leads to other states than on the host, and where a call reaches a panic,
/// formatting, allocation or floating point in software.
///
/// For example `cargo run -p measure -- --only m4f/attia2003_f32_bounded`.
#[derive(Parser)]
struct Options {
    /// Measures only what starts so: a target (m4f, m7, rv64gc), `/` and the start of a mode
    #[arg(long, value_name = "TARGET/MODE", default_value = "")]
    only: String,
    /// Writes the table as Markdown
    #[arg(long)]
    markdown: bool,
    /// Replaces the budgets by what is measured
    #[arg(long, conflicts_with = "only")]
    write: bool,
    /// Lists what each mode reaches: bytes of code or constants, bytes of stack, name
    #[arg(long)]
    reach: bool,
}

impl Options {
    fn wants(&self, target: &str, mode: &str) -> bool {
        format!("{target}/{mode}").starts_with(&self.only)
    }

    /// The targets, one at least.
    fn targets(&self) -> Result<Vec<&'static Target>> {
        let (wanted, _) = self.only.split_once('/').unwrap_or((&self.only, ""));
        let targets = TARGETS.iter();
        let targets: Vec<_> = targets
            .filter(|target| target.name.starts_with(wanted))
            .collect();
        ensure!(
            !targets.is_empty(),
            "no target is called {wanted}; there are {}",
            TARGETS.map(|target| target.name).join(", ")
        );
        Ok(targets)
    }
}

fn main() -> Result<ExitCode> {
    let options = Options::parse();
    let targets = options.targets()?;
    compile::take_versions()?;
    let host = run::on_host();
    let mut measured = Table::new();
    let mut complaints = Vec::new();
    for (target, (archive, mut taken)) in targets.iter().zip(side_by_side(&targets)?) {
        taken.retain(|mode, _| options.wants(target.name, mode));
        ensure!(!taken.is_empty(), "{} has no such mode", target.name);
        measured.insert(
            target.name.to_owned(),
            modes(target, &archive, &taken, &host)?,
        );
        complaints.extend(absence::complaints(target, &archive)?);
        if options.reach {
            list(&archive, taken.keys())?;
        }
    }
    let table = if options.markdown {
        print::markdown
    } else {
        print::plain
    };
    print!("{}", table(&measured));
    if options.write {
        budgets::write(&measured)?;
    }
    let wanted = |target: &str, mode: &str| options.wants(target, mode);
    complaints.extend(budgets::complaints(&measured, &budgets::read()?, wanted));
    for complaint in &complaints {
        eprintln!("error: {complaint}");
    }
    Ok(ExitCode::from(u8::from(!complaints.is_empty())))
}

/// Builds for each target and runs the loop on its board, all at the same time.
fn side_by_side(targets: &[&Target]) -> Result<Vec<(Archive, BTreeMap<String, Taken>)>> {
    let build_and_run = |target: &Target| {
        let built = compile::compile(target)?;
        let taken = run::on_board(target, &built.firmware)?;
        Ok((Archive::read(&built.archive)?, taken))
    };
    std::thread::scope(|scope| {
        let targets = targets.iter();
        let begun: Vec<_> = targets
            .map(|target| scope.spawn(|| build_and_run(target)))
            .collect();
        let finished = begun.into_iter().map(|target| target.join());
        finished
            .map(|taken| taken.unwrap_or_else(|panic| resume_unwind(panic)))
            .collect()
    })
}

/// The modes of a target.
fn modes(
    target: &Target,
    archive: &Archive,
    taken: &BTreeMap<String, Taken>,
    host: &BTreeMap<String, String>,
) -> Result<BTreeMap<String, Measured>> {
    let each = taken.iter().map(|(mode, taken)| {
        let root = archive.find(mode)?;
        let reach = Reach::of(archive, &[root]);
        let stack = reach.stack(root);
        let [least, most] = taken.instructions.map(u64::from);
        let measured = Measured {
            figures: Figures {
                instructions: most,
                stack: stack.with_context(|| format!("{}/{mode}", target.name))?,
                size: reach.bytes(),
            },
            least,
            used_stack: taken.stack[1].into(),
            is_hosts: host.get(mode) == Some(&taken.checksum),
            residual: taken.residual,
        };
        Ok((mode.clone(), measured))
    });
    each.collect()
}

fn list<'a>(archive: &Archive, modes: impl Iterator<Item = &'a String>) -> Result<()> {
    for mode in modes {
        println!("{mode} reaches");
        for section in Reach::of(archive, &[archive.find(mode)?]).by_size() {
            let frame = section
                .frame
                .map_or("-".to_owned(), |frame| frame.to_string());
            println!(
                "{:7} {frame:>6} {}",
                section.bytes,
                section.names.join(", ")
            );
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Options;
    use clap::Parser;

    /// Otherwise a mistyped target would measure nothing and succeed.
    #[test]
    fn an_unknown_target_of_only_is_refused() {
        let count = |only: &str| {
            let options = Options::parse_from(["measure", "--only", only]);
            options.targets().map(|targets| targets.len()).ok()
        };
        assert_eq!(count("m"), Some(2));
        assert_eq!(count("m4f/five_link"), Some(1));
        assert_eq!(count("m5"), None);
    }
}

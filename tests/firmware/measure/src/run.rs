//! Runs the loop, on an emulated board and on the host.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use controller::{Gauge, Report, modes};

use crate::target::Target;

/// The time limit of a run in parallel with other boards and builds, s: alone it takes about ten.
const TIME_LIMIT: &str = "300";

/// The cost of a mode on a board: least and most.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Taken {
    pub instructions: [u32; 2],
    /// Bytes.
    pub stack: [u32; 2],
    /// The checksum of the states.
    pub checksum: String,
    /// The largest residual, m.
    pub residual: f64,
}

pub(crate) fn on_board(target: &Target, firmware: &Path) -> Result<BTreeMap<String, Taken>> {
    let output = Command::new("timeout")
        .arg(TIME_LIMIT)
        .args(target.emulator)
        .args(["-nographic", "-monitor", "none", "-serial", "null"])
        .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(firmware)
        .output()
        .context("timeout")?;
    let text = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "{}: {text}{errors}", target.name);
    parse(&text)
}

/// Parses the output of the firmware.
fn parse(text: &str) -> Result<BTreeMap<String, Taken>> {
    let mut modes = BTreeMap::<String, Taken>::new();
    for line in text.lines() {
        let mut words = line.split(' ');
        let mut next = || words.next().with_context(|| format!("unfinished: {line}"));
        let gauged = next()?;
        let taken = modes.entry(next()?.to_owned()).or_default();
        let range = [next()?.parse()?, next()?.parse()?];
        match gauged {
            "instructions" => taken.instructions = range,
            "stack" => taken.stack = range,
            _ => bail!("what is {line}?"),
        }
        taken.checksum = next()?.to_owned();
        taken.residual = next()?.parse()?;
    }
    Ok(modes)
}

struct Nothing;

impl Gauge for Nothing {
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32) {
        (call(), 0)
    }
}

/// The checksums of all modes on the host, or which step fails.
pub(crate) fn on_host() -> BTreeMap<String, String> {
    let mut checksums = BTreeMap::new();
    let mut tell = |mode: &'static str, report: Result<Report, u32>| {
        let checksum = match report {
            Ok(report) => format!("{:016x}", report.checksum),
            Err(step) => format!("step {step} fails"),
        };
        checksums.insert(mode.to_owned(), checksum);
    };
    modes::single(&Nothing, &mut tell);
    modes::double(&Nothing, &mut tell);
    checksums
}

#[cfg(test)]
mod tests {
    use super::{Taken, on_host, parse};

    #[test]
    fn both_output_lines_of_a_mode_are_joined() {
        let text = "instructions m 10 12 0f 1e-9\nstack m 100 104 0f 1e-9\n";
        let modes = parse(text).expect("lines as the firmware writes them");
        let taken = Taken {
            instructions: [10, 12],
            stack: [100, 104],
            checksum: "0f".to_owned(),
            residual: 1e-9,
        };
        assert_eq!(modes, [("m".to_owned(), taken)].into());
    }

    #[test]
    fn invalid_output_lines_are_refused() {
        for text in ["a step fails", "instructions m 10", "time m 1 2 0f 0e0"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }

    #[test]
    fn all_modes_run_on_the_host_with_distinct_checksums() {
        let mut checksums: Vec<String> = on_host().into_values().collect();
        assert_eq!(checksums.len(), 24);
        checksums.sort_unstable();
        checksums.dedup();
        assert_eq!(checksums.len(), 24, "{checksums:?}");
        assert!(
            checksums.iter().all(|checksum| checksum.len() == 16),
            "{checksums:?}"
        );
    }
}

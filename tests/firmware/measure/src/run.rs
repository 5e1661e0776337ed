//! Runs the loop, on an emulated board and on the host.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use controller::{Gauge, Report, modes};

use crate::target::Target;

/// The most that a run takes, s.
const TIME_LIMIT: &str = "120";

/// What a mode took on a board: least and most.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Taken {
    pub instructions: [u32; 2],
    /// Bytes.
    pub stack: [u32; 2],
    /// Of the states.
    pub checksum: String,
    /// The largest residual, m.
    pub residual: f64,
}

pub fn on_board(target: &Target, firmware: &Path) -> Result<BTreeMap<String, Taken>> {
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

/// Reads what the firmware writes.
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
pub fn on_host() -> BTreeMap<String, String> {
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

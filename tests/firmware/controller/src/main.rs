//! The loop on a controller. It writes the costs of each mode to the debugger, one line per mode: the measured cost, the
//! mode, least and most, checksum and largest residual.
#![no_std]
#![no_main]

mod count;
mod paint;
#[cfg_attr(target_arch = "arm", path = "arm.rs")]
#[cfg_attr(target_arch = "riscv64", path = "risc_v.rs")]
mod processor;

use controller::{Gauge, Report, modes};
use semihosting::{println, process};

use count::Instructions;
use paint::Paint;

/// Runs all modes, first with instructions gauged, then with stack.
fn run() -> ! {
    match Instructions::checked() {
        Ok(instructions) => all("instructions", &instructions),
        Err(miscounted) => {
            println!("the loop of known length is counted as {miscounted} instructions");
            process::exit(1);
        }
    }
    all("stack", &Paint);
    process::exit(0)
}

fn all(gauged: &str, gauge: &impl Gauge) {
    let mut tell = |mode: &'static str, report: Result<Report, u32>| match report {
        Ok(Report {
            least,
            most,
            checksum,
            residual,
        }) => println!("{gauged} {mode} {least} {most} {checksum:016x} {residual:e}"),
        Err(step) => {
            println!("{mode}: step {step} fails");
            process::exit(1);
        }
    };
    modes::single(gauge, &mut tell);
    #[cfg(feature = "f64")]
    modes::double(gauge, &mut tell);
}

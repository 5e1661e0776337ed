//! The loop on a controller. What each mode takes is written to the debugger, a line a mode: what
//! was gauged, the mode, least and most, checksum and largest residual.
#![no_std]
#![no_main]

mod paint;
#[cfg_attr(target_arch = "arm", path = "arm.rs")]
#[cfg_attr(target_arch = "riscv64", path = "risc_v.rs")]
mod processor;

use core::arch::asm;

use controller::{Gauge, Report, modes};
use semihosting::{println, process};

use paint::Paint;

/// The instructions of [`processor::known_loop`] beyond those of [`nothing`].
const KNOWN: u32 = 3001;

/// Runs all modes, first with instructions gauged, then with stack.
fn run(instructions: &impl Gauge) -> ! {
    let ((), known) = instructions.gauge(processor::known_loop);
    if known != KNOWN {
        println!("a loop of {KNOWN} instructions is counted as {known}");
        process::exit(1);
    }
    all("instructions", instructions);
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

/// What a call takes by itself.
#[inline(never)]
fn nothing() {
    // SAFETY: it is no instruction, but a reason to make the call.
    unsafe { asm!("") }
}

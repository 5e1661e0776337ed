//! The loop on a controller: counts each mode's instructions and writes them to the debugger.
#![no_std]
#![no_main]

use controller::{Counter, Report, modes};
use semihosting::{println, process};

#[cfg(target_arch = "arm")]
#[path = "arm.rs"]
mod processor;
#[cfg(target_arch = "riscv64")]
#[path = "risc_v.rs"]
mod processor;

fn run(counter: &impl Counter) -> ! {
    let ((), counted) = counter.count(processor::known_loop);
    println!("known loop: {counted} of {}", processor::KNOWN);
    let mut failed = counted != processor::KNOWN;
    let mut tell = |mode: &'static str, report: Option<Report>| match report {
        Some(Report {
            least,
            most,
            checksum,
            residual,
            ..
        }) => println!("{mode} {least} {most} {checksum:016x} {residual:e}"),
        None => {
            println!("{mode}: a step fails");
            failed = true;
        }
    };
    modes::single(counter, &mut tell);
    #[cfg(feature = "f64")]
    modes::double(counter, &mut tell);
    process::exit(failed.into())
}

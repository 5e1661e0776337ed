//! Cortex-M boards of QEMU, started with `-icount shift=10`: an instruction takes 1024 ns, and
//! SysTick counts down every 40 ns.

use core::arch::asm;

use controller::Gauge;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::entry;

use crate::nothing;

const WIDTH: u32 = 0x00ff_ffff;

/// Counts instructions beyond those of a call of [`nothing`].
struct SysTick {
    of_nothing: u32,
}

impl SysTick {
    fn start(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(WIDTH);
        timer.clear_current();
        timer.enable_counter();
        let counter = Self { of_nothing: 0 };
        // The first one reads a timer that is not yet reloaded.
        let [_, of_nothing] = [(), ()].map(|()| counter.gauge(nothing).1);
        Self { of_nothing }
    }
}

impl Gauge for SysTick {
    #[inline(always)]
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32) {
        let before = SYST::get_current();
        let result = call();
        let after = SYST::get_current();
        let ticks = before.wrapping_sub(after) & WIDTH;
        // 25.6 ticks an instruction, rounded.
        (result, (ticks * 10 + 128) / 256 - self.of_nothing)
    }
}

#[inline(never)]
pub fn known_loop() {
    // SAFETY: changes one register and the flags.
    unsafe {
        asm!("movw {n}, #1000", "2:", "nop", "subs {n}, #1", "bne 2b", n = out(reg) _);
    }
}

#[inline(always)]
pub fn stack_pointer() -> usize {
    let address;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) address) }
    address
}

#[entry]
fn main() -> ! {
    match cortex_m::Peripherals::take() {
        Some(peripherals) => crate::run(&SysTick::start(peripherals.SYST)),
        None => semihosting::process::abort(),
    }
}

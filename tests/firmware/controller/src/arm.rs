//! Cortex-M boards of QEMU, started with `-icount shift=10`: an instruction takes 1024 ns, and
//! SysTick counts down every 40 ns.

use core::arch::asm;

use controller::Counter;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::entry;

const WIDTH: u32 = 0x00ff_ffff;

/// The instructions of [`known_loop`].
pub const KNOWN: u32 = 3001;

struct SysTick {
    /// What it takes to call a function that does [`nothing`].
    own: u32,
}

impl SysTick {
    fn start(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(WIDTH);
        timer.clear_current();
        timer.enable_counter();
        let ((), own) = Self { own: 0 }.count(nothing);
        Self { own }
    }
}

impl Counter for SysTick {
    #[inline(always)]
    fn count<R>(&self, work: impl FnOnce() -> R) -> (R, u32) {
        let before = SYST::get_current();
        let result = work();
        let after = SYST::get_current();
        let ticks = before.wrapping_sub(after) & WIDTH;
        // 25.6 ticks an instruction, rounded.
        (result, (ticks * 10 + 128) / 256 - self.own)
    }
}

#[inline(never)]
fn nothing() {
    // SAFETY: it is no instruction, but a reason to make the call.
    unsafe { asm!("") }
}

#[inline(never)]
pub fn known_loop() {
    // SAFETY: changes one register and the flags.
    unsafe {
        asm!("mov {n}, #1000", "2:", "nop", "subs {n}, #1", "bne 2b", n = out(reg) _);
    }
}

#[entry]
fn main() -> ! {
    match cortex_m::Peripherals::take() {
        Some(peripherals) => crate::run(&SysTick::start(peripherals.SYST)),
        None => unreachable!("taken once"),
    }
}

//! Cortex-M boards of QEMU, started with `-icount shift=10`: an instruction takes 1024 ns, and
//! SysTick counts down every 40 ns.

use core::arch::asm;

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::entry;

const WIDTH: u32 = 0x00ff_ffff;

#[inline(always)]
pub fn now() -> u32 {
    SYST::get_current()
}

/// 25.6 ticks each, to be rounded.
#[inline(always)]
pub fn instructions_between(before: u32, after: u32) -> u32 {
    let ticks = before.wrapping_sub(after) & WIDTH;
    (ticks * 10 + 128) / 256
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
    if let Some(peripherals) = cortex_m::Peripherals::take() {
        let mut timer = peripherals.SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(WIDTH);
        timer.clear_current();
        timer.enable_counter();
    }
    crate::run()
}

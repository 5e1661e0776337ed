//! The RISC-V board of QEMU, started with `-icount shift=0`: the counter of retired instructions
//! counts each once.

use core::arch::asm;

use controller::Gauge;
use riscv_rt::entry;

use crate::nothing;

/// Counts instructions beyond those of a call of [`nothing`].
struct Retired {
    of_nothing: u32,
}

impl Retired {
    #[inline(always)]
    fn so_far() -> u32 {
        let count: usize;
        // SAFETY: reads a counter.
        unsafe { asm!("csrr {}, minstret", out(reg) count) }
        count as u32
    }
}

impl Gauge for Retired {
    #[inline(always)]
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32) {
        let before = Self::so_far();
        let result = call();
        let taken = Self::so_far().wrapping_sub(before);
        (result, taken - self.of_nothing)
    }
}

#[inline(never)]
pub fn known_loop() {
    // SAFETY: changes one register.
    unsafe {
        asm!("li {n}, 1000", "2:", "nop", "addi {n}, {n}, -1", "bnez {n}, 2b", n = out(reg) _);
    }
}

#[inline(always)]
pub fn stack_pointer() -> usize {
    let address;
    // SAFETY: reads a register.
    unsafe { asm!("mv {}, sp", out(reg) address) }
    address
}

#[entry]
fn main() -> ! {
    let (_, of_nothing) = Retired { of_nothing: 0 }.gauge(nothing);
    crate::run(&Retired { of_nothing })
}

//! The RISC-V board of QEMU, started with `-icount shift=0`: the counter of retired instructions
//! counts each once.

use core::arch::asm;

use riscv_rt::entry;

#[inline(always)]
pub fn now() -> u32 {
    let count: usize;
    // SAFETY: reads a counter.
    unsafe { asm!("csrr {}, minstret", out(reg) count) }
    count as u32
}

#[inline(always)]
pub fn instructions_between(before: u32, after: u32) -> u32 {
    after.wrapping_sub(before)
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
    crate::run()
}

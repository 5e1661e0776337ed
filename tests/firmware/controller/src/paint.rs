//! The stack that a call takes: painted before, searched for the first fleck after.

use controller::Gauge;

use crate::processor::stack_pointer;

/// More than any call takes.
const WORDS: usize = 4096;
const COLOUR: usize = 0x5eed_5eed;

pub struct Paint;

impl Gauge for Paint {
    #[inline(always)]
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32) {
        let end = stack_pointer() as *mut usize;
        let start = end.wrapping_sub(WORDS);
        // SAFETY: below the stack pointer there is free memory, and no interrupt that would use it.
        unsafe {
            for word in 0..WORDS {
                start.add(word).write_volatile(COLOUR);
            }
            let result = call();
            let untouched =
                (0..WORDS).take_while(|word| start.add(*word).read_volatile() == COLOUR);
            let touched = WORDS - untouched.count();
            (result, (touched * size_of::<usize>()) as u32)
        }
    }
}

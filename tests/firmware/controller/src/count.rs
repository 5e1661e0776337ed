//! The instructions that a call takes.

use core::arch::asm;

use controller::Gauge;

use crate::processor;

/// The instructions of [`processor::known_loop`] beyond those of [`nothing`].
const KNOWN: u32 = 3001;

/// Counts instructions beyond those of a call of [`nothing`].
pub struct Instructions {
    of_nothing: u32,
}

impl Instructions {
    /// Returns the counter, or its result for [`KNOWN`] instructions if that is wrong.
    pub fn checked() -> Result<Self, u32> {
        let plain = Self { of_nothing: 0 };
        // The first reading may find the processor's counter not yet started.
        called(&plain, nothing);
        let counter = Self {
            of_nothing: called(&plain, nothing),
        };
        match called(&counter, processor::known_loop) {
            KNOWN => Ok(counter),
            miscounted => Err(miscounted),
        }
    }
}

impl Gauge for Instructions {
    #[inline(always)]
    fn gauge<R>(&self, call: impl FnOnce() -> R) -> (R, u32) {
        let before = processor::now();
        let result = call();
        let taken = processor::instructions_between(before, processor::now());
        (result, taken - self.of_nothing)
    }
}

/// The counted code around a call, which is the same for all calls.
#[inline(never)]
fn called(counter: &Instructions, call: fn()) -> u32 {
    counter.gauge(call).1
}

#[inline(never)]
fn nothing() {
    // SAFETY: it is no instruction, but a reason to make the call.
    unsafe { asm!("") }
}

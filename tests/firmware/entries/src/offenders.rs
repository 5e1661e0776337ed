//! Deliberate offenders, which the search must find.

extern crate alloc;

use alloc::boxed::Box;
use core::alloc::{GlobalAlloc, Layout};
use core::fmt::Write;
use core::ptr::null_mut;

struct NoHeap;

// SAFETY: it never hands out memory.
unsafe impl GlobalAlloc for NoHeap {
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        null_mut()
    }

    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static HEAP: NoHeap = NoHeap;

#[unsafe(no_mangle)]
extern "C" fn offender_panic(table: &[f32; 4], index: usize) -> f32 {
    table[index]
}

#[unsafe(no_mangle)]
fn offender_format(number: f32, text: &mut dyn Write) -> bool {
    write!(text, "{number}").is_ok()
}

#[unsafe(no_mangle)]
fn offender_allocation(number: f32) -> Box<f32> {
    Box::new(number)
}

#[unsafe(no_mangle)]
extern "C" fn offender_double(a: f64, b: f64) -> f64 {
    a * b
}

//! Every call of the solving path, instantiated for both linkages and both number types.
#![no_std]

#[cfg(feature = "assembly")]
mod assembly;
#[cfg(feature = "solving")]
mod baked;
#[cfg(feature = "solving")]
mod bounded;
#[cfg(feature = "solving")]
mod certificate;
#[cfg(feature = "construction")]
mod construction;
#[cfg(feature = "path")]
mod path;
#[cfg(feature = "series")]
mod series;
#[cfg(feature = "solving")]
mod solving;

#[panic_handler]
fn halt(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

/// What the search must find.
#[cfg(feature = "deliberate-panic")]
#[unsafe(no_mangle)]
extern "C" fn firmware_deliberate_panic(table: &[f32; 4], index: usize) -> f32 {
    table[index]
}

//! The counted calls; every call of the solving path, instantiated for both linkages and both number
//! types; and offenders that the search must find.
#![no_std]

extern crate controller;

mod offenders;
#[cfg(feature = "rooms")]
mod rooms;

#[panic_handler]
fn halt(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

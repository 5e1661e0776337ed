//! Listings of every kind compile, without a warning.
#![deny(warnings)]
// Modules are public as users write them.
#![allow(unreachable_pub)]

mod compiles {
    mod in_a_file;
    mod include;
    mod minimal;
    mod order_of_bodies;
}

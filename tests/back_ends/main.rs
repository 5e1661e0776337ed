//! Listings read at run time beside those that the macro compiles. A package of its own, since it takes longer
//! to optimise these tests than to run them as they are.

mod assembled;
mod at_a_lock;
mod back_ends;
mod car;
mod compiled;
#[path = "../counting/mod.rs"]
mod counting;
mod layouts;
mod no_alloc;
mod pivots;
mod pose;
mod random;
mod statics;
mod symmetric;
mod twins;
mod walked;

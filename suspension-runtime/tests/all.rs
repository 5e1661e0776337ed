//! One test program: the files beside this one are its modules. Allocations are counted
//! by thread, so that others may run beside what must make none.

mod back_ends;
mod committed;
#[path = "../../tests/counting/mod.rs"]
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

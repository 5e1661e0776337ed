//! One test program: the files beside this one are its modules.

mod back_ends;
mod committed;
mod layouts;
mod pivots;
mod pose;
mod random;
mod statics;
mod symmetric;
mod twins;
mod walked;

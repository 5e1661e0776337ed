//! One test program: the files beside this one are its modules.

mod back_ends;
mod committed;
mod pivots;
mod pose;
mod random;
mod symmetric;
mod twins;
mod walked;

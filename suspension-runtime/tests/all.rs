//! One test program: the files beside this one are its modules.

mod back_ends;
mod committed;
mod pose;
mod random;
mod twins;
mod walked;

//! All tests but one, as modules of one test program. The one that counts allocations stands alone.

mod cli;
mod failures;
mod reference;
#[path = "../../../tests/support/mod.rs"]
mod support;

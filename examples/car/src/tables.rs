//! The motion of both corners, baked:
//!
//! ```sh
//! cargo run --release -- bake examples/car/front.toml --drive bump=0.18:0.42 --drive steer=0.32:0.36 --tolerance 1e-5 --points all \
//!     --output examples/car/src/tables/front.rs
//! cargo run --release -- bake examples/car/rear.toml --drive bump=0.20:0.44 --tolerance 1e-5 --points all \
//!     --output examples/car/src/tables/rear.rs
//! ```

#[rustfmt::skip]
pub mod front;
#[rustfmt::skip]
pub mod rear;

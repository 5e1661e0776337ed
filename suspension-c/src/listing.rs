//! Listings from text: read, given hardpoints and moved. Names are looked up once.
//!
//! Only this part of the interface needs a standard library and, to make objects, the heap.

mod corner;
mod kind;
mod loads;
mod moving;
mod objects;
mod parsed;
mod placed;
mod row;
mod state;
mod text;

use crate::describe::{Interface, Shape, Structure};

pub use corner::{
    corner_add_masses, corner_advance, corner_destroy, corner_drives, corner_new,
    corner_read_derivatives, corner_read_kingpin, corner_read_kingpin_at, corner_read_loads,
    corner_read_measures, corner_read_points, corner_read_rotation, corner_read_rotation_at,
    corner_read_wheel, corner_read_wheel_at, corner_read_wheel_derivatives,
    corner_read_wheel_rates, corner_step, corner_time,
};
pub(crate) use kind::KINDS;
pub use kind::Kind;
pub use objects::{Corner, Listing};
pub use state::{corner_copy, corner_read_state, corner_set_state, corner_state_count};
pub use text::{
    listing_count, listing_design, listing_destroy, listing_find, listing_name, listing_parse,
};

const HANDLES: &[Structure] = &[
    Structure {
        name: "Listing",
        docs: &[" A parsed listing. It never changes: threads may share it."],
        shape: Shape::Handle,
    },
    Structure {
        name: "Corner",
        docs: &[" A suspension that moves: model, configuration, drives and time."],
        shape: Shape::Handle,
    },
];

/// The description from which the header is written.
pub const INTERFACE: Interface = Interface {
    prefix: "susp",
    number: "f64",
    docs: &[
        " Listings of a suspension from text, in the language of `linkage!` and motion files: parsed, placed at",
        " hardpoints and moved, in double. For hosted systems.",
        "",
        " Memory    `susp_listing_parse`, `susp_corner_new` and `susp_corner_copy` make objects on the heap, and the",
        "           functions `_destroy` free them. Each object may be freed only once; the library cannot check this.",
        "           No other function allocates or frees anything.",
        " Arrays    contain double in the order of the listing's names. Each is passed with its number of elements;",
        "           for a wrong number the result is SUSP_ERROR_SIZE. Points have x, y, z each. An array with rates",
        "           has all values, then all rates, per second, then all second rates, per second squared:",
        "           double points[3][POINTS][3], drives[3][DRIVES], measures[3][MEASURES].",
        " Units     are those of the listing: points in any unit of length, angles in rad, times in s.",
        " Panics    are defects of the library. They end the program and never unwind into C.",
    ],
    structures: &[HANDLES],
    functions: &[text::FUNCTIONS, corner::FUNCTIONS, state::FUNCTIONS],
};
